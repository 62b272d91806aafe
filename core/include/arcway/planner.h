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

/// What a planner may do in every query, and how it is built. The defaults suit most maps.
struct PlannerOptions {
  Heuristic heuristic = Heuristic::kTravelTime;  ///< what the graph search adds to the time so far
  TimeModel time_model = TimeModel::kProfile;    ///< how the graph search times paths
  /// Suboptimality w of the graph search, from 0 to 1e6. Before refinement, a path by single arcs may take up to 1 + w
  /// times as long as the fastest path of the graph. A larger w expands fewer nodes. Empty: 0, or
  /// kLargeMapSuboptimality on maps of more than kExactVertices convex vertices. On those maps the proof that no other
  /// path is faster takes most of a query.
  std::optional<double> suboptimality = std::nullopt;
  static constexpr std::size_t kExactVertices = 250'000;
  static constexpr double kLargeMapSuboptimality = 0.025;
  /// When the feasible graph is checked. Plans are the same in both modes, bit for bit. Empty: lazy if the backend has
  /// lazy rows, else eager. A lazy planner answers its first query sooner. For many queries on one map, kEager costs
  /// less in all.
  std::optional<GraphMode> graph_mode = std::nullopt;
  /// Turning radii of the turn circles [m], each from the vehicle's smallest one to kLargestVehicleNumber. Empty:
  /// turning_radii(vehicle, world). If some are wider than those of tightest_radii, every query also plans with the
  /// tightest ones alone and takes the faster plan. Wider turns then hardly ever make a plan slower.
  std::vector<double> radii = {};
  /// Number of poses that maneuvers may try at start and goal, at most kMostManeuverPoses. A maneuver is a chain of a
  /// few short arcs and straights; it is tried where single arcs reach no circle of the graph. 0: no maneuvers, and no
  /// trees (PlanLimits). If both ends reach the graph but not each other, four times as many poses are tried, farther
  /// apart. If the optimality gap is large, a few are tried. Memory: some 300 bytes a pose. Each end also keeps up to
  /// 65,536 straights to the graph, or half as many as the map has vertices if that is more, of some 60 bytes each.
  std::uint32_t maneuver_poses = 400;
  static constexpr std::uint32_t kMostManeuverPoses = 1'000'000;
  /// Whether to search a second graph with added circles in narrow gaps. It is searched where single arcs find no path,
  /// or where the plan may be some percent slower than the best one: see the strategy in core/README.md. The graph is
  /// made when a query first needs it, or by Planner::warm_up. Maps of more than 50,000 vertices have none, as a query
  /// without a path would take seconds there.
  bool gap_circles = true;
  /// Whether PlanResult::lower_bound counts the detour around obstacles, not only the straight line from start to goal.
  bool point_robot_lower_bound = true;
  /// Local optimization of each path found; `max_trials = 0` turns it off. With radii wider than the tightest ones, a
  /// query may run up to some fifty times as many trials in all.
  RefineOptions refinement = {};
  /// Rows of the strategy and moves of refinement to do without, by their names: to find out what each of them brings,
  /// or to have answers sooner. The tables in core/README.md list them.
  std::vector<std::string> leave_out = {};
  /// Processes that build one eager graph together; null: this process alone. Used during construction only, and not
  /// part of Planner::options.
  const ProcessGroup* process_group = nullptr;
};

/// One query: from a pose to a pose.
struct PlanRequest {
  Pose start;
  Pose goal;
  bool reverse = false;    ///< whether the vehicle may drive backwards as well
  double cusp_cost = 0.0;  ///< added to the cost of a plan for each gear change, beside the time that stopping takes
                           ///< [s]; no part of travel times
  /// Largest number of gear changes of a plan; none: any number.
  std::optional<std::uint32_t> max_gear_changes = std::nullopt;
};

/// When to end a query early, and what it may spend. A query that ends early gives the best path found by then, if any.
/// Every stage of a query checks the clock within about a millisecond. What follows the stages, the speeds and the
/// clearance of the path, takes at most 2 ms and a twentieth of the time limit more.
struct ARCWAY_API PlanLimits {
  double time = std::numeric_limits<double>::infinity();  ///< from the call on [s]
  std::stop_token stop = {};                              ///< may be requested from any thread
  /// Whether a second thread runs ahead of a long search on a lazy graph and fills its caches. The plan is the same,
  /// bit for bit, in some two thirds of the time where a core is free. FeasibleGraph::counts then differs from run to
  /// run.
  bool prefetch = false;
  /// Most poses of a search by trees of forward motions, which grow from start and goal where nothing else finds a
  /// path. Up to four searches follow each other, also for slimmer bodies. 0: no trees. None grow with
  /// PlannerOptions::maneuver_poses = 0 either. A pose takes 0.05 to 0.3 ms.
  std::uint32_t tree_poses = 16'000;
};

