#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/backend.h"
#include "arcway/bottleneck.h"
#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/graph_mode.h"
#include "arcway/heuristic.h"
#include "arcway/path.h"
#include "arcway/prepared_graph.h"
#include "arcway/process_group.h"
#include "arcway/query_set.h"
#include "arcway/refine_options.h"
#include "arcway/time_model.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway {

namespace internal {
class FeasibleGraph;
}

struct PlannerOptions {
  Heuristic heuristic = Heuristic::kTravelTime;
  TimeModel time_model = TimeModel::kProfile;  ///< of searches
  /// w, from 0 to 1e6: before refinement, a path by single arcs may take up to 1 + w times as long as the fastest one
  /// of the graph, and is found with fewer expansions; see search_arrivals. Empty: 0, and kLargeMapSuboptimality on
  /// maps of more than kExactVertices convex vertices, where the proof that no other path is faster takes most of a
  /// query.
  std::optional<double> suboptimality = std::nullopt;
  static constexpr std::size_t kExactVertices = 250'000;
  static constexpr double kLargeMapSuboptimality = 0.025;
  /// Of the feasible graph; plans are the same, bit for bit. Empty: lazy with a backend that has lazy rows, where a
  /// first query then need not wait for whole graphs; else eager. For many queries on one map kEager costs less in all.
  std::optional<GraphMode> graph_mode = std::nullopt;
  /// Turning radii of the turn circles [m], each from the vehicle's smallest to kLargestVehicleNumber; empty:
  /// turning_radii(vehicle, world).
  /// If there are wider ones than those of tightest_radii, a path with these alone is looked for as well, and the
  /// faster one is taken, so that wider turns hardly ever make a plan slower; so are some others.
  std::vector<double> radii = {};
  /// Poses tried from start and goal by short maneuvers of several arcs when single arcs reach no graph; four times as
  /// many sparse ones where both ends reach it but not each other, a few where the gap is large. 0: no maneuvers, and
  /// none of the trees of PlanLimits. At most kMostManeuverPoses; some 300 bytes each, and beside that 65,536
  /// straights to the graph at each end, or half as many as vertices where those are more, of some 60 bytes.
  std::uint32_t maneuver_poses = 400;
  static constexpr std::uint32_t kMostManeuverPoses = 1'000'000;
  /// Where single arcs find no path, or the plan may be 5 % slower than the best one (10 % without refinement, or with
  /// several radii), the graph with more circles in narrow places is searched as well: see find_gap_circles. It is made
  /// when the first query needs it, or by Planner::warm_up. On maps of at most 50,000 vertices: beyond that a query
  /// without a path would take seconds.
  bool gap_circles = true;
  /// Lower bounds count the way round the obstacles: PlanResult::lower_bound.
  bool point_robot_lower_bound = true;
  /// Of each path found; `max_trials = 0` turns it off. With wider radii than the tightest there are up to some
  /// fifty times as many in all.
  RefineOptions refinement = {};
  /// Processes that build the same eager feasible graph together; used during construction only, and not part of
  /// Planner::options. None: this one alone.
  const ProcessGroup* process_group = nullptr;
};

struct PlanRequest {
  Pose start;
  Pose goal;
  bool reverse = false;    ///< may drive backwards as well
  double cusp_cost = 0.0;  ///< of a change of gear, beside the time that stopping takes; no part of travel times [s]
  /// Only paths with at most so many changes of gear are of interest; none: any number.
  std::optional<std::uint32_t> max_gear_changes = std::nullopt;
};

/// When to end a plan before it is done, which then gives the best path found by then, if any; and what it may take.
/// Every stage of a query asks for both ends within a millisecond or so. What follows them, the speeds and the
/// clearance of the path, takes at most 2 ms and a twentieth of the time limit more.
struct ARCWAY_API PlanLimits {
  double time = std::numeric_limits<double>::infinity();  ///< from the call on [s]
  std::stop_token stop = {};                              ///< asked from any thread
  /// On a lazy graph another thread runs ahead of a search that is long, and finds what it will ask for: the same plan,
  /// bit for bit, in some two thirds of the time where a core is free. FeasibleGraph::counts then differs from run to
  /// run.
  bool prefetch = false;
  /// Poses that trees of forward motions grow, in all, where nothing else finds a path, see search_trees; none with
  /// PlannerOptions::maneuver_poses = 0. A twentieth to some tenths of a millisecond each; fewer where very many edges
  /// are near. 0: no trees.
  std::uint32_t tree_poses = 16'000;
};

