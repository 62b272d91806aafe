#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/trajectory.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "datasets/io/random.h"

namespace arcway::internal::bench {

/// A change of a map, as Planner::with_obstacles takes it.
struct MapChange {
  std::vector<ObstacleKey> removed;
  std::vector<Polygon> added;
};

/// The obstacles of a map while a vehicle drives through it. One at a time walks towards where the vehicle will be; at
/// the end of its walk it stays, or vanishes until a later walk. None comes so near that the vehicle could not stop.
/// The same seed and the same motions of the vehicle give the same changes.
class WalkingObstacles {
 public:
  struct Obstacle {
    Polygon polygon;
    ObstacleKey key;
    bool is_there = true;
  };

  WalkingObstacles(const World& world, const Vehicle& vehicle, std::uint64_t seed);

  /// What changes within some seconds: at most one obstacle. `take_key` must follow before the next call.
  /// @param driven  the vehicle's motion, of which it is at `time` [s].
  MapChange walk_on(double seconds, const Trajectory& driven, double time);
  /// Takes the key of the obstacle that appeared in the last change, if any, from the world after it. One that moves
  /// keeps its key.
  void take_key(const World& after);

  /// All obstacles in their first order, also those that have vanished.
  [[nodiscard]] std::span<const Obstacle> obstacles() const { return obstacles_; }

 private:
  struct Walk {
    std::size_t obstacle;
    Vec2 velocity;         // [m/s]
    double seconds = 0.0;  // that are left
  };

  [[nodiscard]] Walk new_walk(const Trajectory& driven, double time);
  // Whether the vehicle at a place could not stop before an obstacle in this box, or the box leaves the map.
  [[nodiscard]] bool is_in_the_way(const Box& box, const Vec2& vehicle_at) const;

  std::vector<Obstacle> obstacles_;
  Box extent_;    // of the map
  double speed_;  // highest one of the vehicle [m/s]
  double room_;   // that the vehicle needs to stop in [m]
  Random random_;
  Walk walk_{};
  bool appears_ = false;  // whether the walking obstacle was not there before the last change
};

}  // namespace arcway::internal::bench
