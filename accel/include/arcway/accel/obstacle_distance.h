#pragma once

#include <limits>
#include <memory>
#include <span>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// The shortest distance between two obstacles, or two sets of obstacles.
struct ARCWAY_API ObstacleDistance {
  double distance =
      std::numeric_limits<double>::infinity();  ///< between the boundaries [m]; 0 if and only if they meet
  VertexId edge_a = kNone;                      ///< the nearest edges: of several pairs the one with the
  VertexId edge_b = kNone;                      ///< smallest edge_a, then the smallest edge_b
};

struct ObstaclePair {
  ObstacleId a, b;
};

/// Minimum distances between obstacles (D_min of the paper), where the bounds count as an obstacle.
///
/// Uses point queries with a shrinking radius. Distances are those of geometry/distance.h, so the result equals that of
/// trying all pairs of edges, bit for bit. Thread-safe.
///
///     const ObstacleDistances distances(world);
///     const double room = distances.between(left_of_path, right_of_path).distance;
class ARCWAY_API ObstacleDistances {
 public:
  /// Builds one Embree scene of the world's edges.
  /// @throws std::runtime_error if Embree cannot be started.
  explicit ObstacleDistances(const World& world);
  ~ObstacleDistances();
  ObstacleDistances(ObstacleDistances&&) noexcept;
  ObstacleDistances& operator=(ObstacleDistances&&) noexcept;

  /// Distance between two sets [m]; infinity if one is empty, 0 if they share an obstacle. About O(log n + edges near
  /// by) for each edge of `a`; the executor shares out the edges.
  /// @throws std::invalid_argument naming an id that is out of range.
  [[nodiscard]] ObstacleDistance between(std::span<const ObstacleId> a, std::span<const ObstacleId> b,
                                         const Executor& executor = SerialExecutor()) const;

  /// Distance of each pair [m]; the executor shares out the pairs.
  /// @throws std::invalid_argument if the sizes differ, or naming an id that is out of range.
  void between(std::span<const ObstaclePair> pairs, std::span<ObstacleDistance> result,
               const Executor& executor = SerialExecutor()) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;
};

}  // namespace arcway
