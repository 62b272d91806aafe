#include "core/planner/planner_inputs.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "arcway/angle.h"
#include "arcway/turning_radii.h"
#include "arcway/zone.h"
#include "core/model/pose_text.h"
#include "core/planner/strategy.h"
#include "core/refine/moves.h"
#include "core/refine/refine_path.h"

namespace arcway::internal {

namespace {

// Largest suboptimality: no time overflows.
constexpr double kLargestSuboptimality = 1e6;
// Units in the last place of the largest coordinate that the safety margin must span. Corners, centers and critical
// angles are off by a few units at most. Grazing contacts are off by the square root of their precision times the
// reach.
constexpr double kMarginUnits = 1048576.0;
// Largest product of a heading and the distance to the goal [rad m]. Up to here, rounding moves the end of a path by
// some 1e-8 m.
constexpr double kMostTurned = 4e7;
// Range of the numbers of a pose other than 0. All that is computed from them stays far from what queries refuse.
constexpr double kSmallestPoseNumber = 1e-50, kLargestPoseNumber = 1e9;

void require_margin(const Vehicle& vehicle, double largest, const char* what, const std::string& whose = "",
                    const char* advice = "") {
  const double needed = kMarginUnits * (std::nextafter(largest, INFINITY) - largest);
  if (vehicle.safety_margin() < needed)
    throw std::invalid_argument("safety margin " + shortest_text(vehicle.safety_margin()) + " m is too small for " +
                                what + whose + " " + shortest_text(largest) + ": doubles need at least " +
                                shortest_text(needed) + " m there" + advice);
}

std::vector<double> checked_radii(const World& world, const Vehicle& vehicle, std::vector<double> radii) {
  if (radii.empty()) return turning_radii(vehicle, world);
  for (const double radius : radii)
    if (!(radius >= vehicle.min_turning_radius() && radius <= kLargestVehicleNumber))
      throw std::invalid_argument(
          "radius " + shortest_text(radius) + " m: must be from the vehicle's smallest turning radius, " +
          shortest_text(vehicle.min_turning_radius()) + ", to " + shortest_text(kLargestVehicleNumber));
  require_margin(vehicle, *std::max_element(radii.begin(), radii.end()), "a turning radius of");
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

void add_name(std::string_view name, std::string& names) {
  const std::string quoted = "\"" + std::string(name) + "\"";
  if (names.find(quoted) == std::string::npos) names += (names.empty() ? "" : ", ") + quoted;
}

// A row of the strategy, which is left out later, or a move of refinement.
void leave_out(const std::string& name, PlannerOptions& options) {
  options.refinement.moves &= ~move_bit(name);
  if (move_bit(name) != 0 || std::ranges::find(kStrategy, name, &StrategyRow::name) != std::end(kStrategy)) return;
  std::string known;
  for (const StrategyRow& row : kStrategy) add_name(row.name, known);
  for (const MoveRow& row : kMoves) add_name(row.name, known);
  for (const GearMoveRow& row : kGearMoves) add_name(row.name, known);
  throw std::invalid_argument("leave out \"" + name +
                              "\": no row of the strategy and no move of refinement; these are " + known);
}

void require_margin(const World& world, const Vehicle& vehicle) {
  const Footprint body = vehicle.footprint();
  const double largest = std::max({body.length(), body.width(), body.farthest(), vehicle.parameters().wheelbase});
  require_margin(vehicle, largest, "a body of");
  for (const Side side : {Side::kLeft, Side::kRight})
    require_margin(vehicle, vehicle.min_turning_radius(side), "a smallest turning radius of");
  if (world.box().empty()) return;
  require_margin(vehicle, std::max(world.box().min.cwiseAbs().maxCoeff(), world.box().max.cwiseAbs().maxCoeff()),
                 "coordinates up to", "", "; move the map to the origin");
}

void require_preference(const ClearancePreference& preference) {
  if (!(preference.distance > 0.0 && preference.distance <= ClearancePreference::kMost))
    throw std::invalid_argument("clearance preference: distance " + shortest_text(preference.distance) +
                                " m, must be above 0 and at most " + shortest_text(ClearancePreference::kMost));
  if (!(preference.cost >= 0.0 && preference.cost <= ClearancePreference::kMost))
    throw std::invalid_argument("clearance preference: cost " + shortest_text(preference.cost) +
                                " s/m, must be from 0 to " + shortest_text(ClearancePreference::kMost));
}

}  // namespace

PlannerOptions checked_options(const World& world, const Vehicle& vehicle, PlannerOptions options) {
  options.radii = checked_radii(world, vehicle, std::move(options.radii));
  const bool is_large = world.graph_vertex_count() > PlannerOptions::kExactVertices;
  const double suboptimality = options.suboptimality.value_or(is_large ? PlannerOptions::kLargeMapSuboptimality : 0.0);
  if (!(suboptimality >= 0.0 && suboptimality <= kLargestSuboptimality))
    throw std::invalid_argument("suboptimality: " + shortest_text(suboptimality) + ", must be from 0 to " +
                                shortest_text(kLargestSuboptimality));
  options.suboptimality = suboptimality;
  if (options.maneuver_poses > PlannerOptions::kMostManeuverPoses)
    throw std::invalid_argument("maneuver poses: " + std::to_string(options.maneuver_poses) + ", at most " +
                                std::to_string(PlannerOptions::kMostManeuverPoses));
  require_refinement(options.refinement);
  if (options.clearance_preference) require_preference(*options.clearance_preference);
  for (const std::string& name : options.leave_out) leave_out(name, options);
  require_margin(world, vehicle);
  return options;
}

std::vector<ObstacleId> obstacles_with(const World& world, std::span<const ObstacleKey> keys) {
  std::vector<ObstacleId> ids;
  for (const ObstacleKey key : keys) {
    ids.push_back(world.obstacle_with(key));
    if (ids.back() == kNone)
      throw std::invalid_argument("no obstacle of the map has the key " + std::to_string(key) +
                                  ": was it removed before? World::key_of gives the keys of those that there are");
  }
  std::ranges::sort(ids);
  if (const auto twice = std::ranges::adjacent_find(ids); twice != ids.end())
    throw std::invalid_argument("the key " + std::to_string(world.key_of(*twice)) +
                                " is named twice; name each obstacle to be removed once");
  return ids;
}

void require_pose(const std::string& name, const Pose& pose, const Vehicle& vehicle) {
  for (const double value : {pose.x, pose.y, pose.heading})
    if (value != 0.0 && !(std::abs(value) >= kSmallestPoseNumber && std::abs(value) <= kLargestPoseNumber))
      throw std::invalid_argument(name + " " + shortest_text(pose) + ": " + shortest_text(value) +
                                  " is neither 0 nor of magnitude " + shortest_text(kSmallestPoseNumber) + " to " +
                                  shortest_text(kLargestPoseNumber));
  require_margin(vehicle, pose.position().cwiseAbs().maxCoeff(), "the coordinate of the ", name);
}

// A speed at an end must be one that the vehicle can drive on a line.
void require_speed(const std::string& name, double speed, bool reverse, const Vehicle& vehicle) {
  const double ahead = vehicle.max_speed(), back = reverse ? vehicle.max_reverse_speed() : 0.0;
  if (speed >= -back && speed <= ahead) return;
  throw std::invalid_argument(name + ": " + shortest_text(speed) + " m/s, must be from " + shortest_text(0.0 - back) +
                              " to " + shortest_text(ahead) + ", the vehicle's limits" +
                              (reverse ? "" : "; driving backwards needs `reverse`"));
}

void require_request(const PlanRequest& request, const PlanLimits& limits, const Vehicle& vehicle) {
  require_pose("start pose", request.start, vehicle);
  require_pose("goal pose", request.goal, vehicle);
  if (std::isnan(limits.time)) throw std::invalid_argument("time limit: not a number");
  require_speed("start speed", request.start_speed, request.reverse, vehicle);
  require_speed("goal speed", request.goal_speed, request.reverse, vehicle);
  if (!(request.cusp_cost >= 0.0 && std::isfinite(request.cusp_cost)))
    throw std::invalid_argument("cusp cost: " + shortest_text(request.cusp_cost) + " s, must be finite and >= 0");
}

Pose without_many_turns(const Pose& pose, double distance) {
  const bool has_many = std::abs(pose.heading) * distance > kMostTurned;
  return {pose.x, pose.y, has_many ? wrap_signed(pose.heading) : pose.heading};
}

namespace {

bool have_same_vertices(const World& a, const World& b) {
  return (a.vertices().data() == b.vertices().data() && a.vertices().size() == b.vertices().size()) ||
         std::ranges::equal(a.vertices(), b.vertices());
}

void require_world(const World& world, const Backend& backend) {
  const std::span<const Vec2> asked = world.vertices(), known = backend.world().vertices();
  if (!have_same_vertices(world, backend.world()))
    throw std::invalid_argument("backend: of another world, of " + std::to_string(known.size()) +
                                " vertices; this one has " + std::to_string(asked.size()));
}

}  // namespace

Backend backend_for(const World& world, const World& closed, const Backend& given) {
  if (have_same_vertices(closed, given.world())) return given;
  require_world(world, given);
  std::vector<ObstacleId> removed;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
    if (closed.obstacle_with(world.key_of(o)) == kNone) removed.push_back(o);
  return given.changed(closed, WorldChange(world, closed, removed));
}

void require_same_one_way(const World& before, const World& after) {
  const auto zones_of = [](const World& world) {
    std::vector<const Zone*> zones;
    for (const Zone& zone : world.zones())
      if (std::holds_alternative<OneWay>(zone.rule)) zones.push_back(&zone);
    return zones;
  };
  const std::vector<const Zone*> old = zones_of(before), now = zones_of(after);
  const std::string advice = "; make a planner anew for other one-way zones";
  if (old.size() != now.size())
    throw std::invalid_argument("the worlds have " + std::to_string(old.size()) + " and " + std::to_string(now.size()) +
                                " one-way zones, a change keeps them" + advice);
  for (std::size_t i = 0; i < old.size(); ++i)
    if (old[i]->rule != now[i]->rule || old[i]->area.outer != now[i]->area.outer ||
        old[i]->area.holes != now[i]->area.holes)
      throw std::invalid_argument("one-way zone " + std::to_string(i) + " of the one-way zones differs between the " +
                                  "worlds, a change keeps them" + advice);
}

void require_change(const WorldChange& change, const World& before, const World& after) {
  const std::size_t old_vertices = before.vertices().size(), vertices = after.vertices().size();
  std::size_t stayed = change.vertices_before;
  for (const World::VertexRange& range : change.removed_vertices) stayed -= range.last - range.first;
  std::size_t added = 0;
  for (const World::VertexRange& range : change.added_vertices) added += range.last - range.first;
  if (change.vertices_before != old_vertices || stayed + added != vertices)
    throw std::invalid_argument("the change leads from " + std::to_string(change.vertices_before) + " vertices to " +
                                std::to_string(stayed + added) + ", the worlds have " + std::to_string(old_vertices) +
                                " and " + std::to_string(vertices));
}

}  // namespace arcway::internal
