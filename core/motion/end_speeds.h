#pragma once

#include "arcway/path.h"

namespace arcway::internal {

/// Share by which a path may exceed the acceleration where its end speeds are out of reach else. A plan that goes on
/// from another one may have no braking to spare, and words that lead there are off by the square root of rounding.
inline constexpr double kEndTolerance = 4e-7;

/// The speeds with which a path begins and ends [m/s]: positive driven forwards, negative backwards, 0 at rest.
struct EndSpeeds {
  double start = 0.0;
  double goal = 0.0;

  [[nodiscard]] bool is_moving() const { return start != 0.0 || goal != 0.0; }
  /// Those of the same path driven from its end to its start, in the other gear.
  [[nodiscard]] EndSpeeds reversed() const { return {0.0 - goal, 0.0 - start}; }
  friend bool operator==(const EndSpeeds&, const EndSpeeds&) = default;
};

/// A speed along the body: negative in reverse. Never -0.
inline double signed_speed(double speed, Gear gear) { return gear == Gear::kForward ? speed : 0.0 - speed; }

}  // namespace arcway::internal
