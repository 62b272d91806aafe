#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/process_group.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway {

/// Work done by the tangent-cone builder; the counters explain its time.
struct TangentConeStatistics {
  std::uint64_t triangles = 0;        ///< triangles of free space
  std::uint64_t steps = 0;            ///< triangles entered by expansions, without those around the start
  std::uint64_t candidates = 0;       ///< edges tested against invalid regions
  std::uint64_t invalid_regions = 0;  ///< regions that lost a piece where they cross another one
};

/// The reduced visibility graph without testing pairs, by tangent-cone expansion. It equals that of core's
/// build_reduced_visibility_graph, bit for bit, for any executor.
///
/// A sweep triangulates free space. From each convex vertex, an expansion through the triangles follows its two tangent
/// cones as far as they are visible. Exact for every world.
///
/// O(n log n + s) for s steps of the expansions; in clutter both grow with n. Regions that cross others cost more: what
/// is seen past them is tested against their edges one by one.
/// @param statistics     receives the counters; may be null.
/// @param process_group  processes that build the same graph: each triangulates, expands a share of the vertices and
///   gets the whole graph.
/// @throws std::length_error beyond 2^28 vertices.
ARCWAY_API VisibilityGraph build_reduced_visibility_graph_by_tangent_cones(
    const World& world, const Executor& executor = SerialExecutor(), TangentConeStatistics* statistics = nullptr,
    const ProcessGroup& process_group = SingleProcess());

}  // namespace arcway
