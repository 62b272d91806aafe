#pragma once

#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The builders of the reduced visibility graph; their graphs are equal.
enum class GraphBuilder {
  kPairwise,  ///< accel/graphs/pairwise_graph.h
  kWedge      ///< accel/graphs/wedge_graph.h
};
/// "pairwise", "wedge".
const char* name_of(GraphBuilder builder);

/// The builder that is the faster one for a world, as measured (accel/README.md). Walks through wedges are, whatever
/// the number and the shape of the obstacles, up to 2^28 vertices; larger worlds are left to the pairwise one. O(1).
GraphBuilder faster_graph_builder(const World& world);

}  // namespace arcway