enum class PlanStatus {
  kSolved,
  kStartInCollision,  ///< the body grown by half of the safety margin touches an obstacle at the start
  kGoalInCollision,
  kStartOutsideBounds,
  kGoalOutsideBounds,
  /// No motion tried leads far from the start; see PlanResult::certainty for whether that is proved. If the goal is
  /// hemmed in as well, the reason says so. With `reverse` only where it is proved.
  kStartBlocked,
  kGoalBlocked,            ///< no motion tried leads to the goal from afar; likewise
  kWaypointInCollision,    ///< of a tour: as at a start or goal, at a waypoint
  kWaypointOutsideBounds,  ///< of a tour
  kWaypointBlocked,        ///< of a tour: no motion leads on from a waypoint, or to it
  kNoPassage,              ///< proved: no passage is wide enough for the body, whichever way it is driven
  kNoPath,                 ///< nothing that was tried joins start and goal
  kTimeLimit,              ///< the time limit ended the search before it found a path
  kCanceled                ///< the stop token did
};
/// "solved", "start in collision", ...
ARCWAY_API const char* name_of(PlanStatus status);

/// What it is worth that a plan has no path.
enum class Certainty {
  kProved,  ///< there is none: of the body in a pose, through a passage, or out of a dead end without reversing
  kGaveUp   ///< nothing that was tried leads there, or the time was up: there may be one
};
/// "proved", "gave up".
ARCWAY_API const char* name_of(Certainty certainty);

struct TimedSegment {
  PathSegment segment;
  double speed_in = 0.0;   ///< [m/s]
  double speed_out = 0.0;  ///< [m/s]
  double duration = 0.0;   ///< [s]
};

/// Counters and stage times of one query.
struct ARCWAY_API PlanStatistics {
  std::uint64_t nodes_expanded = 0;       ///< arrivals taken from the open list
  std::uint64_t nodes_pushed = 0;         ///< arrivals put on it
  std::uint64_t straights_checked = 0;    ///< swept rectangles of starts and goals decided
  std::uint64_t turns_checked = 0;        ///< heading sets of starts and goals computed
  std::uint64_t maneuver_poses = 0;       ///< poses of start and goal maneuvers tried
  std::uint64_t tree_poses = 0;           ///< those of trees of forward motions
  std::uint64_t refine_trials = 0;        ///< paths that refinement tried
  std::uint64_t refine_improvements = 0;  ///< those of them that it took
  double unrefined_travel_time = 0.0;     ///< of the path before refinement [s]
  double first_travel_time = 0.0;         ///< of `first_path` [s]
  double first_path_seconds = 0.0;        ///< until that was found, of total_seconds
  double suboptimality = 0.0;             ///< that the searches were allowed: PlannerOptions::suboptimality
  double search_seconds = 0.0;
  double refine_seconds = 0.0;
  double lower_bound_seconds = 0.0;  ///< lower bound
  double profile_seconds = 0.0;      ///< speed profile and clearance
  double total_seconds = 0.0;

  /// Adds the counters and the stages' times of another query; travel times and total_seconds stay, and of both
  /// suboptimalities the larger one.
  PlanStatistics& operator+=(const PlanStatistics& other);
};

struct ARCWAY_API PlanResult {
  PlanStatus status = PlanStatus::kNoPath;
  std::string reason;                        ///< in words, with the condition that failed and where, unless solved
  Certainty certainty = Certainty::kGaveUp;  ///< of the status, unless solved
  Pose start, goal;                          ///< as requested
  /// The search or the refinement was ended by the time limit or the stop token: the path, if any, is the best one
  /// found by then.
  bool interrupted = false;
  std::vector<TimedSegment> segments;
  double travel_time = 0.0;  ///< [s]
  double length = 0.0;       ///< [m]
  Path first_path;           ///< the first one found, as free, before refinement; none for tours
  /// No path can take less [s]: travel_time_lower_bound with the length of the straight line; if solved,
  /// `point_robot_lower_bound` is set and the body covers the reference point, with that of a point's shortest path
  /// among the obstacles.
  double lower_bound = 0.0;
  double min_clearance = 0.0;  ///< of the bare body along the path [m]; infinity in a world without obstacles
  /// The time was over before the clearance of the whole path was measured: `min_clearance` is what the checks of the
  /// path prove, half of the safety margin, or less where less was measured; it belongs to no segment.
  bool clearance_is_lower_bound = false;
  PathSegment clearance_segment;  ///< the segment where that is
  std::size_t clearance_index = 0;
  /// Unless solved: the narrowest place of the widest way from start to goal. Nothing if that is wide enough for the
  /// tightest turn, or as wide as the room around start or goal; or if the search was interrupted.
  std::optional<Bottleneck> bottleneck;
  PlanStatistics statistics;
  /// By how much the plan may be slower than the best one at most: travel_time / lower_bound - 1; 0 for no time.
  [[nodiscard]] double optimality_gap() const { return travel_time > 0.0 ? travel_time / lower_bound - 1.0 : 0.0; }
  [[nodiscard]] bool solved() const { return status == PlanStatus::kSolved; }
  [[nodiscard]] Path path() const;
  /// With its speeds, for the validator.
  [[nodiscard]] TimedPath timed_path() const;
};

/// What it took to prepare a map.
struct PrepareStatistics {
  double visibility_seconds = 0.0;
  double feasible_seconds = 0.0;
  FeasibleGraphCounts counts;
};

