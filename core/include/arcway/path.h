#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

/// Position of the reference point F [m] and heading of the body [rad], counter-clockwise from +x.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  [[nodiscard]] Vec2 position() const { return {x, y}; }
};

/// The side of a turn's center, seen in the direction of the body.
enum class Side : signed char { kLeft = 1, kRight = -1 };
inline Side opposite(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
inline double sign_of(Side side) { return side == Side::kLeft ? 1.0 : -1.0; }

/// The direction of travel along the body.
enum class Gear : signed char { kForward = 1, kReverse = -1 };
inline double sign_of(Gear gear) { return gear == Gear::kForward ? 1.0 : -1.0; }

/// A straight line (curvature 0) or a circular arc, driven forwards or backwards.
struct ARCWAY_API PathSegment {
  Pose start;
  double length = 0.0;     ///< [m], >= 0
  double curvature = 0.0;  ///< [1/m], positive where the center lies to the left of the body, in either gear
  Gear gear = Gear::kForward;
  [[nodiscard]] bool is_line() const { return curvature == 0.0; }
  /// The pose at arc length s from the start [m], 0 <= s <= length. The heading is not wrapped.
  [[nodiscard]] Pose at(double s) const;
  [[nodiscard]] Pose end() const { return at(length); }
  /// The motion from end to start in the other gear. It sweeps the same area.
  [[nodiscard]] PathSegment reversed() const {
    return {end(), length, curvature, gear == Gear::kForward ? Gear::kReverse : Gear::kForward};
  }
  /// The motion driven forwards: the segment itself, or its reverse.
  [[nodiscard]] PathSegment forwards() const { return gear == Gear::kForward ? *this : reversed(); }
};

/// Segments, each starting where the one before ends. Where the gear changes the path has a cusp, at which the vehicle
/// stops.
using Path = std::vector<PathSegment>;

/// A path with the speeds and durations that someone claims for it. Either all three arrays have one entry a segment,
/// or all are empty and only the geometry is claimed.
struct TimedPath {
  Path segments;
  std::vector<double> speed_in;   ///< at the start of each segment [m/s]
  std::vector<double> speed_out;  ///< at the end of each segment [m/s]
  std::vector<double> durations;  ///< [s]
};

/// The motion from end to start in the other gear. It sweeps the same area.
ARCWAY_API Path reversed(std::span<const PathSegment> path);

/// The path in fewer segments: neighbors on one line or circle become one segment, up to a full turn.
ARCWAY_API Path merged(std::span<const PathSegment> path);

/// The number of gear changes.
ARCWAY_API std::size_t cusps_of(std::span<const PathSegment> path);

/// The length of a path [m].
ARCWAY_API double length_of(std::span<const PathSegment> path);

}  // namespace arcway
