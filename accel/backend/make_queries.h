#pragma once

#include "accel/embree/embree_options.h"
#include "arcway/query_set.h"
#include "arcway/world.h"

namespace arcway::internal {

/// All queries of core on Embree. Embree proposes obstacle edges in single precision, core's exact tests decide: every
/// answer is that of make_reference_queries, bit for bit.
///
/// accel_backend makes its planners with them.
///
/// Builds two scenes of the world's edges, O(n log n) on the threads of the caller's arena. They keep about 250 bytes
/// an edge, 50 to 80 in worlds of more than 100,000 edges. Queries are then about O(log n + edges near by), from any
/// number of threads. Points further from the map than 2^20 times its size cost O(n).
/// @throws std::runtime_error if Embree cannot be started; std::invalid_argument for a width that is negative or not
///   finite.
QuerySet make_embree_queries(const World& world, const EmbreeOptions& options = {});

}  // namespace arcway::internal
