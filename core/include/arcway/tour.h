#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/text.h"
#include "arcway/vec2.h"

namespace arcway {

/// A pose to go to or, without a heading, a position at which any heading will do.
struct Place {
  Vec2 position;                                 ///< [m]
  std::optional<double> heading = std::nullopt;  ///< [rad]; none: any heading
};

/// From a start over waypoints to one of several goals, at rest at both.
struct TourRequest {
  Pose start;
  std::vector<Place> waypoints = {};  ///< passed in this order, without a stop unless the gear changes there
  std::vector<Place> goals;           ///< at least one; the tour ends at the one that is reached first
  bool reverse = false;               ///< see PlanRequest
  double cusp_cost = 0.0;             ///< see PlanRequest [s]
  /// Largest number of gear changes of each leg; none: any number. One more may happen at each waypoint.
  std::optional<std::uint32_t> max_gear_changes = std::nullopt;
};

/// The result of plan_tour.
struct Tour {
  /// The plan from the start to the goal reached. Counters and stage times are those of all plans tried. With several
  /// goals, waypoints or an open heading, the lower bound is that of straight lines to the nearest goal outside of all
  /// obstacles. Without a path, the plan's goal is the one that the reason names, else the first; an open heading is 0.
  PlanResult plan;
  std::size_t goal = 0;             ///< index of the goal reached
  std::vector<std::size_t> passed;  ///< for each waypoint, the number of segments that lead to it
};

/// The plan, and "to goal 1 over 3 waypoints" if it is solved.
ARCWAY_API std::string to_string(const Tour& tour);

/// Plans the fastest tour found from a start over waypoints to one of several goals. One goal with a heading and no
/// waypoints give the plan of Planner::plan.
///
/// 1. Legs between two poses are plans of `planner`, from rest to rest.
/// 2. Tours are compared by the time of all legs joined, which stop at waypoints only where the gear changes.
/// 3. A leg to several poses is the cheapest of the plans to each. Poses whose lower bounds rule them out are skipped.
/// 4. An open heading is chosen among 24. At the goal the best of them is then improved by halving steps, and compared
///    with going there straight.
/// 5. For each pose at a waypoint, the route that is cheapest if it ended there is kept.
///
/// A waypoint with an open heading takes up to 25 plans for each heading of the next place. Where there is a choice of
/// poses, plans grow no trees, as most have no path. If no pose is reached then, the legs not proved impossible are
/// planned with trees, in turn until one succeeds. These trees have twice the poses of one plan in all.
///
/// With a time limit or a stop token, a tour by the first pose reached at each place comes before all that. It is the
/// result if it is the best one when time is over.
///
/// A tour without a path is no error: see PlanResult::status. Status and reason name leg and place as they were
/// requested.
/// @param limits  for all plans together.
/// @throws std::invalid_argument without a goal, and as Planner::plan does.
ARCWAY_API Tour plan_tour(const Planner& planner, const TourRequest& request, const PlanLimits& limits = {});

}  // namespace arcway