/// How a query ended.
enum class PlanStatus {
  kSolved,
  kStartInCollision,  ///< the body grown by half of the safety margin touches an obstacle at the start
  kGoalInCollision,
  kStartOutsideBounds,
  kGoalOutsideBounds,
  /// No motion that was tried leads far from the start. PlanResult::certainty says whether that is proved. If the goal
  /// is in a dead end too, the reason says so. With `reverse`, this status is given only where it is proved.
  kStartBlocked,
  kGoalBlocked,            ///< no motion that was tried leads to the goal from afar; as kStartBlocked otherwise
  kWaypointInCollision,    ///< of a tour: as kStartInCollision, at a waypoint
  kWaypointOutsideBounds,  ///< of a tour
  kWaypointBlocked,        ///< of a tour: no motion leads to a waypoint, or on from it
  kNoPassage,              ///< proved: no gap is wide enough for the body, in any direction of travel
  kNoPath,                 ///< no path was found, and none is proved not to exist
  kTimeLimit,              ///< the time limit ended the search before it found a path
  kCanceled                ///< a stop was requested before a path was found
};
/// The status in words: "solved", "start in collision", ...
ARCWAY_API const char* name_of(PlanStatus status);

/// Whether a query without a path proves that there is none.
enum class Certainty {
  kProved,  ///< no path exists: the body collides in a pose, no gap is wide enough, or an end is a dead end
  kGaveUp   ///< nothing that was tried leads there, or the time was up; a path may exist
};
/// The certainty in words: "proved" or "gave up".
ARCWAY_API const char* name_of(Certainty certainty);

/// A segment of a plan with its speeds. Between them the speed changes as fast as the vehicle and its limits allow.
struct TimedSegment {
  PathSegment segment;
  double speed_in = 0.0;   ///< [m/s]
  double speed_out = 0.0;  ///< [m/s]
  double duration = 0.0;   ///< [s]
};

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

/// The answer to one query. Segments, times and lengths are empty or 0 unless it is solved.
struct ARCWAY_API PlanResult {
  PlanStatus status = PlanStatus::kNoPath;
  std::string reason;                        ///< unless solved: what failed, where, by which value and limit
  Certainty certainty = Certainty::kGaveUp;  ///< unless solved: whether that is proved
  Pose start, goal;                          ///< as requested
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
  /// Unless solved: the narrowest gap of the widest route from start to goal. Nothing if that gap is wide enough for
  /// the tightest turn, or as wide as the room around start or goal, or if the query was interrupted.
  std::optional<Bottleneck> bottleneck;
  PlanStatistics statistics;
  /// By which share the plan may be slower than the best one at most: travel_time / lower_bound - 1, or 0 if the plan
  /// takes no time.
  [[nodiscard]] double optimality_gap() const { return travel_time > 0.0 ? travel_time / lower_bound - 1.0 : 0.0; }
  [[nodiscard]] bool solved() const { return status == PlanStatus::kSolved; }
  [[nodiscard]] Path path() const;  ///< the segments without speeds
  /// The segments with speeds and durations, as the validator takes them.
  [[nodiscard]] TimedPath timed_path() const;
};

/// What it took to build a planner.
struct PrepareStatistics {
  double visibility_seconds = 0.0;  ///< for the reduced visibility graph [s]
  double feasible_seconds = 0.0;    ///< for the feasible visibility graph [s]
  FeasibleGraphCounts counts;
};