/// Plans on one map for one vehicle: builds the reduced and the feasible visibility graph once, then answers any number
/// of queries.
///
///     const Planner planner(world, Vehicle{});
///     const PlanResult result = planner.plan({.start = {1, 1, 0}, .goal = {50, 40, kPi / 2}});
///     if (!result.solved()) return report(result.reason);
///     for (const TimedSegment& s : result.segments) drive(s);
///
/// Everything is copied or shared: no argument need outlive the call. `plan` is const and may be called from many
/// threads at once.
class ARCWAY_API Planner {
 public:
  /// By brute force, see reference_backend.
  Planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options = {});
  /// @param backend  of `world`. Its executor is used during construction only: a StoppableExecutor makes that
  ///   cancelable, a ReportingExecutor tells how far it is.
  /// @throws std::invalid_argument if an option is out of its range, the backend is of another world, or the safety
  /// margin is too small. It is, below 2^20 units in the last place of the largest of the map's coordinates, the body
  /// and its smallest turning radius.
  Planner(const World& world, const Vehicle& vehicle, const Backend& backend, const PlannerOptions& options = {});

  /// From all graphs of another planner for an equal map and vehicle: nothing is checked again. The options' radii and
  /// mode are those of the graphs, whatever they say.
  /// @throws SnapshotError if the graphs are not of this map, as far as ranges and order tell.
  static Planner restored(const World& world, const Vehicle& vehicle, const Backend& backend, PreparedGraph graphs,
                          const PlannerOptions& options = {});

  /// The planner after a change of the map, which plans as one built anew, bit for bit. What lies where nothing came or
  /// went is taken from the planner before, what it found out lazily included; the rest is checked now with an eager
  /// graph, and when a search first asks for it with a lazy one.
  ///
  ///     const World after = before.world().changed(removed, added);
  ///     const Planner planner = Planner::changed(before, WorldChange(before.world(), after, removed),
  ///                                              accel_backend(after));
  ///
  /// @param before   for the same vehicle. Of one with a whole reduced graph that is changed as well. Where the map's
  /// extent changes so much that other radii
  ///   are chosen, nothing is taken from it.
  /// @param change   from the world of `before` to that of the backend.
  /// @param options  of the new planner; empty ones and the mode of `before` if that says nothing. A process group is
  /// not asked.
  /// @throws std::invalid_argument as above, or if the change is not one between the two worlds.
  static Planner changed(const Planner& before, const WorldChange& change, const Backend& backend,
                         const PlannerOptions& options = {});

  /// The fastest path of the graph under the true speed profile, as far as PlannerOptions::suboptimality asks for it,
  /// refined. With `reverse` the cheapest found of that one, of paths by the graph with motions in both gears at their
  /// ends, and of short ones in both gears all the way: never dearer than without. Without it no segment is driven
  /// backwards. Never throws for want of a path: see PlanResult::status.
  /// Headings of so many turns that their rounding would show at the goal are taken for those within one: segments say
  /// these, the result's start and goal those asked for.
  /// @throws std::invalid_argument if a number of a pose is neither 0 nor of magnitude 1e-50 to 1e9, or the safety
  /// margin is too small for its coordinates, as for the map's. Also if the time limit is not a number, or the cost of
  /// a cusp is negative or not finite.
  [[nodiscard]] PlanResult plan(const PlanRequest& request, const PlanLimits& limits = {}) const;
  /// The same into a result whose memory is used again. With accel's queries and an eager graph, a request that was
  /// answered before then asks the heap for nothing. This holds without `reverse`, if single arcs join its ends to a
  /// path on circles of the smallest radius, and `limits` leave out trees.
  void plan(const PlanRequest& request, const PlanLimits& limits, PlanResult& result) const;

  /// Does now what the first queries would wait for: makes the graph with circles in narrow places, and takes memory
  /// for searches. For those to whom the slowest query matters; plans are the same. Thread-safe.
  /// @param queries_at_once  threads that will plan at the same time.
  void warm_up(std::size_t queries_at_once = 1) const;

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Vehicle& vehicle() const;
  [[nodiscard]] const QuerySet& queries() const;
  [[nodiscard]] const PlannerOptions& options()
      const;  ///< with the radii and the suboptimality used, without a process group
  /// Without vertices if the planner was made from rows.
  [[nodiscard]] const VisibilityGraph& visibility_graph() const;
  /// The rows of the same graph, however the planner was made: for another planner on the map, say.
  [[nodiscard]] std::shared_ptr<const VisibilityRows> visibility_rows() const;
  [[nodiscard]] const internal::FeasibleGraph& feasible_graph() const;
  /// All graphs, for another planner.
  /// @throws std::logic_error if the feasible graph is lazy, or the planner was made from rows.
  [[nodiscard]] PreparedGraph prepared_graph() const;
  [[nodiscard]] const PrepareStatistics& prepare_statistics() const;

 private:
  struct Data;
  explicit Planner(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway
