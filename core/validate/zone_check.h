#pragma once

#include <optional>
#include <vector>

#include "arcway/path.h"
#include "arcway/zone.h"

namespace arcway::internal {

/// The speeds along a segment, of a motion that accelerates, holds its top speed and brakes.
struct SegmentSpeeds {
  double in, out;  ///< at the ends [m/s]
  double top;      ///< the speed that is held [m/s]; infinity: none
  double acceleration;
  double length;

  [[nodiscard]] double at(double s) const;
  /// The place between two others where the vehicle is fastest.
  [[nodiscard]] double fastest_between(double s0, double s1) const;
};

/// The top speed of a motion along a segment that takes `duration` [m/s], by bisection. `speeds.top` is the limit.
double top_speed_within(const SegmentSpeeds& speeds, double duration);

/// Finds where motions break the rule of a zone, for the validator. A segment is halved until each part lies outside,
/// or inside by more than kBorder, or keeps the rule anyway. Places nearer to the border may be in the zone or not. No
/// decision is shared with the planner. O(edges) a part.
class ZoneCheck {
 public:
  static constexpr double kBorder = 1e-4;  ///< [m]

  explicit ZoneCheck(const Polygon& area);

  /// The arc length of a place inside the zone where the speed is above a limit [m]; nothing if there is none.
  [[nodiscard]] std::optional<double> too_fast(const PathSegment& segment, const SegmentSpeeds& speeds,
                                               double limit) const;

  /// The arc length of a place inside the zone where the direction of motion differs from `heading` by more than `most`
  /// [m]; nothing if there is none.
  [[nodiscard]] std::optional<double> against(const PathSegment& segment, double heading, double most) const;

 private:
  // Whether a part of a segment keeps within kBorder of one edge.
  [[nodiscard]] bool is_along_border(const PathSegment& segment, double s0, double s1) const;
  // How far inside the zone a point lies [m]; negative outside.
  [[nodiscard]] double depth(const Vec2& point) const;

  std::vector<LineSegment> edges_;
};

}  // namespace arcway::internal
