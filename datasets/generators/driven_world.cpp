#include "arcway/datasets/driven_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "core/base/shortest_text.h"
#include "core/model/body_size.h"
#include "core/motion/clearance.h"
#include "core/motion/speed_profile.h"
#include "core/motion/travel_time_lower_bound.h"
#include "datasets/generators/drive_clearance.h"
#include "datasets/generators/layout.h"
#include "datasets/io/random.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kLeastClearance = 1e-4, kMostClearance = 10.0;  // [m]

// Drives have from 4 to 10 arcs and lines: about as many decisions as a way through a few rooms takes.
constexpr std::size_t kLeastSegments = 4, kSegmentChoices = 7;
constexpr double kShortestLine = 0.5, kLongestLine = 5.0, kLongestArc = 12.0;  // [body lengths]
constexpr double kSmallestTurn = 0.1, kLargestTurn = 2.4;                      // turn of one arc [rad]
constexpr double kGearChangeShare = 0.3;  // share of a drive's joints with a gear change, besides the middle one

constexpr std::size_t kScatteredDraws = 60,
                      kHuggingDraws = 100;  // draws of polygons, of which fewer keep away from the drive
constexpr double kSmallestObstacle = 0.1, kLargestObstacle = 0.6;  // radii [body lengths]
constexpr int kSlideHalvings = 14;                                 // to a millimeter where a body is some meters long
constexpr double kSmallestCell = 0.3, kLargestCell = 1.5;          // sides [body widths]
constexpr double kMostCells = 100.0;                               // along the longer side of the map
constexpr double kSmallestRoom = 1.5, kLargestRoom = 4.0;          // sides [body lengths]
constexpr double kWall = 0.1, kWallPiece = 0.125;  // thickness, piece that is there or not [body widths]

[[noreturn]] void refuse(const std::string& parameter, const std::string& value, const std::string& limit) {
  throw std::invalid_argument("driven world: " + parameter + " is " + value + ", must be " + limit);
}

// What obstacles and lengths are sized by [m].
struct BodySize {
  double length, width;
};

// A vehicle, its drive, and the map that grows beside it.
struct Scene {
  Random random;
  Vehicle vehicle;
  BodySize body;
  double clearance;
  Path drive;
  Box box;  // box of the map
  std::vector<Polygon> obstacles;

  [[nodiscard]] bool is_clear(const Ring& ring) const {
    return detail::keeps_away({ring, {}}, drive, vehicle, clearance);
  }
  void add(Ring ring) { obstacles.push_back({std::move(ring), {}}); }
};

double random_curvature(Random& random, const Vehicle& vehicle) {
  const std::uint64_t choice = random.below(3);
  if (choice == 0) return 0.0;
  const double share = choice == 1 ? 1.0 : random.uniform(0.05, 1.0);
  const Side side = random.below(2) == 0 ? Side::kLeft : Side::kRight;
  return sign_of(side) * share * (1.0 / vehicle.min_turning_radius(side));
}

double random_length(Random& random, double curvature, double body_length) {
  if (curvature == 0.0) return random.uniform(kShortestLine, kLongestLine) * body_length;
  const double turned = random.uniform(kSmallestTurn, kLargestTurn) / std::abs(curvature);
  return std::min(turned, kLongestArc * body_length);
}

Path random_drive(Random& random, const Vehicle& vehicle, bool both_gears) {
  const std::size_t segments = kLeastSegments + static_cast<std::size_t>(random.below(kSegmentChoices));
  Pose pose{0.0, 0.0, random.uniform(0.0, kTwoPi)};
  Gear gear = Gear::kForward;
  Path drive;
  for (std::size_t i = 0; i < segments; ++i) {
    const bool changes = both_gears && i > 0 && (i == segments / 2 || random.uniform() < kGearChangeShare);
    if (changes) gear = gear == Gear::kForward ? Gear::kReverse : Gear::kForward;
    const double curvature = random_curvature(random, vehicle);
    const double length = random_length(random, curvature, body_length(vehicle));
    drive.push_back({pose, length, curvature, gear});
    pose = drive.back().end();
  }
  return drive;
}

