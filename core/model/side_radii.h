#pragma once

#include <algorithm>

#include "arcway/path.h"
#include "arcway/vehicle.h"

namespace arcway::internal {

/// A turning radius for each side [m].
struct SideRadii {
  double left, right;
  SideRadii(double to_both_sides) : left(to_both_sides), right(to_both_sides) {}
  SideRadii(double to_left, double to_right) : left(to_left), right(to_right) {}
  /// The tightest turns of a vehicle.
  explicit SideRadii(const Vehicle& vehicle)
      : SideRadii(vehicle.min_turning_radius(Side::kLeft), vehicle.min_turning_radius(Side::kRight)) {}

  /// That of turns to a side.
  [[nodiscard]] double of(Side side) const { return side == Side::kLeft ? left : right; }
  /// That of turns to the side to which a curvature turns, or anything of its sign.
  [[nodiscard]] double on(double curvature) const { return curvature > 0.0 ? left : right; }
  [[nodiscard]] double smaller() const { return std::min(left, right); }
  [[nodiscard]] double larger() const { return std::max(left, right); }
  /// Both radii times a factor.
  [[nodiscard]] SideRadii times(double factor) const { return {factor * left, factor * right}; }
  /// Both radii, or another one where they are less.
  [[nodiscard]] SideRadii no_less_than(double radius) const {
    return {std::max(left, radius), std::max(right, radius)};
  }
  friend bool operator==(const SideRadii&, const SideRadii&) = default;
};

}  // namespace arcway::internal
