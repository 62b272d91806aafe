#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/vec2.h"

namespace arcway {

/// Where to: a pose or, without a heading, a position at which any heading will do.
struct Place {
  Vec2 position;
  std::optional<double> heading = std::nullopt;  ///< [rad]
};

struct TourRequest {
  Pose start;
  std::vector<Place> waypoints = {};  ///< passed in this order, without a stop
  std::vector<Place> goals;           ///< to one of them, whichever is reached first; at least one
  bool reverse = false;               ///< as in PlanRequest
  double cusp_cost = 0.0;             ///< as in PlanRequest [s]
  /// As in PlanRequest, of each leg; at each waypoint there may be one more.
  std::optional<std::uint32_t> max_gear_changes = std::nullopt;
};

struct Tour {
  /// From the start to the goal reached, by way of all places. Counters and stage times are those of all plans that
  /// were tried. With several goals, waypoints or an open heading the lower bound is that of the straight
  /// lines to the nearest goal outside of all obstacles. Without a path its goal is the one that the reason is about,
  /// else the first, an open heading being 0.
  PlanResult plan;
  std::size_t goal = 0;             ///< index of the goal reached
  std::vector<std::size_t> passed;  ///< for each waypoint, how many segments lead to it
};

/// The fastest way found by places to one of several goals.
///
/// Legs between two poses are plans of `planner`, from rest to rest; the whole is driven without a stop at the places
/// on its way but where the gear changes, and is what is compared. One leg to several poses is the least of the plans
/// to each, those left out that cannot be it by their lower bounds. An open heading is chosen from 24 that are tried
/// and, at the goal, improved from the best of them on, by halving steps and by going straight there: no slower than
/// with any heading tried. Of each pose at a waypoint the way there is kept that costs least if it ends there.
/// A waypoint with an open heading takes up to 25 plans for each heading of the next place.
/// Where there is a choice of poses, plans grow no trees, as most have no path. If that leads to none of the poses,
/// legs that are not proved to be none are looked for with trees of twice the poses of one plan in all, until one is
/// found.
///
/// One goal with a heading and nothing on the way gives the plan that Planner::plan gives. Never throws for want of a
/// path: see PlanResult::status; status and reason name leg and places as they were asked for.
/// @param limits  for all plans together.
/// @throws std::invalid_argument without a goal, and as Planner::plan does.
ARCWAY_API Tour plan_tour(const Planner& planner, const TourRequest& request, const PlanLimits& limits = {});

}  // namespace arcway
