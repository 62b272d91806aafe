#include "core/planner.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/bound/point_distance.h"
#include "core/bound/travel_time_bound.h"
#include "core/geometry/angle.h"
#include "core/graph/turning_radii.h"
#include "core/no_path.h"
#include "core/path/clearance.h"
#include "core/path/speed_profile.h"
#include "core/refine/refine_reversing.h"
#include "core/search/find_path.h"
#include "core/search/find_reversing_path.h"
#include "core/search/narrow_places.h"
#include "core/search/search_map.h"
#include "core/search/workspace_pool.h"
#include "core/shortest_text.h"

namespace arcway {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargestPoseCoordinate = 1e9;
// Units in the last place of the largest coordinate that the safety margin must span: corners, centres and critical
// angles are off by a few units at most, grazing contacts by the square root of their precision times the reach.
constexpr double kMarginUnits = 1048576.0;

// A plan that may be slower than the best one by more than `gap`, a share, is tried again with manoeuvres at both ends.
struct Retry {
  double gap;
  std::uint32_t poses;
};
constexpr std::array<Retry, 2> kRetries{{{0.07, 12}, {0.1, 120}}};
// Then with circles in narrow places.
constexpr double kNarrowPlacesGap = 0.1;
// Their graph is lazy: where there is no path, a search checks all that the start reaches, seconds on larger maps.
constexpr std::size_t kNarrowPlacesVertices = 50'000;
// Where wider turns are faster there is more to be found by refinement.
constexpr std::uint64_t kTrialsFactor = 3;
// Of the proof that a vehicle which may reverse is enclosed: some milliseconds, far less than looking for a way out.
constexpr std::size_t kEnclosureBoxes = 15000;
// The same of the proof that one which may not gets nowhere.
constexpr std::size_t kDeadEndBoxes = 4000;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void require_pose(const char* name, const Pose& pose) {
  for (const double value : {pose.x, pose.y, pose.heading})
    if (!(std::abs(value) <= kLargestPoseCoordinate))
      throw std::invalid_argument(std::string(name) + " pose " + shortest_text(pose) + ": " + shortest_text(value) +
                                  " is not finite or beyond 1e9");
}

std::vector<double> checked_radii(const World& world, const Vehicle& vehicle, std::vector<double> radii) {
  if (radii.empty()) return turning_radii(vehicle, world);
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  for (const double radius : radii)
    if (!std::isfinite(radius) || radius < vehicle.min_turning_radius())
      throw std::invalid_argument("radius " + shortest_text(radius) +
                                  " is below the vehicle's smallest turning radius, " +
                                  shortest_text(vehicle.min_turning_radius()));
  return radii;
}

void require_margin(const World& world, const Vehicle& vehicle) {
  if (world.box().empty()) return;
  const double largest = std::max(world.box().min.cwiseAbs().maxCoeff(), world.box().max.cwiseAbs().maxCoeff());
  const double needed = kMarginUnits * (std::nextafter(largest, INFINITY) - largest);
  if (vehicle.safety_margin() < needed)
    throw std::invalid_argument("safety margin " + shortest_text(vehicle.safety_margin()) +
                                " m is too small for coordinates up to " + shortest_text(largest) +
                                ": doubles need at least " + shortest_text(needed) +
                                " m there; move the map to the origin");
}

PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options) {
  options.radii = checked_radii(world, vehicle, std::move(options.radii));
  if (!(options.suboptimality >= 0.0 && std::isfinite(options.suboptimality)))
    throw std::invalid_argument("suboptimality: " + shortest_text(options.suboptimality) + ", must be finite and >= 0");
  require_margin(world, vehicle);
  return options;
}

bool is_graph_vertex(const World& world, VertexId v) { return world.is_convex(v) && !world.is_covered(v); }

// Checks the feasible graph anew.
auto feasible_maker(const World& world, const Vehicle& vehicle, const QuerySet& queries, const Executor& executor) {
  return [&](const std::shared_ptr<const VisibilityRows>& rows, const PlannerOptions& options) {
    const SoloTeam alone;
    return FeasibleGraph(world, vehicle, rows, queries, options.radii, executor, options.graph_mode,
                         options.team ? *options.team : alone);
  };
}

