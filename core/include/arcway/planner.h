#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/backend.h"
#include "arcway/clearance_preference.h"
#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/graph_mode.h"
#include "arcway/heuristic.h"
#include "arcway/path.h"
#include "arcway/plan_result.h"
#include "arcway/polygon.h"
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
  /// Turning radii of the turn circles [m], each from the vehicle's smallest one to kLargestVehicleNumber. They are
  /// those to its tighter side; those to the other one reach from its smallest radius to the largest of these. Empty:
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
  /// Room that plans keep where they can: a plan costs its travel time plus that of driving close to obstacles.
  /// Searches and refinement keep this cost down instead of the time. The graph then also has circles that keep the
  /// distance from vertices, and is checked lazily. Clearance zones of the map do the same where they lie. Empty: time
  /// alone counts, but for zones.
  std::optional<ClearancePreference> clearance_preference = std::nullopt;
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
  /// Speeds with which the plan begins and ends [m/s]: positive driven forwards, negative backwards, 0 at rest. A start
  /// that moves forwards is that of a plan that is driven already: see TrajectoryState::signed_speed.
  double start_speed = 0.0;
  double goal_speed = 0.0;
};

/// "from (1, 2, 0) to (3, 4, 0) forwards", "... in both gears, at most 3 gear changes".
ARCWAY_API std::string to_string(const PlanRequest& request);

/// When to end a query early, and what it may spend. A query that ends early gives the best path found by then, if any.
/// Every stage of a query checks the clock within about a millisecond. What follows the stages, the speeds and the
/// clearance of the path, takes at most half a millisecond and a twentieth of the time limit more.
struct ARCWAY_API PlanLimits {
  double time = std::numeric_limits<double>::infinity();  ///< from the call on [s]
  std::stop_token stop = {};                              ///< may be requested from any thread
  /// Whether a second thread runs ahead of a long search on a lazy graph and fills its caches. The plan is the same,
  /// bit for bit, in some two thirds of the time where a core is free. FeasibleGraph::counts then differs from run to
  /// run.
  bool prefetch = false;
  /// Most poses of a search by trees of forward motions, which grow from start and goal where nothing else finds a
  /// path. Up to four searches follow each other, also for slimmer bodies, and some of a quarter as many poses for
  /// parts of what they find. 0: no trees. None grow with PlannerOptions::maneuver_poses = 0 either. A pose takes 0.05
  /// to 0.3 ms.
  std::uint32_t tree_poses = 16'000;
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
  ///
  /// Keep-outs for the vehicle are obstacles of Planner::world. A backend of another world than that of
  /// World::for_vehicle is changed to it.
  /// @param backend  of `world`. Its executor runs the construction only: a StoppableExecutor makes that cancelable, a
  ///   ReportingExecutor reports its progress.
  /// @throws std::invalid_argument if an option is out of its range, the backend is of another world, or the safety
  ///   margin is too small. The margin must be at least 2^20 units in the last place of the largest number among the
  ///   map's coordinates, the body's size and its smallest turning radius.
  /// @throws Canceled if the executor's clock is over before the graphs are built.
  Planner(const World& world, const Vehicle& vehicle, const Backend& backend, const PlannerOptions& options = {});

  /// A planner with the graphs of another planner for an equal map, zones included, and vehicle. Nothing is checked
  /// again. Radii and graph mode are those of the graphs; the options' are ignored.
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
  /// @throws std::invalid_argument as the constructor does, or if the change is not one between the two worlds, or if
  ///   their one-way zones differ.
  static Planner changed(const Planner& before, const WorldChange& change, const Backend& backend,
                         const PlannerOptions& options = {});

  /// A planner for the map without some obstacles, and with others: see World::changed. It plans as a planner built
  /// anew with the same options, bit for bit, and keeps what was found far from the change: see `changed`. This planner
  /// stays as it is; change_obstacles changes it in place. The two share memory for searches. Arrays of a planner that
  /// is gone are used again, in time that depends on what differs between the two maps.
  ///
  ///     const std::vector<ObstacleKey> gone{planner.world().key_of(3)};
  ///     const Planner after = planner.with_obstacles(gone, {Polygon::rectangle({12, 7}, 2.0, 1.0)});
  ///
  /// Thread-safe. The executor of the backend that the planner was made with runs the change, and must still exist.
  /// @param removed  keys of obstacles, in any order. Keys stay the same through changes: World::key_of.
  /// @param added  one that has as many vertices in each ring as a removed one takes its id and its key, as one that
  ///   has moved. All others get the last ids of the new world, in their order, and new keys.
  /// @throws std::invalid_argument if a key is of no obstacle of the map or is named twice, or the backend cannot be
  ///   changed (Backend::changed).
  /// @throws WorldError with the index that a refused obstacle has in the new world.
  [[nodiscard]] Planner with_obstacles(std::span<const ObstacleKey> removed, const std::vector<Polygon>& added) const;
  /// Changes this planner as with_obstacles does, in place. Copies made before keep the map before. What no copy uses
  /// is given back, or used again by the next change.
  ///
  ///     planner.change_obstacles(gone, {Polygon::rectangle({12, 7}, 2.0, 1.0)});
  ///
  /// Not thread-safe: for a planner with one owner, between two plans. If it throws, this planner is as before.
  /// @param removed, added  as of with_obstacles, as is what it throws.
  void change_obstacles(std::span<const ObstacleKey> removed, const std::vector<Polygon>& added);

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
  ///
  /// With a start or goal speed the plan is the fastest one that begins and ends so. An end that is too fast for the
  /// tightest turns is also joined by straights and arcs to brake on. A plan that cannot brake before an obstacle has
  /// no path; the reason names the length that braking takes. The time model is then TimeModel::kProfile.
  /// @throws std::invalid_argument if a number of a pose is neither 0 nor of magnitude 1e-50 to 1e9, or the time limit
  ///   is not a number.
  /// @throws std::invalid_argument if the safety margin is too small for the poses' coordinates (see the constructor),
  ///   or the cusp cost is negative or not finite.
  /// @throws std::invalid_argument if a start or goal speed is above the vehicle's limit in its gear, or backwards
  ///   without `reverse`.
  [[nodiscard]] PlanResult plan(const PlanRequest& request, const PlanLimits& limits = {}) const;
  /// A plan between two poses with the defaults of PlanRequest: planner.plan({0, 0, 0}, {20, 5, 0}).
  [[nodiscard]] PlanResult plan(const Pose& start, const Pose& goal, const PlanLimits& limits = {}) const;
  /// Overload that writes into a result whose memory is used again. With accel's queries and an eager graph, a request
  /// that was answered before allocates nothing. This holds without `reverse` and trees, if single arcs join start and
  /// goal to a path on circles of the smallest radius.
  void plan(const PlanRequest& request, const PlanLimits& limits, PlanResult& result) const;

