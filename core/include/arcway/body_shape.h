#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway {

/// The outline of a body as one or several simple polygons about its reference point F, heading along +x [m]. F may lie
/// anywhere, off the body too. Immutable.
class ARCWAY_API BodyShape {
 public:
  /// Rings may have either orientation, and a last vertex that repeats the first one. Corners on the line through their
  /// neighbors are left out.
  /// @throws std::invalid_argument naming ring, vertex and value. Each ring needs 3 distinct corners and an area, and
  /// may
  ///   neither cross nor touch itself. Coordinates must be finite and in the range of a vehicle's numbers. Rings may
  ///   touch each other, but not overlap.
  explicit BodyShape(std::vector<Ring> parts);

  /// The rings, counter-clockwise.
  [[nodiscard]] std::span<const Ring> parts() const { return parts_; }
  /// Convex polygons, counter-clockwise, whose union is the body. Their corners are those of the parts.
  [[nodiscard]] std::span<const Ring> pieces() const { return pieces_; }
  /// A point well inside of each part.
  [[nodiscard]] std::span<const Vec2> inner_points() const { return inner_points_; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// Whether the body is one upright rectangle, which is its bounds.
  [[nodiscard]] bool is_rectangle() const { return is_rectangle_; }
  /// The diameter of a disc in one of the parts: the largest to a thousandth, rounded down [m].
  [[nodiscard]] double disc() const { return disc_; }
  /// An upright rectangle in one of the parts: the largest found, rounded down. Empty if none is found in a very thin
  /// body.
  [[nodiscard]] const Box& core() const { return core_; }

 private:
  std::vector<Ring> parts_;
  std::vector<Ring> pieces_;
  std::vector<Vec2> inner_points_;
  Box bounds_;
  bool is_rectangle_ = false;
  double disc_ = 0.0;
  Box core_;
};

/// A body grown by a margin on all sides, as queries are asked about it. Immutable.
struct ARCWAY_API GrownBody {
  /// Each piece is grown by moving its sides outwards. Acute corners that would reach further than three margins are
  /// cut off. The body grown by a + b contains the body grown by a, and every disc of radius b about a point of that.
  /// @param margin  [m], >= 0.
  GrownBody(const BodyShape& shape, double margin);

  std::vector<Ring> outline;       ///< the parts of the shape, not grown
  std::vector<Ring> pieces;        ///< convex polygons, counter-clockwise, whose union is the grown body
  std::vector<Vec2> inner_points;  ///< of the shape: one a connected part, or more
  Box bounds;                      ///< of the pieces
};

}  // namespace arcway