// When the time limit of a search that begins now ends; nothing if never.
std::optional<std::chrono::steady_clock::time_point> deadline_of(const PlanLimits& limits) {
  using Clock = std::chrono::steady_clock;
  const auto now = Clock::now();
  const std::chrono::duration<double> limit(std::max(0.0, limits.time));
  if (limit >= Clock::time_point::max() - now) return std::nullopt;
  return now + std::chrono::duration_cast<Clock::duration>(limit);
}

}  // namespace

struct Planner::Data {
  struct Workspace {
    FindWorkspace find;
    PointDistance::Workspace point;
    RefineWorkspace refine;
    RefinedPath refined;
    Path best;  // so far
    SpeedProfile profile;
    PlanResult tight;  // of the tightest turns
  };

  /// @param make_feasible  gives the feasible graph for the rows of the reduced graph and the radii.
  template <class MakeFeasible>
  Data(const World& world, const Vehicle& vehicle, const QuerySet& queries, PlannerOptions o, VisibilityGraph graph,
       std::shared_ptr<const VisibilityRows> r, MakeFeasible&& make_feasible)
      : options(std::move(o)),
        visibility_graph(std::move(graph)),
        rows(std::move(r)),
        map(world, vehicle, queries, options.radii, make_feasible(rows, options)),
        narrow_places(map),
        bottleneck(world, vehicle) {
    const Footprint bare = vehicle.footprint();
    if (options.point_robot_bound && std::min(bare.front, bare.rear) >= 0.0)
      point_distance.emplace(world, rows, map.outlines);
    prepare_statistics.feasible_seconds = watch.seconds();
    prepare_statistics.counts = map.graph.counts();
  }

  // Runs a search and counts what it did.
  template <typename Find>
  FoundPath search(PlanResult& result, const Find& find) const {
    const Stopwatch searching;
    FoundPath found = find();
    PlanStatistics& s = result.statistics;
    s.nodes_expanded += found.search.nodes_expanded;
    s.nodes_pushed += found.search.nodes_pushed;
    s.straights_checked += found.search.straights_checked;
    s.turns_checked += found.search.turns_checked;
    s.manoeuvre_poses += found.manoeuvre_poses;
    s.search_seconds += searching.seconds();
    result.interrupted = result.interrupted || found.search.interrupted;
    return found;
  }

  // Refines a path into workspace.refined.
  void refine(const Path& path, const SearchOptions& search, bool reverse, Workspace& workspace,
              PlanResult& result) const {
    const Stopwatch refining;
    PlanStatistics& s = result.statistics;
    RefinedPath& refined = workspace.refined;
    s.unrefined_travel_time = travel_time(path, workspace);
    RefineOptions refinement = options.refinement;
    if (options.radii.size() > 1)
      refinement.max_trials = static_cast<std::uint32_t>(
          std::min<std::uint64_t>(kTrialsFactor * refinement.max_trials, std::numeric_limits<std::uint32_t>::max()));
    if (refinement.max_trials == 0) {
      refined.path = path;
      return;
    }
    const auto stop = [&search] { return search.interrupted(); };
    if (reverse) {
      refined = refine_reversing_path(path, map.vehicle, *map.queries.sweep, search.cusp_cost, refinement, stop);
    } else {
      refine_path(path, result.start, result.goal, map.vehicle, *map.queries.sweep, refinement, stop, workspace.refine,
                  refined);
    }
    result.interrupted = result.interrupted || refined.interrupted;
    s.refine_trials += refined.trials;
    s.refine_improvements += refined.improvements;
    s.straights_checked += refined.straights_checked;
    s.turns_checked += refined.turns_checked;
    s.refine_seconds += refining.seconds();
  }

  double travel_time(const Path& path, Workspace& workspace) const {
    speed_profile(path, map.vehicle, workspace.profile);
    return workspace.profile.total_time;
  }

  // Replaces the best path by that of the tightest turns if it is faster: refinement widens its turns as well, and ends
  // in another local optimum.
  void try_tightest_turns(const PlanLimits& limits, std::optional<std::chrono::steady_clock::time_point> deadline,
                          Workspace& workspace, PlanResult& result) const {
    if (options.radii.size() < 2 || result.interrupted) return;
    std::call_once(tightest_once, [this] {
      PlannerOptions o = options;
      o.radii.resize(1);
      o.graph_mode = GraphMode::kLazy;
      o.team = nullptr;
      tightest.emplace(map.world, map.vehicle, map.queries, rows, o, SerialExecutor());
    });
    PlanLimits rest{.stop = limits.stop};
    if (deadline) rest.time = std::chrono::duration<double>(*deadline - std::chrono::steady_clock::now()).count();
    PlanResult& tight = workspace.tight;
    tightest->plan({.start = result.start, .goal = result.goal}, rest, tight);
    result.statistics += tight.statistics;
    result.interrupted = tight.interrupted;
    if (!tight.solved() || !(tight.travel_time < travel_time(workspace.best, workspace))) return;
    workspace.best.clear();
    for (const TimedSegment& s : tight.segments) workspace.best.push_back(s.segment);
    result.statistics.unrefined_travel_time = tight.statistics.unrefined_travel_time;
  }

  // The lower bound with the way round the obstacles, if that is wanted.
  void raise_bound(const PlanRequest& request, PointDistance::Workspace& workspace, PlanResult& result) const {
    const Stopwatch bounding;
    if (point_distance)
      result.lower_bound = travel_time_bound(
          request.start, request.goal,
          (*point_distance)(request.start.position(), request.goal.position(), *map.queries.visibility, workspace),
          map.vehicle, request.reverse);
    result.statistics.bound_seconds = bounding.seconds();
  }

  [[nodiscard]] bool has_narrow_places() const {
    return options.gap_circles && map.world.vertices().size() <= kNarrowPlacesVertices;
  }

  Stopwatch watch;
  PlannerOptions options;
  VisibilityGraph visibility_graph;
  std::shared_ptr<const VisibilityRows> rows;
  SearchMap map;
  NarrowPlaces narrow_places;
  std::optional<PointDistance> point_distance;
  BottleneckFinder bottleneck;
  PrepareStatistics prepare_statistics;
  mutable std::once_flag tightest_once;
  mutable std::optional<Planner> tightest;  // of several radii only the smallest; made when first asked for
  mutable WorkspacePool<Workspace> workspaces;
};

const char* name_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kSolved:
      return "solved";
    case PlanStatus::kStartInCollision:
      return "start in collision";
    case PlanStatus::kGoalInCollision:
      return "goal in collision";
    case PlanStatus::kStartOutsideBounds:
      return "start outside bounds";
    case PlanStatus::kGoalOutsideBounds:
      return "goal outside bounds";
    case PlanStatus::kStartBlocked:
      return "start blocked";
    case PlanStatus::kGoalBlocked:
      return "goal blocked";
    case PlanStatus::kNoPassage:
      return "no passage";
    case PlanStatus::kNoPath:
      return "no path";
    case PlanStatus::kTimeLimit:
      return "time limit";
    case PlanStatus::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

PlanStatistics& PlanStatistics::operator+=(const PlanStatistics& other) {
  nodes_expanded += other.nodes_expanded;
  nodes_pushed += other.nodes_pushed;
  straights_checked += other.straights_checked;
  turns_checked += other.turns_checked;
  manoeuvre_poses += other.manoeuvre_poses;
  refine_trials += other.refine_trials;
  refine_improvements += other.refine_improvements;
  suboptimality = std::max(suboptimality, other.suboptimality);
  search_seconds += other.search_seconds;
  refine_seconds += other.refine_seconds;
  bound_seconds += other.bound_seconds;
  profile_seconds += other.profile_seconds;
  return *this;
}

Path PlanResult::path() const {
  Path path;
  path.reserve(segments.size());
  for (const TimedSegment& s : segments) path.push_back(s.segment);
  return path;
}

TimedPath PlanResult::timed_path() const {
  TimedPath path;
  for (const TimedSegment& s : segments) {
    path.segments.push_back(s.segment);
    path.speed_in.push_back(s.speed_in);
    path.speed_out.push_back(s.speed_out);
    path.durations.push_back(s.duration);
  }
  return path;
}

