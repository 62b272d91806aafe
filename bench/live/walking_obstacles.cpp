#include "bench/live/walking_obstacles.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/map_file.h"

namespace arcway::internal::bench {
namespace {

constexpr double kSoonest = 2.0, kLatest = 8.0;     // when the vehicle will be where a walk leads [s]
constexpr double kShortest = 2.0, kLongest = 6.0;   // duration of a walk [s]
constexpr double kSlowest = 0.25, kFastest = 0.75;  // speed of a walk, as a share of the vehicle's highest one
constexpr double kAstray = 1.0;                     // by how much a walk leads past the vehicle's way at most [rad]
constexpr std::size_t kNearest = 8;                 // number of obstacles, one of which walks
constexpr std::uint64_t kVanishesOneIn = 4;         // walks

Box box_of(const Polygon& polygon) {
  Box box;
  for (const Vec2& p : polygon.outer) box.extend(p);
  return box;
}

Vec2 middle_of(const Polygon& polygon) {
  const Box box = box_of(polygon);
  return 0.5 * (box.min + box.max);
}

void move(Ring& ring, const Vec2& by) {
  for (Vec2& p : ring) p += by;
}

Polygon moved(Polygon polygon, const Vec2& by) {
  move(polygon.outer, by);
  for (Ring& hole : polygon.holes) move(hole, by);
  return polygon;
}

double braking_length(const Vehicle& vehicle) {
  return 0.5 * vehicle.max_speed() * vehicle.max_speed() / vehicle.max_acceleration();
}

}  // namespace

WalkingObstacles::WalkingObstacles(const World& world, const Vehicle& vehicle, std::uint64_t seed)
    : extent_(world.box()),
      speed_(vehicle.max_speed()),
      room_(braking_length(vehicle) + 2.0 * vehicle.footprint().farthest()),
      random_(seed) {
  std::vector<Polygon> polygons = to_map_file(world).obstacles;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
    obstacles_.push_back({std::move(polygons[o]), world.key_of(o)});
}

MapChange WalkingObstacles::walk_on(double seconds, const Trajectory& driven, double time) {
  appears_ = false;
  if (!(walk_.seconds > 0.0)) walk_ = new_walk(driven, time);
  walk_.seconds -= seconds;
  Obstacle& walker = obstacles_[walk_.obstacle];
  const bool is_last = !(walk_.seconds > 0.0), vanishes = is_last && random_.below(kVanishesOneIn) == 0;
  MapChange change;
  if (vanishes && walker.is_there) {
    walker.is_there = false;
    change.removed.push_back(walker.key);
    return change;
  }
  Polygon after = walker.is_there ? moved(walker.polygon, seconds * walk_.velocity) : walker.polygon;
  if (is_in_the_way(box_of(after), driven.at(time).pose.position())) {
    walk_.seconds = 0.0;
    return change;
  }
  if (walker.is_there) change.removed.push_back(walker.key);
  walker.polygon = after;
  appears_ = !walker.is_there;
  walker.is_there = true;
  change.added.push_back(std::move(after));
  return change;
}

void WalkingObstacles::take_key(const World& after) {
  if (appears_) obstacles_[walk_.obstacle].key = after.key_of(static_cast<ObstacleId>(after.obstacle_count() - 1));
}

WalkingObstacles::Walk WalkingObstacles::new_walk(const Trajectory& driven, double time) {
  const double later = std::min(time + random_.uniform(kSoonest, kLatest), driven.duration());
  const Vec2 target = driven.at(later).pose.position();
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < obstacles_.size(); ++i)
    nearest.emplace_back((middle_of(obstacles_[i].polygon) - target).norm(), i);
  const std::size_t count = std::min(kNearest, nearest.size());
  std::ranges::partial_sort(nearest, nearest.begin() + static_cast<std::ptrdiff_t>(count));
  Walk walk{nearest[random_.below(count)].second, {}, random_.uniform(kShortest, kLongest)};
  const Vec2 way = target - middle_of(obstacles_[walk.obstacle].polygon);
  const double heading = std::atan2(way.y(), way.x()) + random_.uniform(-kAstray, kAstray);
  walk.velocity = random_.uniform(kSlowest, kFastest) * speed_ * direction_of(heading);
  return walk;
}

bool WalkingObstacles::is_in_the_way(const Box& box, const Vec2& vehicle_at) const {
  const bool is_within = extent_.contains(box.min) && extent_.contains(box.max);
  return !is_within || box.grown(room_).contains(vehicle_at);
}

}  // namespace arcway::internal::bench