// Vertices in turn around the center, never half a turn apart: simple.
Ring random_polygon(Random& random, const Vec2& center, double radius) {
  const std::size_t vertices = 3 + static_cast<std::size_t>(random.below(5));
  Ring ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double turns = (static_cast<double>(i) + random.uniform(0.25, 0.75)) / static_cast<double>(vertices);
    ring.emplace_back(center + unit_vector_at(turns) * (radius * random.uniform(0.5, 1.0)));
  }
  return ring;
}

double random_radius(Scene& scene) {
  return scene.random.uniform(kSmallestObstacle, kLargestObstacle) * scene.body.length;
}

void scatter(Scene& scene) {
  for (std::size_t i = 0; i < kScatteredDraws; ++i) {
    // One after the other: the order of two draws within one call is the compiler's.
    const double y = scene.random.uniform(scene.box.min.y(), scene.box.max.y());
    const double x = scene.random.uniform(scene.box.min.x(), scene.box.max.x());
    Ring ring = random_polygon(scene.random, {x, y}, random_radius(scene));
    if (scene.is_clear(ring)) scene.add(std::move(ring));
  }
}

// Slides polygons towards poses of the drive, each along its own ray, until they would come too near.
void hug(Scene& scene) {
  for (std::size_t i = 0; i < kHuggingDraws; ++i) {
    const PathSegment& segment = scene.drive[scene.random.below(scene.drive.size())];
    const Vec2 place = segment.at(scene.random.uniform() * segment.length).position();
    const Vec2 ray = scene.random.unit_vector();
    const double radius = random_radius(scene);
    const Ring shape = random_polygon(scene.random, Vec2(0.0, 0.0), radius);
    const auto moved = [&](double distance) {
      Ring ring = shape;
      for (Vec2& vertex : ring) vertex += place + ray * distance;
      return ring;
    };
    double near = 0.0, far = scene.body.length + scene.vehicle.parameters().wheelbase + radius + 2.0 * scene.clearance;
    if (!scene.is_clear(moved(far))) continue;
    for (int halving = 0; halving < kSlideHalvings; ++halving) {
      const double middle = 0.5 * (near + far);
      (scene.is_clear(moved(middle)) ? far : near) = middle;
    }
    scene.add(moved(far));
  }
}

// Rectangles of the consecutive pieces of a row that are clear; ring_of gives that of pieces [from, to).
template <typename RingOf>
void add_clear_runs(Scene& scene, std::size_t pieces, const RingOf& ring_of) {
  std::size_t from = 0;
  for (std::size_t i = 0; i <= pieces; ++i) {
    if (i < pieces && scene.is_clear(ring_of(i, i + 1))) continue;
    if (from < i) scene.add(ring_of(from, i));
    from = i + 1;
  }
}

void carve(Scene& scene) {
  const Vec2 size = scene.box.max - scene.box.min;
  const double cell =
      std::max(scene.random.uniform(kSmallestCell, kLargestCell) * scene.body.width, size.maxCoeff() / kMostCells);
  const auto count = [cell](double side) { return static_cast<std::size_t>(std::ceil(side / cell)); };
  const auto at = [cell](double origin, std::size_t i) { return origin + cell * static_cast<double>(i); };
  const Vec2 origin = scene.box.min;
  for (std::size_t row = 0; row < count(size.y()); ++row) {
    add_clear_runs(scene, count(size.x()), [&](std::size_t from, std::size_t to) {
      return detail::box_ring(at(origin.x(), from), at(origin.y(), row), at(origin.x(), to), at(origin.y(), row + 1));
    });
  }
}

