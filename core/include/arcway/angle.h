#pragma once

#include <cmath>
#include <numbers>

namespace arcway {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// `angle` plus a multiple of 2 pi, in [0, 2 pi) [rad].
inline double wrap_positive(double angle) {
  const double wrapped = std::abs(angle) < kTwoPi ? angle : std::fmod(angle, kTwoPi);  // mostly spares a slow call
  const double positive = wrapped < 0.0 ? wrapped + kTwoPi : wrapped;
  return positive < kTwoPi ? positive : 0.0;  // a tiny negative angle rounds up to 2 pi
}

/// `angle` plus a multiple of 2 pi, in (-pi, pi] [rad].
inline double wrap_signed(double angle) {
  const double positive = wrap_positive(angle);
  return positive > kPi ? positive - kTwoPi : positive;
}

}  // namespace arcway
