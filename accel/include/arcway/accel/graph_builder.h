#pragma once

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// Builders of the reduced visibility graph; their graphs are equal.
enum class GraphBuilder {
  kPairwise,     ///< a line of sight, by Embree, for each pair of vertices that is tangent at both
  kTangentCones  ///< tangent-cone expansion through a triangulation of the free space: tangent_cone_graph.h
};
/// The builder in words: "pairwise" or "tangent-cones".
ARCWAY_API const char* name_of(GraphBuilder builder);

/// The faster builder for a world, as measured (accel/README.md). Tangent-cone expansion is faster for any number and
/// shape of obstacles, up to 2^28 vertices; larger worlds get the pairwise builder. O(1).
ARCWAY_API GraphBuilder faster_graph_builder(const World& world);

}  // namespace arcway