// Walls across one axis (0: they stand at values of x), over the whole map.
void add_walls(Scene& scene, Eigen::Index axis) {
  const Eigen::Index along = 1 - axis;
  const double thickness = kWall * scene.body.width, piece = kWallPiece * scene.body.width;
  const double begin = scene.box.min[along], side = scene.box.max[along] - begin;
  const double across = scene.box.max[axis] - scene.box.min[axis];
  const auto room = [&] {  // never so large that no wall is left
    return std::min(scene.random.uniform(kSmallestRoom, kLargestRoom) * scene.body.length, 0.5 * across);
  };
  double at = scene.box.min[axis] + room();
  while (at < scene.box.max[axis]) {
    add_clear_runs(scene, static_cast<std::size_t>(std::ceil(side / piece)), [&](std::size_t from, std::size_t to) {
      Vec2 low, high;
      low[axis] = at, high[axis] = at + thickness;
      low[along] = begin + piece * static_cast<double>(from), high[along] = begin + piece * static_cast<double>(to);
      return detail::box_ring(low.x(), low.y(), high.x(), high.y());
    });
    at += room();
  }
}

void build_rooms(Scene& scene) {
  add_walls(scene, 0);
  add_walls(scene, 1);
}

void check(const DrivenParameters& parameters) {
  const std::size_t robots = driven_robots().size();
  if (parameters.robot < 1 || parameters.robot > robots)
    refuse("robot", std::to_string(parameters.robot), "from 1 to " + std::to_string(robots));
  if (!(parameters.clearance >= kLeastClearance && parameters.clearance <= kMostClearance)) {
    refuse("clearance", shortest_text(parameters.clearance) + " m",
           "from " + shortest_text(kLeastClearance) + " m to " + shortest_text(kMostClearance) + " m");
  }
}

}  // namespace

const char* name_of(DrivenKind kind) {
  switch (kind) {
    case DrivenKind::kScattered:
      return "scattered";
    case DrivenKind::kHugging:
      return "hugging";
    case DrivenKind::kCarved:
      return "carved";
    case DrivenKind::kRooms:
      return "rooms";
  }
  return "unknown";
}

namespace {

// The forklift, the AMR, the car and the bus with other bodies, about F.
void add_other_bodies(std::vector<DrivenRobot>& robots) {
  const auto with = [&robots](std::size_t number, const char* name, std::vector<Ring> footprint) {
    VehicleParameters parameters = robots[number - 1].parameters;
    parameters.footprint = std::move(footprint);
    robots.push_back({name, std::move(parameters)});
  };
  with(3, "pallet",
       {{{-1.8, -0.55}, {0.2, -0.55}, {0.2, -0.4}, {1.4, -0.4}, {1.4, 0.4}, {0.2, 0.4}, {0.2, 0.55}, {-1.8, 0.55}}});
  with(
      4, "octagon",
      {{{0.8, -0.35}, {1.0, -0.15}, {1.0, 0.15}, {0.8, 0.35}, {0.0, 0.35}, {-0.2, 0.15}, {-0.2, -0.15}, {0.0, -0.35}}});
  with(6, "beside", {{{-0.95, -0.6}, {3.75, -0.6}, {3.75, 1.3}, {-0.95, 1.3}}});
  with(8, "coach", {{{-3.4, -1.275}, {8.4, -1.275}, {8.9, -0.9}, {8.9, 0.9}, {8.4, 1.275}, {-3.4, 1.275}}});
  with(4, "mower",
       {{{-0.2, -0.35}, {1.0, -0.35}, {1.0, 0.35}, {-0.2, 0.35}},
        {{-0.6, -0.9}, {-0.3, -0.9}, {-0.3, -0.1}, {-0.6, -0.1}}});
}

}  // namespace

