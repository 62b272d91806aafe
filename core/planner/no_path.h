#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "arcway/planner.h"
#include "core/attach/roadmap.h"
#include "core/gaps/dead_end.h"
#include "core/gaps/enclosure.h"
#include "core/search/forward_search.h"
#include "core/search/tree_search.h"

namespace arcway::internal {

/// What searches and proofs found out about a query that has no path.
struct NoPath {
  Obstruction obstruction = Obstruction::kNothing;
  std::optional<DeadEnd> dead_end = {};
  std::optional<Enclosure> enclosure = {};
  std::optional<TreesEnd> trees = {};
  bool reverse = false;  ///< whether reversing was allowed
  std::optional<std::uint32_t> max_gear_changes = {};
};

/// Whether the body is free at the start, or at the goal. If not, fills in status and reason.
bool pose_is_free(const Roadmap& map, const Pose& pose, bool start, PlanResult& result);

/// Whether the speed at an end is within the limits of the zones there. If not, the result says which one is exceeded.
bool end_speed_obeys_zones(const Roadmap& map, const Pose& pose, bool start, PlanResult& result);

/// Whether zones allow to leave the start, or to reach the goal, in a gear that the request allows. If not, the result
/// names the zone. Where start and goal are one pose, no motion is needed.
bool end_heading_obeys_zones(const Roadmap& map, const PlanRequest& request, bool start, PlanResult& result);

/// The reason for a plan without a path where the time was up.
/// @param limits  as the caller gave them.
std::string time_limit_reason(const PlanLimits& limits);

/// Fills in status and reason of a plan that was ended before it found a path.
/// @param limits  as the caller gave them.
void explain_interruption(const PlanLimits& limits, PlanResult& result);

/// Fills in status and reason of a plan without a path, from what its result holds so far.
void explain(const Roadmap& map, const NoPath& why, const PlanLimits& limits, PlanResult& result);

}  // namespace arcway::internal
