#pragma once

#include "accel/embree/embree_options.h"
#include "arcway/query_set.h"
#include "arcway/world.h"

namespace arcway::internal {

/// All queries of core on Embree; accel_backend gives them to its planners. Embree proposes obstacle edges in single
/// precision, and core's exact tests decide. Every answer equals that of make_reference_queries, bit for bit.
///
/// Builds two scenes of the world's edges, O(n log n) on the threads of the caller's arena. They keep about 250 bytes
/// an edge, 50 to 80 in worlds of more than 100,000 edges. A query takes about O(log n + edges near by), from any
/// number of threads. Points further from the map than 2^20 times its size cost O(n).
/// @throws std::runtime_error if Embree cannot be started; std::invalid_argument for a width that is negative or not
///   finite.
QuerySet make_embree_queries(const World& world, const EmbreeOptions& options = {});

}  // namespace arcway::internal
