#pragma once

#include <span>
#include <vector>

#include "core/geometry/vec2.h"

namespace [[gnu::visibility("default")]] arcway {

/// Position of the reference point F [m] and heading of the body [rad, counter-clockwise from +x].
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  [[nodiscard]] Vec2 position() const { return {x, y}; }
};

enum class Side : signed char { kLeft = 1, kRight = -1 };
inline Side opposite(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
inline double sign_of(Side side) { return side == Side::kLeft ? 1.0 : -1.0; }

/// A straight line (curvature 0) or a circular arc, driven forwards.
struct PathSegment {
  Pose start;
  double length = 0.0;     ///< [m], >= 0
  double curvature = 0.0;  ///< [1/m], left positive
  [[nodiscard]] bool is_line() const { return curvature == 0.0; }
  /// Pose at arc length s from the start, 0 <= s <= length; the heading is not wrapped.
  [[nodiscard]] Pose at(double s) const;
  [[nodiscard]] Pose end() const { return at(length); }
};

/// Segments joined end to start.
using Path = std::vector<PathSegment>;

/// Total length [m].
double length_of(std::span<const PathSegment> path);

}  // namespace arcway
