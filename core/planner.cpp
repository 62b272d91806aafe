#include "core/planner.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/bound/point_distance.h"
#include "core/bound/travel_time_bound.h"
#include "core/geometry/angle.h"
#include "core/path/clearance.h"
#include "core/path/speed_profile.h"
#include "core/search/arrival_search.h"
#include "core/search/manoeuvres.h"
#include "core/search/search_map.h"
#include "core/search/workspace_pool.h"

namespace arcway {

namespace {

constexpr double kLargestPoseCoordinate = 1e9;
// Units in the last place of the largest coordinate that the safety margin must span: corners, centres and critical
// angles are off by a few units at most, grazing contacts by the square root of their precision times the reach.
constexpr double kMarginUnits = 1048576.0;
constexpr std::size_t kFirstManoeuvrePoses = 100;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string text_of(const Pose& pose) {
  return "(" + text_of(pose.x) + ", " + text_of(pose.y) + ", " + text_of(pose.heading) + ")";
}

void require_pose(const char* name, const Pose& pose) {
  for (const double value : {pose.x, pose.y, pose.heading})
    if (!(std::abs(value) <= kLargestPoseCoordinate))
      throw std::invalid_argument(std::string(name) + " pose " + text_of(pose) + ": " + text_of(value) +
                                  " is not finite or beyond 1e9");
}

std::vector<double> checked_radii(const Vehicle& vehicle, std::vector<double> radii) {
  if (radii.empty()) radii.push_back(vehicle.min_turning_radius());
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  for (const double radius : radii)
    if (!std::isfinite(radius) || radius < vehicle.min_turning_radius())
      throw std::invalid_argument("radius " + text_of(radius) + " is below the vehicle's smallest turning radius, " +
                                  text_of(vehicle.min_turning_radius()));
  return radii;
}

void require_margin(const World& world, const Vehicle& vehicle) {
  if (world.box().empty()) return;
  const double largest = std::max(world.box().min.cwiseAbs().maxCoeff(), world.box().max.cwiseAbs().maxCoeff());
  const double needed = kMarginUnits * (std::nextafter(largest, INFINITY) - largest);
  if (vehicle.safety_margin() < needed)
    throw std::invalid_argument("safety margin " + text_of(vehicle.safety_margin()) +
                                " m is too small for coordinates up to " + text_of(largest) +
                                ": doubles need at least " + text_of(needed) + " m there; move the map to the origin");
}

PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options) {
  options.radii = checked_radii(vehicle, std::move(options.radii));
  require_margin(world, vehicle);
  return options;
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
  Data(const World& world, const Vehicle& vehicle, const QuerySet& queries, PlannerOptions o, VisibilityGraph graph,
       const Executor& executor)
      : options(std::move(o)),
        visibility_graph(std::move(graph)),
        map(world, vehicle, queries, options.radii,
            FeasibleGraph(world, vehicle, visibility_graph, queries, options.radii, executor, options.graph_mode)) {
    const Footprint bare = vehicle.footprint();
    if (options.point_robot_bound && std::min(bare.front, bare.rear) >= 0.0)
      point_distance.emplace(world, visibility_graph);
    prepare_statistics.feasible_seconds = watch.seconds();
    prepare_statistics.counts = map.graph.counts();
  }

  // Fills status and reason if the pose itself is not free; true if it is.
  bool pose_is_free(const Pose& pose, bool start, PlanResult& result) const {
    if (map.queries.sweep->straight_free(swept_rectangle(pose, 0.0, map.body))) return true;
    const auto outside = static_cast<ObstacleId>(map.world.obstacle_count());
    const bool out = map.world.has_bounds() && map.world.locate(pose.position(), outside) == PointLocation::kInside;
    if (out) {
      result.status = start ? PlanStatus::kStartOutsideBounds : PlanStatus::kGoalOutsideBounds;
    } else {
      result.status = start ? PlanStatus::kStartInCollision : PlanStatus::kGoalInCollision;
    }
    result.reason =
        std::string(start ? "the start " : "the goal ") + text_of(pose) +
        (out ? " lies outside the bounds"
             : ": the body, grown by half of the safety margin, collides; nearest is " + nearest_region(pose));
    return false;
  }

  // "obstacle 17" or "the bounds": the region around the pose, else the one nearest to it.
  [[nodiscard]] std::string nearest_region(const Pose& pose) const {
    const ObstacleId inside = map.queries.distance->containing(pose.position());
    const VertexId edge = map.queries.distance->closest(pose.position()).edge;
    if (inside == kNone && edge == kNone) return "nothing";
    const ObstacleId region = inside != kNone ? inside : map.world.obstacle_of(edge);
    return region == map.world.obstacle_count() ? "the bounds" : "obstacle " + std::to_string(region);
  }

  Stopwatch watch;
  PlannerOptions options;
  VisibilityGraph visibility_graph;
  SearchMap map;
  std::optional<PointDistance> point_distance;
  PrepareStatistics prepare_statistics;
  mutable WorkspacePool workspaces;
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
    case PlanStatus::kNoPath:
      return "no path";
    case PlanStatus::kTimeLimit:
      return "time limit";
    case PlanStatus::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

Path PlanResult::path() const {
  Path path;
  path.reserve(segments.size());
  for (const TimedSegment& s : segments) path.push_back(s.segment);
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
  auto data = std::make_shared<Data>(world, vehicle, queries, checked, std::move(graph), executor);
  data->prepare_statistics.visibility_seconds = seconds;
  data_ = std::move(data);
}

Planner::Planner(const World& world, const Vehicle& vehicle, const QuerySet& queries, VisibilityGraph visibility_graph,
                 const PlannerOptions& options, const Executor& executor)
    : data_(std::make_shared<Data>(world, vehicle, queries, checked_options(world, vehicle, options),
                                   std::move(visibility_graph), executor)) {}

PlanResult Planner::plan(const PlanRequest& request, const PlanLimits& limits) const {
  require_pose("start", request.start);
  require_pose("goal", request.goal);
  if (std::isnan(limits.time)) throw std::invalid_argument("time limit: not a number");
  const Stopwatch total;
  const auto deadline = deadline_of(limits);
  const Data& d = *data_;
  PlanResult result;
  result.start = request.start;
  result.goal = request.goal;
  const double straight = (request.goal.position() - request.start.position()).norm();
  result.lower_bound = travel_time_bound(request.start, request.goal, straight, d.map.vehicle);
  if (!d.pose_is_free(request.start, true, result) || !d.pose_is_free(request.goal, false, result)) {
    result.statistics.total_seconds = total.seconds();
    return result;
  }

  SearchOptions options{d.options.heuristic, limits.stop, deadline};
  WorkspacePool::Lease workspace(d.workspaces);
  std::vector<Terminal> starts{{request.start, {}}};
  std::vector<Terminal> goals{{request.goal, {}}};
  SearchResult found;
  const auto search = [&] {
    found = search_arrivals(d.map, starts, goals, options, *workspace);
    result.statistics.nodes_expanded += found.nodes_expanded;
    result.statistics.nodes_pushed += found.nodes_pushed;
    result.statistics.straights_checked += found.straights_checked;
    result.statistics.turns_checked += found.turns_checked;
  };
  std::size_t last_poses = 0;  // asked for; fewer found means that there are no more
  const bool in_place = (request.start.position() - request.goal.position()).isZero(0.0) &&
                        wrap_signed(request.start.heading - request.goal.heading) == 0.0;
  if (in_place) {
    found.path = Path{};
  } else {
    search();
    for (std::size_t poses = kFirstManoeuvrePoses; !found.path && !found.interrupted; poses *= 8) {
      const bool exhausted = starts.size() < last_poses || goals.size() < last_poses;
      if (exhausted || last_poses >= d.options.manoeuvre_poses) break;
      last_poses = std::min<std::size_t>(poses, d.options.manoeuvre_poses);
      const double radius = d.options.radii.front();
      starts = find_manoeuvres(request.start, Direction::kFromStart, d.map.vehicle, radius, *d.map.queries.sweep,
                               last_poses);
      goals =
          find_manoeuvres(request.goal, Direction::kToGoal, d.map.vehicle, radius, *d.map.queries.sweep, last_poses);
      result.statistics.manoeuvre_poses += starts.size() + goals.size();
      search();
    }
  }
  result.statistics.search_seconds = total.seconds();

  result.interrupted = found.interrupted;
  if (!found.path) {
    const std::string nearest = "; nearest is ";
    if (found.interrupted) {
      const bool cancelled = limits.stop.stop_requested();
      result.status = cancelled ? PlanStatus::kCancelled : PlanStatus::kTimeLimit;
      result.reason = cancelled ? "the search was cancelled before it found a path"
                                : "no path was found within the time limit of " + text_of(limits.time) + " s";
    } else if (starts.size() < last_poses || !found.start_connected) {
      result.status = PlanStatus::kStartBlocked;
      result.reason = "the start " + text_of(request.start) +
                      " is hemmed in: no forward motion of arcs and lines that was tried leads from it to the graph" +
                      nearest + d.nearest_region(request.start);
    } else if (goals.size() < last_poses || !found.goal_reached) {
      result.status = PlanStatus::kGoalBlocked;
      result.reason = "the goal " + text_of(request.goal) +
                      " is hemmed in: no forward motion of arcs and lines that was tried leads from the graph to it" +
                      nearest + d.nearest_region(request.goal);
    } else {
      result.status = PlanStatus::kNoPath;
      result.reason = "the feasible visibility graph does not join start and goal";
      if (d.options.graph_mode == GraphMode::kEager) {
        const FeasibleGraphCounts c = d.map.graph.counts();
        result.reason += " (" + std::to_string(c.rejected_straight) + " straights too narrow by (6), " +
                         std::to_string(c.rejected_departure + c.rejected_arrival) + " turns by (7) of " +
                         std::to_string(c.candidates) + " bitangents)";
      }
    }
    result.statistics.total_seconds = total.seconds();
    return result;
  }

  const Stopwatch refining;
  result.statistics.unrefined_travel_time = speed_profile(*found.path, d.map.vehicle).total_time;
  if (d.options.refinement.max_trials > 0) {
    RefinedPath refined = refine_path(
        *found.path, request.start, request.goal, d.map.vehicle, *d.map.queries.sweep, d.options.refinement,
        [&] { return limits.stop.stop_requested() || (deadline && std::chrono::steady_clock::now() >= *deadline); });
    found.path = std::move(refined.path);
    result.statistics.refine_trials = refined.trials;
    result.statistics.refine_improvements = refined.improvements;
    result.statistics.straights_checked += refined.straights_checked;
    result.statistics.turns_checked += refined.turns_checked;
  }
  result.statistics.refine_seconds = refining.seconds();

  const Stopwatch bounding;
  if (d.point_distance)
    result.lower_bound = travel_time_bound(
        request.start, request.goal,
        (*d.point_distance)(request.start.position(), request.goal.position(), *d.map.queries.visibility),
        d.map.vehicle);
  result.statistics.bound_seconds = bounding.seconds();

  const Stopwatch finishing;
  result.status = PlanStatus::kSolved;
  const SpeedProfile profile = speed_profile(*found.path, d.map.vehicle);
  const Footprint bare = d.map.vehicle.footprint();
  result.min_clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found.path->size(); ++i) {
    const PathSegment& segment = (*found.path)[i];
    result.segments.push_back({segment, profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
    const Clearance clearance = clearance_along(segment, bare, d.map.world);
    if (clearance.distance < result.min_clearance) {
      result.min_clearance = clearance.distance;
      result.clearance_index = i;
      result.clearance_segment = segment;
    }
  }
  if (found.path->empty())
    result.min_clearance = clearance_along({request.start, 0.0, 0.0}, bare, d.map.world).distance;
  result.travel_time = profile.total_time;
  result.length = length_of(*found.path);
  result.statistics.profile_seconds = finishing.seconds();
  result.statistics.total_seconds = total.seconds();
  return result;
}

const World& Planner::world() const { return data_->map.world; }
const Vehicle& Planner::vehicle() const { return data_->map.vehicle; }
const VisibilityGraph& Planner::visibility_graph() const { return data_->visibility_graph; }
const FeasibleGraph& Planner::feasible_graph() const { return data_->map.graph; }
const PrepareStatistics& Planner::prepare_statistics() const { return data_->prepare_statistics; }

}  // namespace arcway
