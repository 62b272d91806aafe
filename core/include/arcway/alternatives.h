#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/world.h"

namespace arcway {

/// Up to `count` plans on different routes, the cheapest first. Two routes differ if they pass at least one obstacle on
/// different sides, see same_route. The plan of Planner::plan is among them, and is the first unless another route
/// turns out cheaper. If there is no path, that plan alone is returned.
///
/// Further routes are found by blocking gaps of the routes known [Lawler 1972]:
/// 1. A gap of a path is a place where obstacles are nearest on both of its sides.
/// 2. A wall is put across one gap, and the map is planned on again.
/// 3. Up to ten such routes for each alternative are compared by one search and its refinement.
/// 4. The cheapest is planned as Planner::plan does.
///
/// There may be other routes that are faster than the last ones returned. Only the first plan may use trees of forward
/// motions. Cost: two to three plans for each alternative, and a dozen lazy feasible graphs whose checks are shared.
/// @param limits  for all plans together; the plans found by then are returned.
/// @throws std::invalid_argument if `count` is 0, and as Planner::plan does.
ARCWAY_API std::vector<PlanResult> plan_alternatives(const Planner& planner, const PlanRequest& request,
                                                     std::size_t count, const PlanLimits& limits = {});

/// Whether two paths between the same poses pass every obstacle on the same side. They do if the closed curve, there by
/// one path and back by the other, has winding number 0 around every obstacle: the paths are homologous. O(segments *
/// obstacles).
/// @param a, b  paths of the reference point that touch no obstacle.
ARCWAY_API bool same_route(std::span<const PathSegment> a, std::span<const PathSegment> b, const World& world);

}  // namespace arcway