Planner::Planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options)
    : Planner(world, vehicle, make_reference_queries(world), options, SerialExecutor()) {}

Planner::Planner(const World& world, const Vehicle& vehicle, const QuerySet& queries, const PlannerOptions& options,
                 const Executor& executor) {
  const PlannerOptions checked = checked_options(world, vehicle, options);
  const Stopwatch watch;
  VisibilityGraph graph = checked.reduced_graph(world, *queries.visibility, executor);
  const double seconds = watch.seconds();
  auto rows = rows_of(world, graph);
  auto data = std::make_shared<Data>(world, vehicle, queries, checked, std::move(graph), std::move(rows),
                                     feasible_maker(world, vehicle, queries, executor));
  data->prepare_statistics.visibility_seconds = seconds;
  data_ = std::move(data);
}

Planner::Planner(const World& world, const Vehicle& vehicle, const QuerySet& queries, VisibilityGraph visibility_graph,
                 const PlannerOptions& options, const Executor& executor) {
  auto rows = rows_of(world, visibility_graph);
  data_ = std::make_shared<Data>(world, vehicle, queries, checked_options(world, vehicle, options),
                                 std::move(visibility_graph), std::move(rows),
                                 feasible_maker(world, vehicle, queries, executor));
}

Planner::Planner(const World& world, const Vehicle& vehicle, const QuerySet& queries,
                 std::shared_ptr<const VisibilityRows> rows, const PlannerOptions& options, const Executor& executor)
    : data_(std::make_shared<Data>(world, vehicle, queries, checked_options(world, vehicle, options), VisibilityGraph(),
                                   std::move(rows), feasible_maker(world, vehicle, queries, executor))) {}

Planner::Planner(const World& world, const Vehicle& vehicle, const QuerySet& queries, PreparedGraph graphs,
                 const PlannerOptions& options) {
  PlannerOptions taken = options;
  taken.radii = graphs.radii;
  taken.graph_mode = GraphMode::kEager;
  taken = checked_options(world, vehicle, std::move(taken));
  if (graphs.reduced_graph.vertex_count() != world.vertices().size())
    throw TableError(Table::kRowStarts, graphs.reduced_graph.vertex_count(),
                     "at the end, the world has " + std::to_string(world.vertices().size()) + " vertices");
  for (VertexId u = 0; u < world.vertices().size(); ++u)
    for (const VertexId v : graphs.reduced_graph.row(u))
      if (!is_graph_vertex(world, u) || !is_graph_vertex(world, v))
        throw TableError(
            Table::kTargets, graphs.reduced_graph.row_starts()[u],
            "row " + std::to_string(u) + " joins it to " + std::to_string(v) + ", which are not both convex and free");
  auto rows = rows_of(world, graphs.reduced_graph);
  data_ = std::make_shared<Data>(world, vehicle, queries, std::move(taken), std::move(graphs.reduced_graph),
                                 std::move(rows), [&](const auto& all_rows, const PlannerOptions& o) {
                                   return FeasibleGraph(world, vehicle, all_rows, queries, o.radii,
                                                        std::move(graphs.feasible));
                                 });
}

Planner::Planner(const Planner& before, const World& world, const WorldChange& change, const QuerySet& queries,
                 VisibilityGraph visibility_graph, const PlannerOptions& options, const Executor& executor) {
  const std::size_t old_vertices = before.world().vertices().size(), vertices = world.vertices().size();
  const auto stayed = std::ranges::count_if(change.moved, [](VertexId v) { return v != kNone; });
  if (change.moved.size() != old_vertices || change.end_come < change.first_come ||
      static_cast<std::size_t>(stayed) + (change.end_come - change.first_come) != vertices)
    throw std::invalid_argument("the change leads from " + std::to_string(change.moved.size()) + " vertices to " +
                                std::to_string(static_cast<std::size_t>(stayed) + change.end_come - change.first_come) +
                                ", the worlds have " + std::to_string(old_vertices) + " and " +
                                std::to_string(vertices));
  const Vehicle& vehicle = before.vehicle();
  const auto make_feasible = [&](const auto& rows, const PlannerOptions& o) {
    if (o.radii != before.options().radii)
      return FeasibleGraph(world, vehicle, rows, queries, o.radii, executor, o.graph_mode);
    return FeasibleGraph(before.feasible_graph(), world, change, vehicle, rows, queries, o.radii, executor,
                         o.graph_mode);
  };
  auto rows = rows_of(world, visibility_graph);
  data_ = std::make_shared<Data>(world, vehicle, queries, checked_options(world, vehicle, options),
                                 std::move(visibility_graph), std::move(rows), make_feasible);
}

