#pragma once

#include <optional>

#include "accel/embree/embree_options.h"
#include "arcway/query_set.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

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

/// The queries of a world after a change, in time that depends on the change only; nothing if they are to be made anew.
/// They share the scenes of the queries before, pass over removed edges and look at added ones one by one. That is
/// refused for queries of another kind, and once more than some hundred edges were added since the scenes were built,
/// or one outside of the map's box.
/// @param before  of the world before the change.
std::optional<QuerySet> change_embree_queries(const QuerySet& before, const World& after, const WorldChange& change);

}  // namespace arcway::internal