/// Plans on one map for one vehicle. The constructor builds the reduced and the feasible visibility graph, and `plan`
/// answers any number of queries.
///
///     const Planner planner(world, Vehicle{});
///     const PlanResult result = planner.plan({.start = {1, 1, 0}, .goal = {50, 40, kPi / 2}});
///     if (!result.solved()) return report(result.reason);
///     for (const TimedSegment& s : result.segments) drive(s);
///
/// Arguments are copied or shared: none need outlive the call. Copies of a planner share its graphs. `plan` is const
/// and thread-safe.
class ARCWAY_API Planner {
 public:
  /// A planner with reference_backend, for maps of some hundred vertices.
  /// @throws std::invalid_argument as the constructor below.
  Planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options = {});
  /// A planner with the queries and graph builders of a backend.
  /// @param backend  of `world`. Its executor runs the construction only: a StoppableExecutor makes that cancelable, a
  ///   ReportingExecutor reports its progress.
  /// @throws std::invalid_argument if an option is out of its range, the backend is of another world, or the safety
  ///   margin is too small. The margin must be at least 2^20 units in the last place of the largest number among the
  ///   map's coordinates, the body's size and its smallest turning radius.
  /// @throws Canceled if the executor's clock is over before the graphs are built.
  Planner(const World& world, const Vehicle& vehicle, const Backend& backend, const PlannerOptions& options = {});

  /// A planner with the graphs of another planner for an equal map and vehicle. Nothing is checked again. Radii and
  /// graph mode are those of the graphs; the options' are ignored.
  /// @throws SnapshotError if the graphs are not of this map, as far as ranges and order tell.
  static Planner restored(const World& world, const Vehicle& vehicle, const Backend& backend, PreparedGraph graphs,
                          const PlannerOptions& options = {});

  /// A planner for the map after a change. It plans as a planner built anew, bit for bit. Rows and links far from the
  /// change are taken from the old planner, those it found lazily included. The rest is checked now in an eager graph,
  /// or when a search first needs it in a lazy one.
  ///
  ///     const World after = before.world().changed(removed, added);
  ///     const Planner planner = Planner::changed(before, WorldChange(before.world(), after, removed),
  ///                                              accel_backend(after));
  ///
  /// @param before  a planner for the same vehicle. If the change alters the map's extent so much that other radii are
  ///   chosen, nothing is taken from it.
  /// @param change  from the world of `before` to that of the backend.
  /// @param options  of the new planner. Empty members are chosen anew; an empty graph mode is that of `before`. A
  ///   process group is ignored.
  /// @throws std::invalid_argument as the constructor does, or if the change is not one between the two worlds.
  static Planner changed(const Planner& before, const WorldChange& change, const Backend& backend,
                         const PlannerOptions& options = {});

  /// The fastest path of the roadmap under the true speed profile, within PlannerOptions::suboptimality, after
  /// refinement. Without `reverse`, no segment is driven backwards. With `reverse`, the result is the cheapest path of
  /// three searches:
  /// 1. without reversing;
  /// 2. over the roadmap, with motions in both gears at start and goal;
  /// 3. by short motions in both gears all the way.
  ///
  /// A query without a path is no error: see PlanResult::status. A heading of very many turns is reduced to one turn
  /// where its rounding would show at the goal. Segments then start and end at the reduced heading; the result's start
  /// and goal are those of the request. Thread-safe. Cost: see the table in README.md.
  /// @throws std::invalid_argument if a number of a pose is neither 0 nor of magnitude 1e-50 to 1e9, or the time limit
  ///   is not a number.
  /// @throws std::invalid_argument if the safety margin is too small for the poses' coordinates (see the constructor),
  ///   or the cusp cost is negative or not finite.
  [[nodiscard]] PlanResult plan(const PlanRequest& request, const PlanLimits& limits = {}) const;
  /// Overload that writes into a result whose memory is used again. With accel's queries and an eager graph, a request
  /// that was answered before allocates nothing. This holds without `reverse` and trees, if single arcs join start and
  /// goal to a path on circles of the smallest radius.
  void plan(const PlanRequest& request, const PlanLimits& limits, PlanResult& result) const;

  /// Does now what the first queries would have to do: builds the graph with added circles in narrow gaps, and takes
  /// memory for searches. It makes the slowest query faster and changes no plan. Thread-safe.
  /// @param queries_at_once  number of threads that will plan at the same time.
  void warm_up(std::size_t queries_at_once = 1) const;

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Vehicle& vehicle() const;
  [[nodiscard]] const QuerySet& queries() const;
  /// The options, with the radii and the suboptimality used, and without a process group.
  [[nodiscard]] const PlannerOptions& options() const;
  /// The reduced visibility graph. It has no vertices if the planner was made from lazy rows.
  [[nodiscard]] const VisibilityGraph& visibility_graph() const;
  /// The rows of the reduced visibility graph, however the planner was made. Another planner on the same map can use
  /// them.
  [[nodiscard]] std::shared_ptr<const VisibilityRows> visibility_rows() const;
  [[nodiscard]] const internal::FeasibleGraph& feasible_graph() const;
  /// All graphs, for Planner::restored.
  [[nodiscard]] PreparedGraph prepared_graph() const;
  [[nodiscard]] const PrepareStatistics& prepare_statistics() const;

 private:
  struct Data;
  explicit Planner(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway
