#include "arcway/planner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"
#include "core/base/shortest_text.h"
#include "core/base/stopwatch.h"
#include "core/base/workspace_pool.h"
#include "core/collision/clearance_cost.h"
#include "core/collision/motion_free.h"
#include "core/collision/one_way_sweep.h"
#include "core/model/outlines.h"
#include "core/model/vertex_map.h"
#include "core/motion/clearance.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "core/planner/collision.h"
#include "core/planner/no_path.h"
#include "core/planner/plan_run.h"
#include "core/planner/planner_inputs.h"
#include "core/planner/planner_maps.h"
#include "core/planner/query_context.h"
#include "core/planner/strategy.h"
#include "core/roadmap/build_feasible_graph.h"
#include "core/roadmap/change_feasible_graph.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/finished_feasible_graph.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "core/roadmap/restore_feasible_graph.h"
#include "core/zones/one_way_zones.h"
#include "core/zones/speed_zones.h"

namespace arcway {

using namespace internal;

namespace {

std::shared_ptr<const FeasibleGraph> make_feasible_graph(const FeasibleGraphInputs& inputs, GraphMode mode,
                                                         const Executor& executor, const ProcessGroup& process_group) {
  if (mode == GraphMode::kLazy) return std::make_shared<const LazyFeasibleGraph>(inputs, executor);
  return build_feasible_graph(inputs, executor, process_group);
}

void require_segments(std::span<const PathSegment> path, const Vehicle& vehicle) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string name = "segment " + std::to_string(i);
    if (!(path[i].length >= 0.0))
      throw std::invalid_argument(name + ": length " + shortest_text(path[i].length) + " m, must be >= 0");
    require_pose(name + ": start", path[i].start, vehicle);
    require_pose(name + ": end", path[i].end(), vehicle);
  }
}

// The queries of motions: about obstacles, and about the directions that zones forbid.
QuerySet motion_queries(const World& world, const Backend& backend) {
  QuerySet queries = backend.queries();
  queries.sweep = obeying(queries.sweep, OneWayZones::of(world));
  return queries;
}

// Checks the feasible graph anew.
auto feasible_maker(const World& world, const Vehicle& vehicle, const QuerySet& queries, const Executor& executor) {
  return [&](const std::shared_ptr<const VisibilityRows>& rows, const PlannerOptions& options) {
    const SingleProcess alone;
    return make_feasible_graph({world, vehicle, rows, queries, {vehicle, options.radii}}, *options.graph_mode, executor,
                               options.process_group ? *options.process_group : alone);
  };
}

std::shared_ptr<const Outlines> outlines_of(const World& world, const MapsBefore* before) {
  if (before) {
    const VertexMap change(before->change.change);
    const Outlines& outlines = *before->maps.all.plain.outlines;
    if (outlines.can_change(change)) return std::make_shared<const Outlines>(outlines, world, change);
  }
  return std::make_shared<const Outlines>(world);
}

// The graph and the outlines do not depend on each other. But a process group talks on the thread that it was made on.
// Many parameters because those of Planner's constructors come apart here.
template <class MakeGraph>
Roadmap make_map(const World& world, const Vehicle& vehicle, const QuerySet& queries, const PlannerOptions& options,
                 const MakeGraph& make_graph, const Executor& many, const MapsBefore* before) {
  const SerialExecutor one;
  const Executor& executor =
      options.process_group && options.process_group->size() > 1 ? static_cast<const Executor&>(one) : many;
  std::shared_ptr<const FeasibleGraph> graph;
  std::shared_ptr<const Outlines> outlines;
  executor.begin_stage("feasible graph");
  run_both(
      executor, [&] { graph = make_graph(); }, [&] { outlines = outlines_of(world, before); });
  const auto roadmap = before ? std::optional(RoadmapBefore{before->maps.all.plain, before->change.may_differ})
                              : std::optional<RoadmapBefore>();
  return {world,
          vehicle,
          queries,
          {vehicle, options.radii},
          std::move(graph),
          std::move(outlines),
          roadmap ? &*roadmap : nullptr,
          many.clock()};
}

// The mode that suits the backend, unless the options name one.
PlannerOptions with_mode(PlannerOptions options, const Backend& backend) {
  if (!options.graph_mode) options.graph_mode = backend.has_lazy_rows() ? GraphMode::kLazy : GraphMode::kEager;
  return options;
}

// Keeps the memory of what it had.
void clear(PlanResult& result) {
  std::vector<TimedSegment> segments = std::move(result.segments);
  Path first_path = std::move(result.first_path);
  segments.clear();
  first_path.clear();
  result = {};
  result.segments = std::move(segments);
  result.first_path = std::move(first_path);
}

struct AllOptions {
  AllOptions(const World& world, const Vehicle& vehicle, PlannerOptions o)
      : given(std::move(o)), checked(checked_options(world, vehicle, given)) {}
  PlannerOptions given;    // with a graph mode
  PlannerOptions checked;  // with all that was chosen for this world
};

// What a path drives closer to obstacles than a rule asks for.
CloseDriving driven_close(const ClearanceCost::Rule& rule, std::span<const PathSegment> path) {
  CloseDriving close{.distance = rule.close.distance()};
  for (const PathSegment& segment : path) close.length += rule.close_length(segment);
  close.cost = rule.cost * close.length;
  return close;
}

struct ReducedGraph {
  Backend::Graph whole = std::make_shared<const VisibilityGraph>();
  std::shared_ptr<const VisibilityRows> rows;
  double seconds = 0.0;
};

// Rows alone where no more is needed. They and the queries do not depend on each other.
ReducedGraph reduced_graph_of(const Backend& backend, GraphMode mode) {
  ReducedGraph graph;
  backend.executor().begin_stage("queries");
  if (backend.has_lazy_rows() && (mode == GraphMode::kLazy || !backend.has_graphs())) {
    run_both(
        backend.executor(), [&] { static_cast<void>(backend.queries()); },
        [&] {
          const Stopwatch watch;
          graph.rows = backend.lazy_rows();
          graph.seconds = watch.seconds();
        });
    return graph;
  }
  static_cast<void>(backend.queries());  // made before the clock begins
  const Stopwatch watch;
  graph.whole = backend.reduced_graph();
  graph.seconds = watch.seconds();
  graph.rows = rows_of(backend.world(), *graph.whole);
  return graph;
}

}  // namespace

struct Planner::Data {
  /// @param make_feasible  gives the feasible graph for the rows of the reduced graph and the radii.
  // Many parameters because planners that are new, restored or changed have no more in common than these.
  template <class MakeFeasible>
  Data(const World& world, const Vehicle& vehicle, const Backend& b, AllOptions all, ReducedGraph reduced,
       MakeFeasible&& make_feasible, const Executor& executor, const MapsBefore* maps_before = nullptr,
       std::shared_ptr<WorkspacePool<PlanWorkspace>> memory = std::make_shared<WorkspacePool<PlanWorkspace>>())
      : backend(b),
        given(std::move(all.given)),
        options(std::move(all.checked)),
        strategy(strategy_without(options.leave_out)),
        visibility_graph(std::move(reduced.whole)),
        rows(std::move(reduced.rows)),
        maps(make_map(
                 world, vehicle, motion_queries(world, b), options, [&] { return make_feasible(rows, options); },
                 executor, maps_before),
             b.queries().sweep, options, rows, executor, maps_before),
        scene(std::make_shared<const PlanScene>(PlanScene{world, vehicle})),
        workspaces(std::move(memory)) {
    prepare_statistics.visibility_seconds = reduced.seconds;
    prepare_statistics.feasible_seconds = watch.seconds();
    prepare_statistics.counts = maps.base_graph->counts();
    given.process_group = options.process_group = nullptr;  // need not outlive the construction
  }

