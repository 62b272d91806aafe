#pragma once

#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Largest error of quick_angle_of [rad].
inline constexpr double kQuickAngleError = 2e-5;

/// The direction of a vector that is not zero, as atan2 gives it, within kQuickAngleError; several times as fast
/// [Abramowitz, Stegun 1964, 4.4.49].
inline double quick_angle_of(const Vec2& d) {
  const double x = std::abs(d.x()), y = std::abs(d.y());
  const double t = std::min(x, y) / std::max(x, y);
  const double u = t * t;
  const double angle = t * (0.9998660 + u * (-0.3302995 + u * (0.1801410 + u * (-0.0851330 + u * 0.0208351))));
  const double upper = y > x ? 0.5 * kPi - angle : angle;
  return std::copysign(d.x() < 0.0 ? kPi - upper : upper, d.y());
}

/// direction_of a heading in [0, 2 pi], with an error of at most 2^-51, in a third of the time.
inline Vec2 quick_direction_of(double heading) {
  // Reduces the heading by a multiple of pi / 2, which is split into two numbers, and sums Taylor's series.
  constexpr double kQuarter = 0x1.921fb544p0, kRestOfQuarter = 0x1.0b4611a626331p-34;
  const int quarters = static_cast<int>(heading * (1.0 / kQuarter) + 0.5);  // NOLINT: one of the two nearest will do
  const double x = (heading - quarters * kQuarter) - quarters * kRestOfQuarter;
  const double u = x * x;
  const double tail_of_sine = 1.0 / 362880 + u * (-1.0 / 39916800 + u * (1.0 / 6227020800 - u / 1307674368000));
  const double tail_of_cosine =
      1.0 / 40320 + u * (-1.0 / 3628800 + u * (1.0 / 479001600 + u * (-1.0 / 87178291200 + u / 20922789888000)));
  const double sine = x + x * u * (-1.0 / 6 + u * (1.0 / 120 + u * (-1.0 / 5040 + u * tail_of_sine)));
  const double cosine = 1.0 - 0.5 * u + u * u * (1.0 / 24 + u * (-1.0 / 720 + u * tail_of_cosine));
  switch (quarters & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace arcway::internal
