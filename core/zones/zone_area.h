#pragma once

#include <vector>

#include "arcway/path.h"
#include "arcway/polygon.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

/// The area of one zone, and where motions of F are in it. The border is in the area. Immutable and thread-safe.
class ZoneArea {
 public:
  explicit ZoneArea(const Polygon& area);

  /// The box of its vertices [m].
  [[nodiscard]] const Box& box() const { return box_; }

  /// The distance of a point from the border if it is in the area, else 0 [m].
  [[nodiscard]] double depth_of(const Vec2& point) const;

  /// A part of a segment, by lengths from its start [m].
  struct Stay {
    double from, to;
  };
  /// The parts of a segment in the area, ascending and disjoint. Exact but for SpeedZones' margin at their ends.
  void find_stays(const PathSegment& segment, std::vector<Stay>& stays) const;

 private:
  Box box_;
  SpeedZones zone_;  // of this area alone
};

}  // namespace arcway::internal