PlanResult Planner::plan(const PlanRequest& request, const PlanLimits& limits) const {
  PlanResult result;
  plan(request, limits, result);
  return result;
}

void Planner::plan(const PlanRequest& request, const PlanLimits& limits, PlanResult& result) const {
  require_pose("start", request.start);
  require_pose("goal", request.goal);
  if (std::isnan(limits.time)) throw std::invalid_argument("time limit: not a number");
  if (!(request.cusp_cost >= 0.0 && std::isfinite(request.cusp_cost)))
    throw std::invalid_argument("cusp cost: " + shortest_text(request.cusp_cost) + " s, must be finite and >= 0");
  const Stopwatch total;
  const auto deadline = deadline_of(limits);
  const Data& d = *data_;
  std::vector<TimedSegment> segments = std::move(result.segments);
  Path first_path = std::move(result.first_path);
  segments.clear();
  first_path.clear();
  result = {};
  result.segments = std::move(segments);
  result.first_path = std::move(first_path);
  result.start = request.start;
  result.goal = request.goal;
  result.statistics.suboptimality = d.options.suboptimality;
  const double straight = (request.goal.position() - request.start.position()).norm();
  result.lower_bound = travel_time_bound(request.start, request.goal, straight, d.map.vehicle, request.reverse);
  if (!pose_is_free(d.map, request.start, true, result) || !pose_is_free(d.map, request.goal, false, result)) {
    result.statistics.total_seconds = total.seconds();
    return;
  }

  WorkspacePool<Data::Workspace>::Lease workspace(d.workspaces);
  SearchOptions options{d.options.heuristic, limits.stop, deadline, request.cusp_cost};
  options.time_model = d.options.time_model;
  options.suboptimality = d.options.suboptimality;
  std::optional<DeadEnd> dead_end;
  const auto no_passage = [&] {
    result.bottleneck = d.bottleneck(request.start, request.goal);
    if (result.bottleneck && result.bottleneck->too_narrow()) return true;
    if (!request.reverse)
      dead_end = find_dead_end(request.start, request.goal, d.map.body, d.map.vehicle.min_turning_radius(),
                               *d.map.queries.sweep, kDeadEndBoxes);
    return dead_end.has_value();
  };
  FoundPath forwards = d.search(result, [&] {
    return find_path(d.map, d.has_narrow_places() ? &d.narrow_places : nullptr, request.start, request.goal,
                     d.options.manoeuvre_poses, std::cref(no_passage), options, workspace->find);
  });
  Path& best = workspace->best;
  bool found = false;
  const auto keep_faster = [&](Path&& path, bool reverse) {
    const double unrefined = result.statistics.unrefined_travel_time;
    if (!found) {
      result.statistics.first_path_seconds = total.seconds();
      result.first_path = path;
    }
    d.refine(path, options, reverse, *workspace, result);
    if (!found) result.statistics.first_travel_time = result.statistics.unrefined_travel_time;
    workspace->find.search.reuse(std::move(path));
    const auto cost = [&](const Path& p) {
      return travel_cost(p, d.map.vehicle, request.cusp_cost, workspace->profile);
    };
    if (!found || cost(workspace->refined.path) < cost(best)) {
      std::swap(best, workspace->refined.path);
      found = true;
    } else {
      result.statistics.unrefined_travel_time = unrefined;
    }
  };
  const bool has_forwards = forwards.search.path.has_value();
  if (has_forwards) {
    keep_faster(std::move(*forwards.search.path), false);
    d.raise_bound(request, workspace->point, result);
    const auto is_doubtful = [&](double gap) {
      return d.travel_time(best, *workspace) > (1.0 + gap) * result.lower_bound && !result.interrupted;
    };
    const auto try_faster = [&](const SearchMap& map, std::size_t poses) {
      SearchOptions faster = options;
      faster.faster_than = result.statistics.unrefined_travel_time;
      FoundPath turning = d.search(result, [&] {
        return find_path_with_manoeuvres(map, request.start, request.goal, poses, faster, workspace->find);
      });
      if (turning.search.path) keep_faster(std::move(*turning.search.path), false);
    };
    const SearchMap& map = forwards.by_narrow_places ? d.narrow_places.map() : d.map;
    for (const Retry& retry : kRetries) {
      const auto poses = std::min(retry.poses, d.options.manoeuvre_poses);
      if (poses <= 1 || !is_doubtful(retry.gap)) break;
      try_faster(map, poses);
    }
    if (d.has_narrow_places() && !forwards.by_narrow_places && is_doubtful(kNarrowPlacesGap))
      try_faster(d.narrow_places.map(), 0);
    d.try_tightest_turns(limits, deadline, *workspace, result);
  }
  std::optional<Enclosure> enclosure;
  bool hopeless = forwards.obstruction == Obstruction::kPassage;
  if (request.reverse && !found && !result.interrupted && !hopeless) {
    enclosure = find_enclosure(request.start, request.goal, d.map.body, *d.map.queries.sweep, kEnclosureBoxes);
    hopeless = enclosure.has_value();
  }
  if (request.reverse && !result.interrupted && !hopeless && !(found && best.empty())) {
    const double unrefined = found ? result.statistics.unrefined_travel_time : kInfinity;
    FoundPath both = d.search(result, [&] {
      return find_reversing_path(d.map, request.start, request.goal, unrefined, options, workspace->find.search);
    });
    if (both.search.path) keep_faster(std::move(*both.search.path), true);
  }
  if (!found) {
    explain(d.map, {forwards.obstruction, dead_end, enclosure, request.reverse}, limits, result);
    result.statistics.total_seconds = total.seconds();
    return;
  }
  if (!has_forwards) d.raise_bound(request, workspace->point, result);
  const Path& path = best;

  const Stopwatch finishing;
  result.status = PlanStatus::kSolved;
  result.bottleneck.reset();
  SpeedProfile& profile = workspace->profile;
  speed_profile(path, d.map.vehicle, profile);
  const Footprint bare = d.map.vehicle.footprint();
  // The middle of the body is further from the obstacles than the body.
  result.min_clearance = d.map.queries.distance->closest(middle_of(bare, request.start)).distance;
  const auto look_along = [&](const PathSegment& segment) {
    return clearance_below(result.min_clearance, segment, bare, *d.map.outlines);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathSegment& segment = path[i];
    result.segments.push_back({segment, profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
    const double clearance = look_along(segment);
    if (clearance < result.min_clearance) {
      result.min_clearance = clearance;
      result.clearance_index = i;
      result.clearance_segment = segment;
    }
  }
  if (path.empty()) result.min_clearance = look_along({request.start, 0.0, 0.0});
  result.travel_time = profile.total_time;
  result.length = length_of(path);
  result.statistics.profile_seconds += finishing.seconds();
  result.statistics.total_seconds = total.seconds();
}

const World& Planner::world() const { return data_->map.world; }
const Vehicle& Planner::vehicle() const { return data_->map.vehicle; }
const QuerySet& Planner::queries() const { return data_->map.queries; }
const PlannerOptions& Planner::options() const { return data_->options; }
const VisibilityGraph& Planner::visibility_graph() const { return data_->visibility_graph; }
std::shared_ptr<const VisibilityRows> Planner::visibility_rows() const { return data_->rows; }
const FeasibleGraph& Planner::feasible_graph() const { return data_->map.graph; }
PreparedGraph Planner::prepared_graph() const {
  return {data_->visibility_graph, data_->options.radii, data_->map.graph.tables()};
}
const PrepareStatistics& Planner::prepare_statistics() const { return data_->prepare_statistics; }

}  // namespace arcway
