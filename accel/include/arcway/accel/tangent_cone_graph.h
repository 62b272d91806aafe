#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/process_group.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway {

/// What the tangent-cone builder did; the counters explain its time.
struct TangentConeStatistics {
  std::uint64_t triangles = 0;        ///< of free space
  std::uint64_t steps = 0;            ///< triangles entered on walks, without those around the start
  std::uint64_t candidates = 0;       ///< edges tested against regions that are not whole
  std::uint64_t invalid_regions = 0;  ///< regions that lost a piece where they cross another
};

/// The same graph as core's build_reduced_visibility_graph, bit for bit, for any executor, without testing pairs: a
/// sweep triangulates free space, and from each convex vertex a walk through the triangles follows its two tangent
/// wedges as far as it can see. Exact for every world.
///
/// O(n log n + s) for s steps of the walks; in clutter both grow with n. Regions that cross others cost more: what is
/// seen past them is tested against their edges one by one.
/// @param process_group  builds the same graph: each process triangulates, walks from a share of the vertices and gets
///   the whole graph.
/// @throws std::length_error beyond 2^28 vertices.
ARCWAY_API VisibilityGraph build_reduced_visibility_graph_by_tangent_cones(
    const World& world, const Executor& executor = SerialExecutor(), TangentConeStatistics* statistics = nullptr,
    const ProcessGroup& process_group = SingleProcess());

}  // namespace arcway
