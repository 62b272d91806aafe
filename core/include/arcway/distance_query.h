#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "arcway/export.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway {

/// The boundary point nearest to a query point. The distance is correct to a few units in the last place. Of several
/// nearest edges the one of smallest id is given.
struct ARCWAY_API ClosestPoint {
  double distance = std::numeric_limits<double>::infinity();  ///< from the boundary, never negative [m]
  Vec2 point{0.0, 0.0};
  VertexId edge = kNone;  ///< that has the point; kNone in a world without edges
};

/// Distances of points from the obstacles' boundaries, and the obstacles that contain them. All implementations give
/// the same bits. Thread-safe; a call does not allocate. Coordinates must be in the exact range of vec2.h [m]. All
/// functions throw std::invalid_argument if sizes differ or a coordinate is out of range, naming its index.
class ARCWAY_API DistanceQuery {
 public:
  virtual ~DistanceQuery() = default;

  /// The nearest boundary point of each query point, whether that lies inside an obstacle or outside.
  void closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const;
  [[nodiscard]] ClosestPoint closest(const Vec2& point) const;

  /// closer[i] = 1 if some boundary point is nearer to points[i] than distances[i] [m], else 0. Cheaper than `closest`.
  /// @throws std::invalid_argument if a distance is not a number.
  void closer_than(std::span<const Vec2> points, std::span<const double> distances,
                   std::span<std::uint8_t> closer) const;

  /// The region of smallest id that has the point strictly inside, or kNone. For the bounds: strictly outside of them.
  /// Exact.
  void containing(std::span<const Vec2> points, std::span<ObstacleId> result) const;
  [[nodiscard]] ObstacleId containing(const Vec2& point) const;

 private:
  virtual void do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const = 0;
  virtual void do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                              std::span<std::uint8_t> closer) const = 0;
  virtual void do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const = 0;
};

}  // namespace arcway
