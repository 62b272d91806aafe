#pragma once

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// The builders of the reduced visibility graph; their graphs are equal.
enum class GraphBuilder {
  kPairwise,     ///< accel/graphs/pairwise_graph.h
  kTangentCones  ///< accel/graphs/wedge_graph.h
};
/// "pairwise", "wedge".
ARCWAY_API const char* name_of(GraphBuilder builder);

/// The builder that is the faster one for a world, as measured (accel/README.md). Walks through wedges are, whatever
/// the number and the shape of the obstacles, up to 2^28 vertices; larger worlds are left to the pairwise one. O(1).
ARCWAY_API GraphBuilder faster_graph_builder(const World& world);

}  // namespace arcway
