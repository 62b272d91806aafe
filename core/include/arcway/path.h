#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arcway/export.h"
#include "arcway/text.h"
#include "arcway/vec2.h"

namespace arcway {

/// Position of the reference point F [m] and heading of the body [rad], counter-clockwise from +x.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  [[nodiscard]] Vec2 position() const { return {x, y}; }
  /// Whether all numbers are the same: headings are not compared modulo a turn.
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// "(x, y, heading)" [m, m, rad]. Each number reads back to the same double.
ARCWAY_API std::string to_string(const Pose& pose);

/// The side of a turn's center, seen in the direction of the body.
enum class Side : signed char { kLeft = 1, kRight = -1 };
inline Side opposite(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
inline double sign_of(Side side) { return side == Side::kLeft ? 1.0 : -1.0; }
/// "left" or "right".
ARCWAY_API std::string to_string(Side side);

/// The direction of travel along the body.
enum class Gear : signed char { kForward = 1, kReverse = -1 };
inline double sign_of(Gear gear) { return gear == Gear::kForward ? 1.0 : -1.0; }
/// "forwards" or "backwards".
ARCWAY_API std::string to_string(Gear gear);

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

/// "line of 3 m forwards from (1, 2, 0)", "left arc of 2 m with radius 1.5 m backwards from (4, 2, 0)".
ARCWAY_API std::string to_string(const PathSegment& segment);

/// Segments, each starting where the one before ends. Where the gear changes the path has a cusp, at which the vehicle
/// stops.
///
/// It is a vector of segments: `path[i]` is segment i. `path.at(s)` is the pose at arc length s [m], not a segment.
class ARCWAY_API Path : public std::vector<PathSegment> {
 public:
  using std::vector<PathSegment>::vector;
  Path(std::vector<PathSegment> segments) : std::vector<PathSegment>(std::move(segments)) {}

  /// Segment i. An index that is not whole is an arc length by mistake, and does not compile: see `at`.
  template <std::integral Index>
  [[nodiscard]] PathSegment& operator[](Index i) {
    return std::vector<PathSegment>::operator[](static_cast<std::size_t>(i));
  }
  template <std::integral Index>
  [[nodiscard]] const PathSegment& operator[](Index i) const {
    return std::vector<PathSegment>::operator[](static_cast<std::size_t>(i));
  }

  /// The pose at arc length s from the start [m], 0 <= s <= length(). The heading is that of PathSegment::at. At a
  /// joint it is the start of the later segment. O(segments).
  /// @throws std::out_of_range if s is outside, or the path has no segments.
  [[nodiscard]] Pose at(double s) const;
  /// The sum of the segments' lengths [m]. O(segments).
  [[nodiscard]] double length() const;
};

/// "3 segments, 12.3 m, 1 gear change".
ARCWAY_API std::string to_string(const Path& path);

/// A segment with its speeds. Between them the speed changes as fast as the vehicle and its limits allow.
struct TimedSegment {
  PathSegment segment;
  double speed_in = 0.0;   ///< [m/s]
  double speed_out = 0.0;  ///< [m/s]
  double duration = 0.0;   ///< [s]
};
/// The segment, "from 0 to 12 m/s in 1.5 s".
ARCWAY_API std::string to_string(const TimedSegment& segment);

/// A path with the speeds and durations that someone claims for it. Either all three arrays have one entry a segment,
/// or all are empty and only the geometry is claimed.
struct TimedPath {
  Path segments;
  std::vector<double> speed_in;   ///< at the start of each segment [m/s]
  std::vector<double> speed_out;  ///< at the end of each segment [m/s]
  std::vector<double> durations;  ///< [s]
};

/// The segments without speeds.
ARCWAY_API Path path_of(std::span<const TimedSegment> segments);
/// The segments with speeds and durations, as the validator takes them.
ARCWAY_API TimedPath timed_path_of(std::span<const TimedSegment> segments);

/// The motion from end to start in the other gear. It sweeps the same area.
ARCWAY_API Path reversed(std::span<const PathSegment> path);

/// The path in fewer segments: neighbors on one line or circle become one segment, up to a full turn.
ARCWAY_API Path merged(std::span<const PathSegment> path);

/// The number of gear changes.
ARCWAY_API std::size_t cusps_of(std::span<const PathSegment> path);

/// The length of a path [m].
ARCWAY_API double length_of(std::span<const PathSegment> path);

/// Most points or states that a path is sampled at, so that a step that is far too small cannot use up all memory.
inline constexpr double kMostSamplingSteps = 1e7;

/// Positions of the reference point along a path [m], at most `step` apart. The joints and both ends are among them,
/// each once. Each segment is divided evenly. An empty path has none. O(points).
/// @param step  [m], > 0; infinity gives the joints alone.
/// @throws std::invalid_argument naming the value and the limit, unless the step is positive and gives at most
///   kMostSamplingSteps points.
ARCWAY_API std::vector<Vec2> polyline(std::span<const PathSegment> path, double step);

}  // namespace arcway