std::span<const DrivenRobot> driven_robots() {
  static const std::vector<DrivenRobot> robots = [] {
    const VehicleParameters paper;
    VehicleParameters pivot = paper, table = paper, rover, forklift, amr, car, bus, tractor;
    pivot.max_steering_angle = 1.5, pivot.turn_speed = ConstantTurnSpeed{2.0};
    table.turn_speed = TurnSpeedTable{{{1.0, 1.0}, {3.0, 4.0}, {10.0, 9.0}}};
    rover = {0.6, 0.45, 0.4, Steering::kSymmetric, 0.6, 1.5, ConstantTurnSpeed{1.0}, 0.8, 2.0, 1e-3};
    forklift = {2.4, 1.1, 1.5, Steering::kRear, 1.2, 4.0, ConstantTurnSpeed{1.5}, {}, 1.5, 1e-3};
    amr = {1.2, 0.7, 0.8, Steering::kFront, 0.7, 2.0, LateralAccelerationLimit{0.8}, {}, 1.0, 1e-3};
    car = {4.7, 1.9, 2.8, Steering::kFront, 0.61, 14.0, ConstantTurnSpeed{5.0}, {}, 3.0, 1e-3};
    VehicleParameters touring = car;
    touring.turn_speed = LateralAccelerationLimit{2.0}, touring.max_acceleration = 2.0;
    bus = {12.0, 2.55, 6.0, Steering::kFront, 0.75, 20.0, LateralAccelerationLimit{1.5}, 3.0, 1.2, 1e-3};
    tractor = {3.6, 1.6, 3.0, Steering::kFront, 0.1, 12.0, ConstantTurnSpeed{8.0}, {}, 50.0, 1e-3};
    std::vector<DrivenRobot> all{{"pivot", pivot},     {"rover", rover}, {"forklift", forklift},
                                 {"amr", amr},         {"paper", table}, {"car", car},
                                 {"touring", touring}, {"bus", bus},     {"tractor", tractor}};
    add_other_bodies(all);
    return all;
  }();
  return robots;
}

DrivenWorld generate_driven_world(const DrivenParameters& parameters) {
  check(parameters);
  const VehicleParameters& robot = driven_robots()[parameters.robot - 1].parameters;
  const Vehicle vehicle(robot);
  Scene scene{
      Random(parameters.seed), vehicle, {body_length(vehicle), body_width(vehicle)}, parameters.clearance, {}, {}, {}};
  scene.drive = random_drive(scene.random, vehicle, parameters.both_gears);
  scene.box = detail::box_of(scene.drive, vehicle.footprint(), parameters.clearance);
  switch (parameters.kind) {
    case DrivenKind::kScattered:
      scatter(scene);
      break;
    case DrivenKind::kHugging:
      hug(scene);
      break;
    case DrivenKind::kCarved:
      carve(scene);
      break;
    case DrivenKind::kRooms:
      build_rooms(scene);
      break;
  }
  MapFile map;
  map.obstacles = std::move(scene.obstacles);
  map.bounds = detail::box_ring(scene.box.min.x(), scene.box.min.y(), scene.box.max.x(), scene.box.max.y());
  map.start = scene.drive.front().start;
  map.goal = scene.drive.back().end();
  return {std::move(map), robot, std::move(scene.drive)};
}

PlanResult plan_of_drive(const DrivenWorld& world) {
  const Vehicle vehicle(world.robot);
  const bool reverses = cusps_of(world.drive) > 0;
  PlanResult result;
  result.status = PlanStatus::kSolved;
  result.start = world.drive.front().start;
  result.goal = world.drive.back().end();
  const SpeedProfile profile = speed_profile(world.drive, vehicle);
  for (std::size_t i = 0; i < world.drive.size(); ++i)
    result.segments.push_back({world.drive[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
  result.travel_time = profile.total_time;
  result.length = length_of(world.drive);
  const double straight = (result.goal.position() - result.start.position()).norm();
  result.lower_bound = travel_time_lower_bound(result.start, result.goal, straight, vehicle, reverses);
  result.min_clearance = std::numeric_limits<double>::infinity();
  const World obstacles = to_world(world.map, "driven world");
  for (std::size_t i = 0; i < world.drive.size(); ++i) {
    const double clearance = clearance_along(world.drive[i], vehicle.body(), obstacles).distance;
    if (clearance >= result.min_clearance) continue;
    result.min_clearance = clearance;
    result.clearance_segment = world.drive[i];
    result.clearance_index = i;
  }
  return result;
}

}  // namespace arcway
