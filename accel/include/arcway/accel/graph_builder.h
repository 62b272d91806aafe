#pragma once

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// Builders of the reduced visibility graph; their graphs are equal.
enum class GraphBuilder {
  kPairwise,     ///< accel/graphs/pairwise_graph.h
  kTangentCones  ///< accel/graphs/tangent_cone_graph.cpp
};
/// "pairwise", "tangent-cones".
ARCWAY_API const char* name_of(GraphBuilder builder);

/// The faster builder for a world, as measured (accel/README.md). Tangent-cone expansion is faster for any number and
/// shape of obstacles, up to 2^28 vertices; larger worlds get the pairwise builder. O(1).
ARCWAY_API GraphBuilder faster_graph_builder(const World& world);

}  // namespace arcway