  [[nodiscard]] const Roadmap& map() const { return maps.all.plain; }

  [[nodiscard]] std::optional<CloseDriving> close_driving(std::span<const PathSegment> path) const;
  [[nodiscard]] std::vector<ZoneCloseDriving> close_in_zones(std::span<const PathSegment> path) const;
  // Speeds, clearance and all that follows from a path.
  void complete(const Path& path, Grace grace, SpeedProfile& profile, PlanResult& result) const;

  Stopwatch watch;
  Backend backend;
  PlannerOptions given;  // see AllOptions
  PlannerOptions options;
  std::vector<StrategyRow> strategy;
  Backend::Graph visibility_graph;  // without vertices if there are only rows
  std::shared_ptr<const VisibilityRows> rows;
  PlannerMaps maps;
  std::shared_ptr<const PlanScene> scene;  // that results share
  PrepareStatistics prepare_statistics;
  std::shared_ptr<WorkspacePool<PlanWorkspace>> workspaces;  // also of planners before and after changes
};

std::optional<CloseDriving> Planner::Data::close_driving(std::span<const PathSegment> path) const {
  if (!options.clearance_preference) return std::nullopt;
  return driven_close(maps.clearance_cost->rules().front(), path);
}

std::vector<ZoneCloseDriving> Planner::Data::close_in_zones(std::span<const PathSegment> path) const {
  std::vector<ZoneCloseDriving> found;
  if (!maps.clearance_cost) return found;
  for (const ClearanceCost::Rule& rule : maps.clearance_cost->rules()) {
    if (rule.zone == kNone) continue;
    const CloseDriving close = driven_close(rule, path);
    if (close.length > 0.0) found.push_back({rule.zone, close});
  }
  return found;
}

