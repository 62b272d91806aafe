#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/world.h"

namespace arcway {

/// Up to `count` plans that take different ways, the cheapest first: any two pass at least one obstacle on different
/// sides, see same_route. That of Planner::plan is one of them: the first, unless another way turns out to be cheaper;
/// the only one without a path.
///
/// Further ones come from plans that may not use some of the passages of those before: in a passage of a path, where
/// obstacles are nearest on both of its sides, a wall is put across, and the whole is planned again [Lawler 1972].
/// Up to ten such ways for each alternative are compared by one search and its refinement; the cheapest is planned as
/// Planner::plan does. There may be other ways that are faster than the last ones. Takes some two to three plans for
/// each alternative, and a dozen lazy feasible graphs, whose checks are shared. These plans grow no trees, so that
/// ways that only trees find are not among them, but for the first.
/// @param limits  for all plans together; plans found by then are given.
/// @throws std::invalid_argument if `count` is 0, and as Planner::plan does.
ARCWAY_API std::vector<PlanResult> plan_alternatives(const Planner& planner, const PlanRequest& request,
                                                     std::size_t count, const PlanLimits& limits = {});

/// Whether two paths with the same ends pass every obstacle on the same side: the reference point, there by one and
/// back by the other, winds round none. Neither may touch an obstacle. O(segments * obstacles).
ARCWAY_API bool same_route(std::span<const PathSegment> a, std::span<const PathSegment> b, const World& world);

}  // namespace arcway
