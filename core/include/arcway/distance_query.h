#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "arcway/export.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway {

/// The nearest point of all region boundaries. `distance` is rounded correctly up to a few units in
/// the last place; of several nearest edges the one of smallest id is given.
struct ARCWAY_API ClosestPoint {
  double distance = std::numeric_limits<double>::infinity();  ///< to the boundary, never negative [m]
  Vec2 point{0.0, 0.0};
  VertexId edge = kNone;  ///< none in a world without edges
};

/// How far are points from the obstacles, and inside which one do they lie?
/// Every implementation gives the same bits. Thread-safe; a call does not allocate.
/// Coordinates must be finite and in the range of predicates.h. All functions throw std::invalid_argument if sizes
/// differ or a coordinate is out of range, naming its index.
class ARCWAY_API DistanceQuery {
 public:
  virtual ~DistanceQuery() = default;

  /// Nearest boundary point of each query point, its inside or outside not regarded.
  void closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const;
  [[nodiscard]] ClosestPoint closest(const Vec2& point) const;

  /// closer[i] = 1 if some boundary point lies nearer than distances[i] to points[i]. Cheaper than `closest`.
  /// @throws std::invalid_argument if a distance is not a number, too.
  void closer_than(std::span<const Vec2> points, std::span<const double> distances,
                   std::span<std::uint8_t> closer) const;

  /// The first region (in id order) that has the point strictly inside (for the bounds: strictly outside of them), or
  /// kNone. Exact.
  void containing(std::span<const Vec2> points, std::span<ObstacleId> result) const;
  [[nodiscard]] ObstacleId containing(const Vec2& point) const;

 private:
  virtual void do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const = 0;
  virtual void do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                              std::span<std::uint8_t> closer) const = 0;
  virtual void do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const = 0;
};

}  // namespace arcway