void Planner::Data::complete(const Path& whole, Grace grace, SpeedProfile& profile, PlanResult& result) const {
  const Stopwatch finishing;
  const Vehicle& vehicle = map().vehicle;
  result.status = PlanStatus::kSolved;
  result.bottleneck.reset();
  const EndSpeeds ends{result.start_speed, result.goal_speed};
  CappedPath capped;
  std::span<const PathSegment> path = whole;
  if (map().speed_zones && !whole.empty()) {
    cut(whole, *map().speed_zones, capped);
    path = capped.segments;
    capped_travel_time(capped, vehicle, ends, profile);
  } else {
    travel_time(whole, vehicle, ends, profile);
  }
  const Body bare = vehicle.body();
  // A point of the body is further from the obstacles than the body.
  result.min_clearance = map().queries.distance->closest(inner_point_of(bare, result.start)).distance;
  const auto look_along = [&](const PathSegment& segment) {
    return clearance_below(result.min_clearance, segment, bare, *map().outlines);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathSegment& segment = path[i];
    result.segments.push_back({segment, profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
    if (result.clearance_is_lower_bound) continue;
    if (grace.is_over()) {
      result.clearance_is_lower_bound = result.interrupted = true;
      result.min_clearance = std::min(result.min_clearance, 0.5 * vehicle.safety_margin());
      continue;
    }
    const double clearance = look_along(segment);
    if (clearance < result.min_clearance) {
      result.min_clearance = clearance;
      result.clearance_index = i;
      result.clearance_segment = segment;
    }
  }
  if (path.empty()) result.min_clearance = look_along({result.start, 0.0, 0.0});
  result.travel_time = profile.total_time;
  result.length = length_of(path);
  result.close_driving = close_driving(whole);
  result.close_in_zones = close_in_zones(whole);
  // Rounding is taken off the bound: a plan below it is a defect.
  assert(result.travel_time >= result.lower_bound);
  result.statistics.profile_seconds += finishing.seconds();
}

Planner::Planner(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Planner::Planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options)
    : Planner(world, vehicle, reference_backend(world.for_vehicle(vehicle)), options) {}

Planner::Planner(const World& given_world, const Vehicle& vehicle, const Backend& given,
                 const PlannerOptions& options) {
  const World world = given_world.for_vehicle(vehicle);
  const Backend backend = backend_for(given_world, world, given);
  AllOptions checked(world, vehicle, with_mode(options, backend));
  ReducedGraph reduced = reduced_graph_of(backend, *checked.given.graph_mode);
  data_ = std::make_shared<const Data>(
      world, vehicle, backend, std::move(checked), std::move(reduced),
      feasible_maker(world, vehicle, motion_queries(world, backend), backend.executor()), backend.executor());
}

Planner Planner::restored(const World& given_world, const Vehicle& vehicle, const Backend& given, PreparedGraph graphs,
                          const PlannerOptions& options) {
  const World world = given_world.for_vehicle(vehicle);
  const Backend backend = backend_for(given_world, world, given);
  PlannerOptions taken = options;
  taken.radii = graphs.radii;
  taken.graph_mode = GraphMode::kEager;
  AllOptions checked(world, vehicle, std::move(taken));
  const QuerySet queries = motion_queries(world, backend);
  ReducedGraph reduced;
  reduced.rows = rows_of(world, graphs.reduced_graph);
  reduced.whole = std::make_shared<const VisibilityGraph>(std::move(graphs.reduced_graph));
  return Planner(std::make_shared<const Data>(
      world, vehicle, backend, std::move(checked), std::move(reduced),
      [&](const auto& all_rows, const PlannerOptions& o) {
        return restore_feasible_graph({world, vehicle, all_rows, queries, {vehicle, o.radii}},
                                      std::move(graphs.feasible));
      },
      SerialExecutor()));
}

Planner Planner::changed(const Planner& before, const WorldChange& change, const Backend& backend,
                         const PlannerOptions& options) {
  const World& world = backend.world();
  require_change(change, before.world(), world);
  require_same_one_way(before.world(), world);
  PlannerOptions alone = options;
  alone.process_group = nullptr;
  if (!alone.graph_mode) alone.graph_mode = before.options().graph_mode;
  const Vehicle& vehicle = before.vehicle();
  AllOptions checked(world, vehicle, std::move(alone));
  const Executor& executor = backend.executor();
  ReducedGraph reduced;
  std::optional<VisibilityRows::Changed> rows_after;
  if (before.visibility_graph().vertex_count() == 0) {
    if (*checked.given.graph_mode == GraphMode::kLazy)
      rows_after = before.visibility_rows()->changed(world, change, backend.queries().visibility);
    if (rows_after) {
      reduced.rows = rows_after->rows;
    } else {
      reduced = reduced_graph_of(backend, *checked.given.graph_mode);
    }
  } else {
    reduced.whole = backend.changed_graph(before.visibility_graph(), change);
    reduced.rows = rows_of(world, *reduced.whole);
  }
  const QuerySet queries = motion_queries(world, backend);
  const auto make_feasible = [&](const auto& rows, const PlannerOptions& o) -> std::shared_ptr<const FeasibleGraph> {
    const FeasibleGraphInputs inputs{world, vehicle, rows, queries, {vehicle, o.radii}};
    if (o.radii != before.options().radii) return make_feasible_graph(inputs, *o.graph_mode, executor, kSingleProcess);
    if (rows_after && !before.feasible_graph().finished())
      return change_lazy_feasible_graph(dynamic_cast<const LazyFeasibleGraph&>(before.feasible_graph()), inputs, change,
                                        rows_after->may_differ);
    if (*o.graph_mode == GraphMode::kLazy)
      return change_lazy_feasible_graph(before.feasible_graph(), inputs, change, executor);
    return change_feasible_graph(before.feasible_graph(), inputs, change, executor);
  };
  std::optional<MapsBefore> maps_before;
  // Circles of a clearance preference are added anew.
  if (rows_after && !options.clearance_preference)
    maps_before.emplace(MapsBefore{before.data_->maps, {change, rows_after->may_differ}});
  return Planner(std::make_shared<const Data>(world, vehicle, backend, std::move(checked), std::move(reduced),
                                              make_feasible, executor, maps_before ? &*maps_before : nullptr,
                                              before.data_->workspaces));
}

Planner Planner::with_obstacles(std::span<const ObstacleKey> removed, const std::vector<Polygon>& added) const {
  const std::vector<ObstacleId> ids = obstacles_with(world(), removed);
  const World after = world().changed(ids, added);
  const WorldChange change = WorldChange::unchecked(world(), after, ids);
  return changed(*this, change, data_->backend.changed(after, change), data_->given);
}

void Planner::change_obstacles(std::span<const ObstacleKey> removed, const std::vector<Polygon>& added) {
  *this = with_obstacles(removed, added);
}

PlanResult Planner::plan(const PlanRequest& request, const PlanLimits& limits) const {
  PlanResult result;
  plan(request, limits, result);
  return result;
}

PlanResult Planner::plan(const Pose& start, const Pose& goal, const PlanLimits& limits) const {
  return plan(PlanRequest{.start = start, .goal = goal}, limits);
}

void Planner::plan(const PlanRequest& asked, const PlanLimits& limits, PlanResult& result) const {
  require_request(asked, limits, vehicle());
  const Stopwatch total;
  const StopClock clock(limits.time, limits.stop);
  const Data& d = *data_;
  clear(result);
  result.scene = d.scene;
  result.start = asked.start;
  result.goal = asked.goal;
  result.start_speed = asked.start_speed;
  result.goal_speed = asked.goal_speed;
  const double distance = (asked.goal.position() - asked.start.position()).norm();
  PlanRequest request = asked;
  request.start = without_many_turns(asked.start, distance);
  request.goal = without_many_turns(asked.goal, distance);
  result.statistics.suboptimality = d.options.suboptimality.value_or(0.0);
  result.lower_bound = travel_time_lower_bound(request.start, request.goal, distance, d.map().vehicle, request.reverse,
                                               {request.start_speed, request.goal_speed}, d.map().speed_zones.get());
  const auto is_possible = [&](const Pose& pose, bool start) {
    return pose_is_free(d.map(), pose, start, result) && end_speed_obeys_zones(d.map(), pose, start, result) &&
           end_heading_obeys_zones(d.map(), request, start, result);
  };
  if (is_possible(request.start, true) && is_possible(request.goal, false)) {
    WorkspacePool<PlanWorkspace>::Lease workspace(*d.workspaces);
    const QueryContext query{d.maps, d.options, request, limits, clock};
    PlanRun run(query, *workspace, result);
    run.follow(d.strategy);
    if (run.found()) {
      run.raise_lower_bound();
      d.complete(run.best(), Grace(clock, limits.time), workspace->profile, result);
    } else {
      // What ended early is no reason, unless a proof came before.
      result.interrupted = result.interrupted || (!run.has_proof() && clock.is_over());
      explain(d.map(), run.why(), limits, result);
    }
  }
  result.statistics.total_seconds = total.seconds();
}

void Planner::warm_up(std::size_t queries_at_once, bool for_changes) const {
  const Data& d = *data_;
  if (for_changes && world().obstacle_count() > 0) {
    // Two planners after changes are there at once while one follows the other. Their arrays go to the first changes.
    const auto last = static_cast<ObstacleId>(world().obstacle_count() - 1);
    const std::vector<ObstacleKey> key{world().key_of(last)};
    const std::vector<Polygon> same{world().polygon_of(last)};
    const Planner one = with_obstacles(key, same), other = with_obstacles(key, same);
  }
  std::size_t most_circles = d.map().graph->circles().size();
  for (const PlanMaps* maps : {&d.maps.all, d.maps.tightest ? &*d.maps.tightest : nullptr})
    if (maps && maps->narrow) most_circles = std::max(most_circles, maps->narrow->map().graph->circles().size());
  std::list<WorkspacePool<PlanWorkspace>::Lease> leases;
  for (std::size_t i = 0; i < queries_at_once; ++i)
    leases.emplace_back(*d.workspaces)->find.search.warm_up(most_circles);
}

bool Planner::is_free(const Pose& pose) const {
  require_pose("pose", pose, vehicle());
  return data_->map().queries.sweep->straight_free({pose, 0.0, data_->map().body});
}

bool Planner::is_free(std::span<const PathSegment> path) const {
  require_segments(path, vehicle());
  return motion_free(*data_->map().queries.sweep, data_->map().body, path);
}

bool Planner::is_free_without_margin(std::span<const PathSegment> path) const {
  require_segments(path, vehicle());
  return motion_free(*data_->map().queries.sweep, vehicle().body(), path);
}

std::optional<CloseDriving> Planner::close_driving(std::span<const PathSegment> path) const {
  return data_->close_driving(path);
}

std::vector<ZoneCloseDriving> Planner::close_in_zones(std::span<const PathSegment> path) const {
  return data_->close_in_zones(path);
}

std::optional<Pose> Planner::nearest_free(const Pose& pose) const {
  if (is_free(pose)) return pose;
  const std::optional<FreePose> free = nearest_free_pose(*data_->map().queries.sweep, data_->map().body, pose);
  return free ? std::optional(free->pose) : std::nullopt;
}

const World& Planner::world() const { return data_->map().world; }
const Vehicle& Planner::vehicle() const { return data_->map().vehicle; }
const QuerySet& Planner::queries() const { return data_->backend.queries(); }
const PlannerOptions& Planner::options() const { return data_->options; }
const VisibilityGraph& Planner::visibility_graph() const { return *data_->visibility_graph; }
std::shared_ptr<const VisibilityRows> Planner::visibility_rows() const { return data_->rows; }
const FeasibleGraph& Planner::feasible_graph() const { return *data_->maps.base_graph; }
PreparedGraph Planner::prepared_graph() const {
  const FinishedFeasibleGraph* finished = feasible_graph().finished();
  if (!finished || visibility_graph().vertex_count() != world().vertices().size())
    throw std::logic_error("prepared graph: only of a planner with an eager graph, see PlannerOptions::graph_mode");
  return {*data_->visibility_graph, data_->options.radii, finished->snapshot()};
}
const PrepareStatistics& Planner::prepare_statistics() const { return data_->prepare_statistics; }

std::string to_string(const PlanRequest& request) {
  std::string text = "from " + to_string(request.start) + " to " + to_string(request.goal) +
                     (request.reverse ? " in both gears" : " forwards");
  if (request.start_speed != 0.0) text += ", from " + shortest_text(request.start_speed) + " m/s";
  if (request.goal_speed != 0.0) text += ", to " + shortest_text(request.goal_speed) + " m/s";
  if (request.max_gear_changes) text += ", at most " + std::to_string(*request.max_gear_changes) + " gear changes";
  return text;
}

PlanResult plan(const Backend& backend, const Vehicle& vehicle, const PlanRequest& request, const PlanLimits& limits) {
  require_request(request, limits, vehicle);  // before the graphs are built
  const Stopwatch watch;
  const Planner planner(backend.world(), vehicle, backend);
  PlanLimits rest = limits;
  rest.time = std::max(0.0, limits.time - watch.seconds());
  PlanResult result = planner.plan(request, rest);
  if (result.status == PlanStatus::kTimeLimit) result.reason = time_limit_reason(limits);
  return result;
}

PlanResult plan(const World& world, const Vehicle& vehicle, const PlanRequest& request, const PlanLimits& limits) {
  return plan(reference_backend(world), vehicle, request, limits);
}

PlanResult plan(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                const PlanLimits& limits) {
  return plan(world, vehicle, {.start = start, .goal = goal}, limits);
}

}  // namespace arcway
