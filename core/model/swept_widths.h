#pragma once

#include <span>
#include <vector>

#include "core/model/swept_outline.h"

namespace arcway::internal {

/// Condition (7) for a body of polygons that turns to one side: the radii at which it sweeps less than a width.
///
/// Between two radii at which the annulus is bounded by other corners or sides, its width has at most one extremum. So
/// there are few knots between which it rises or falls throughout. VEHICLES.md 1.4. Immutable.
class SweptWidths {
 public:
  /// O(n^2) candidates for knots with O(n) each, for n corners.
  /// @param rings  simple polygons about F, of either orientation, whose union is the body.
  SweptWidths(std::span<const Ring> rings, Side side);

  /// O(n). Precondition: radius >= 0.
  [[nodiscard]] double at(double radius) const { return outline_.width(radius); }
  /// All radii >= `least` at which the width is below `limit`, ascending. At the ends it is below, too, and is not next
  /// to them. The last end may be infinite. O(n) a knot.
  [[nodiscard]] std::vector<RadiusRange> below(double limit, double least) const;

 private:
  [[nodiscard]] std::vector<double> candidates() const;
  void add_extrema(const SweptOutline::Bounds& bounds);
  [[nodiscard]] double far_radius(double from, double limit, bool fits) const;
  [[nodiscard]] double last_below(double limit, double from, double towards) const;

  SweptOutline outline_;
  std::vector<double> knots_;  // ascending from 0
};

}  // namespace arcway::internal
