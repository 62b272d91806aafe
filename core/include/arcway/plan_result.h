#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arcway/bottleneck.h"
#include "arcway/clearance_preference.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/text.h"
#include "arcway/trajectory.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// How a query ended. core/README.md has one table of all statuses and exceptions, with what to do about each.
enum class PlanStatus {
  kSolved,
  kStartInCollision,  ///< the body grown by half of the safety margin touches an obstacle at the start
  kGoalInCollision,
  kStartOutsideBounds,
  kGoalOutsideBounds,
  /// No motion that was tried leads far from the start. PlanResult::certainty says whether that is proved. If the goal
  /// is in a dead end too, the reason says so. With `reverse`, this status is given only where it is proved. It is also
  /// that of a start within a zone that forbids its speed, or each direction of motion that its heading has.
  kStartBlocked,
  kGoalBlocked,            ///< no motion that was tried leads to the goal from afar; as kStartBlocked otherwise
  kWaypointInCollision,    ///< of a tour: as kStartInCollision, at a waypoint
  kWaypointOutsideBounds,  ///< of a tour
  kWaypointBlocked,        ///< of a tour: no motion leads to a waypoint, or on from it
  kNoPassage,              ///< proved: no gap is wide enough for the body, in any direction of travel
  kNoPath,                 ///< no path was found, and none is proved not to exist
  kConflict,               ///< of evading_plan: no motion that was tried avoids the moving obstacles
  kTimeLimit,              ///< the time limit ended the search before it found a path
  kCanceled                ///< a stop was requested before a path was found
};
/// The status in words: "solved", "start in collision", ...
ARCWAY_API const char* name_of(PlanStatus status);
inline std::string to_string(PlanStatus status) { return name_of(status); }

/// Whether a query without a path proves that there is none.
enum class Certainty {
  kProved,  ///< no path exists: the body collides in a pose, no gap is wide enough, or an end is a dead end
  kGaveUp   ///< nothing that was tried leads there, or the time was up; a path may exist
};
/// The certainty in words: "proved" or "gave up".
ARCWAY_API const char* name_of(Certainty certainty);
inline std::string to_string(Certainty certainty) { return name_of(certainty); }

/// Counters and stage times of one query.
struct ARCWAY_API PlanStatistics {
  std::uint64_t nodes_expanded = 0;       ///< arrivals taken from the open list
  std::uint64_t nodes_pushed = 0;         ///< arrivals put on the open list
  std::uint64_t straights_checked = 0;    ///< swept rectangles decided between start or goal and the graph
  std::uint64_t turns_checked = 0;        ///< sets of free headings computed on circles of start and goal
  std::uint64_t maneuver_poses = 0;       ///< poses tried by maneuvers at start and goal
  std::uint64_t tree_poses = 0;           ///< poses grown by trees of forward motions
  std::uint64_t refine_trials = 0;        ///< paths that refinement timed
  std::uint64_t refine_improvements = 0;  ///< trials that refinement kept
  double unrefined_travel_time = 0.0;     ///< of the plan's path before refinement [s]
  double first_travel_time = 0.0;         ///< of PlanResult::first_path [s]
  double first_path_seconds = 0.0;        ///< from the call until the first path was found [s]
  double suboptimality = 0.0;             ///< PlannerOptions::suboptimality that the searches used
  double search_seconds = 0.0;            ///< in graph searches, maneuvers and trees [s]
  double refine_seconds = 0.0;            ///< [s]
  double lower_bound_seconds = 0.0;       ///< [s]
  double profile_seconds = 0.0;           ///< for speed profile and clearance [s]
  double total_seconds = 0.0;             ///< from call to return [s]

  /// Adds the counters and stage times of another query, and keeps the larger suboptimality. Travel times,
  /// first_path_seconds and total_seconds stay.
  PlanStatistics& operator+=(const PlanStatistics& other);
};

/// What a plan was made for. Copies of a World share its data.
struct PlanScene {
  World world;
  Vehicle vehicle;
};

/// The answer to one query. Segments, times and lengths are empty or 0 unless it is solved.
struct ARCWAY_API PlanResult {
  PlanStatus status = PlanStatus::kNoPath;
  std::string reason;                        ///< unless solved: what failed, where, by which value and limit
  Certainty certainty = Certainty::kGaveUp;  ///< unless solved: whether that is proved
  Pose start, goal;                          ///< as requested
  double start_speed = 0.0;                  ///< as requested, negative backwards [m/s]
  double goal_speed = 0.0;                   ///< as requested [m/s]
  /// Whether the time limit or the stop token ended the query. The path, if any, is the best one found by then.
  bool interrupted = false;
  std::vector<TimedSegment> segments;
  double travel_time = 0.0;  ///< [s]
  double length = 0.0;       ///< [m]
  Path first_path;           ///< the first free path found, before refinement; empty for tours
  /// No path can take less [s]. It is travel_time_lower_bound of the straight line from start to goal, or of the
  /// shortest path of a point among the obstacles. The latter holds for a plan that is solved, if
  /// `point_robot_lower_bound` is set and the body covers the reference point.
  double lower_bound = 0.0;
  double min_clearance = 0.0;  ///< least distance of the bare body from obstacles along the path [m]; infinity in a
                               ///< world without obstacles
  /// Whether the clock was over before the clearance of the whole path was measured. `min_clearance` is then a lower
  /// bound: half of the safety margin, which the checks of the path prove, or less where less was measured. It belongs
  /// to no segment.
  bool clearance_is_lower_bound = false;
  PathSegment clearance_segment;    ///< the segment where the clearance is least
  std::size_t clearance_index = 0;  ///< its index
  /// What is driven closer to obstacles than PlannerOptions::clearance_preference; nothing without a preference.
  std::optional<CloseDriving> close_driving;
  /// What is driven in clearance zones closer to obstacles than they ask for: zones where that is more than nothing,
  /// ascending.
  std::vector<ZoneCloseDriving> close_in_zones;
  /// Unless solved: the narrowest gap of the widest route from start to goal. Nothing if that gap is wide enough for
  /// the tightest turn, or as wide as the room around start or goal, or if the query was interrupted.
  std::optional<Bottleneck> bottleneck;
  PlanStatistics statistics;
  /// The world and vehicle of the planner; null if no planner made the result. It shares the planner's data, and keeps
  /// the world alive.
  std::shared_ptr<const PlanScene> scene;
  /// What planning keeps down, but for PlanRequest::cusp_cost: the travel time, plus the cost of driving close [s].
  [[nodiscard]] double cost() const;
  /// By which share the plan may be slower than the best one at most: travel_time / lower_bound - 1, or 0 if the plan
  /// takes no time.
  [[nodiscard]] double optimality_gap() const { return travel_time > 0.0 ? travel_time / lower_bound - 1.0 : 0.0; }
  [[nodiscard]] bool solved() const { return status == PlanStatus::kSolved; }
  [[nodiscard]] Path path() const;  ///< the segments without speeds
  /// The segments with speeds and durations, as the validator takes them.
  [[nodiscard]] TimedPath timed_path() const;
  /// The plan in time: poses and speeds at any moment. See Trajectory for what it throws.
  [[nodiscard]] Trajectory trajectory() const { return Trajectory(*this); }
};

/// "solved: 5.812 s, 3 segments, 66.2 m, 0 gear changes, at most 3.2 % slower than the fastest path", or the status,
/// the certainty and the reason.
ARCWAY_API std::string to_string(const PlanResult& result);

}  // namespace arcway