  /// Whether a plan may start or end at a pose: the body, grown by half of the safety margin, touches no obstacle there
  /// and lies within the bounds. Exact, by one sweep query. Thread-safe.
  /// @throws std::invalid_argument if `plan` refuses the pose's numbers.
  [[nodiscard]] bool is_free(const Pose& pose) const;
  /// Whether the grown body is free all along a path, in whichever gears, and drives against no one-way zone. The swept
  /// area is decided, no samples; speeds, curvatures and joints are not looked at: `validate` does that. One sweep
  /// query a segment. Thread-safe.
  /// @throws std::invalid_argument naming the first segment whose length is negative or whose ends `plan` refuses.
  [[nodiscard]] bool is_free(std::span<const PathSegment> path) const;
  /// As is_free, for the body without any of the safety margin: what a vehicle may still drive, to stop, that has come
  /// that near to an obstacle, or an obstacle to it.
  [[nodiscard]] bool is_free_without_margin(std::span<const PathSegment> path) const;
  /// What a path drives closer to obstacles than PlannerOptions::clearance_preference, in whichever gears; nothing
  /// without a preference. O(log n + edges near by) a segment. Thread-safe.
  [[nodiscard]] std::optional<CloseDriving> close_driving(std::span<const PathSegment> path) const;
  /// What a path drives in clearance zones closer to obstacles than they ask for, as PlanResult::close_in_zones.
  /// O(log n + edges near by) a segment and zone. Thread-safe.
  [[nodiscard]] std::vector<ZoneCloseDriving> close_in_zones(std::span<const PathSegment> path) const;
  /// The pose itself if it is free, else the nearest free one of a pattern, by how far the body's points move:
  /// - the same position, with headings turned by multiples of 15 degrees;
  /// - the same heading, up to two diagonals of the body away, in 24 directions.
  ///
  /// Nothing if no pose of the pattern is free. Free poses off the pattern may be nearer. At most 768 sweep queries.
  /// Thread-safe.
  /// @throws std::invalid_argument as is_free does.
  [[nodiscard]] std::optional<Pose> nearest_free(const Pose& pose) const;

  /// Does now what the first queries would have to do: builds the graph with added circles in narrow gaps, and takes
  /// memory for searches. It makes the slowest query faster and changes no plan. Thread-safe.
  /// @param queries_at_once  number of threads that will plan at the same time.
  /// @param for_changes  whether the map will change: then also does what the first change of obstacles would have to,
  ///   and takes memory for it. It throws what with_obstacles does.
  void warm_up(std::size_t queries_at_once = 1, bool for_changes = false) const;

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Vehicle& vehicle() const;
  /// The queries of the backend. They are about obstacles, and know no one-way zones.
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

/// One plan, for those who need no more: Planner(world, vehicle).plan(...), with all defaults.
///
///     const PlanResult result = plan(world, Vehicle{}, {1, 1, 0}, {50, 40, kPi / 2});
///
/// The graphs are built for this plan alone, in O(n^2) pairs of vertices, each against all edges: for maps of some
/// hundred vertices. Keep a Planner for several plans on one map, and give a backend, as accel_backend(world), for
/// large maps. Thread-safe.
/// @param limits  their time counts from the call of this function on, but does not end the building of the graphs.
/// @throws std::invalid_argument as Planner's constructor and Planner::plan do.
ARCWAY_API PlanResult plan(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                           const PlanLimits& limits = {});
/// A request with more wishes than two poses.
ARCWAY_API PlanResult plan(const World& world, const Vehicle& vehicle, const PlanRequest& request,
                           const PlanLimits& limits = {});
/// A plan in the backend's world.
ARCWAY_API PlanResult plan(const Backend& backend, const Vehicle& vehicle, const PlanRequest& request,
                           const PlanLimits& limits = {});

}  // namespace arcway
