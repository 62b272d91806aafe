#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

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

enum class Gear : signed char { kForward = 1, kReverse = -1 };
inline double sign_of(Gear gear) { return gear == Gear::kForward ? 1.0 : -1.0; }

/// A straight line (curvature 0) or a circular arc, driven forwards or backwards.
struct ARCWAY_API PathSegment {
  Pose start;
  double length = 0.0;     ///< [m], >= 0
  double curvature = 0.0;  ///< [1/m], positive where the center lies to the left of the body, in either gear
  Gear gear = Gear::kForward;
  [[nodiscard]] bool is_line() const { return curvature == 0.0; }
  /// Pose at arc length s from the start, 0 <= s <= length; the heading is not wrapped.
  [[nodiscard]] Pose at(double s) const;
  [[nodiscard]] Pose end() const { return at(length); }
  /// The same motion the other way: it sweeps the same area.
  [[nodiscard]] PathSegment reversed() const {
    return {end(), length, curvature, gear == Gear::kForward ? Gear::kReverse : Gear::kForward};
  }
  /// The segment, or the same motion driven forwards.
  [[nodiscard]] PathSegment forwards() const { return gear == Gear::kForward ? *this : reversed(); }
};

/// Segments joined end to start. Where the gear changes the path has a cusp: the vehicle stops there.
using Path = std::vector<PathSegment>;

/// A path with its speeds, as a planner or anyone else claims it.
struct TimedPath {
  Path segments;
  std::vector<double> speed_in;   ///< [m/s], one a segment; or all three empty: of the geometry alone
  std::vector<double> speed_out;  ///< [m/s]
  std::vector<double> durations;  ///< [s]
};

/// The same motion from the end to the start, in the other gear.
ARCWAY_API Path reversed(std::span<const PathSegment> path);

/// The same motion in fewer segments: neighbors on one line or circle, less than a full turn in all, become one.
ARCWAY_API Path merged(std::span<const PathSegment> path);

/// How often the gear changes.
ARCWAY_API std::size_t cusps_of(std::span<const PathSegment> path);

/// Total length [m].
ARCWAY_API double length_of(std::span<const PathSegment> path);

}  // namespace arcway
