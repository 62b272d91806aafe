#pragma once

#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The builders of the reduced visibility graph; their graphs are equal.
enum class GraphBuilder {
  kPairwise,  ///< accel/pairwise_graph.h
  kWedge      ///< accel/wedge/wedge_graph.h
};
/// "pairwise", "wedge".
const char* name_of(GraphBuilder builder);

/// The builder that is the faster one for a world, by measured crossover. Walks through wedges are faster from a dozen
/// vertices on, whatever the shape, but for few convex obstacles of thousands of vertices each: there every ray grazes
/// its own obstacle, while binary search finds the tangents of a pair at once. See accel/README.md. O(vertices).
GraphBuilder faster_graph_builder(const World& world);

}  // namespace arcway
