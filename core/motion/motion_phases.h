#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "arcway/path.h"

namespace arcway::internal {

/// A part of a segment that is driven at constant acceleration.
struct Phase {
  double length = 0.0;    ///< [m], > 0
  double speed_in = 0.0;  ///< [m/s]; not both 0
  double speed_out = 0.0;

  /// The speed at s from its start, the time until then, and the acceleration.
  [[nodiscard]] double speed(double s) const {
    return std::sqrt(std::lerp(speed_in * speed_in, speed_out * speed_out, s / length));
  }
  [[nodiscard]] double time(double s) const { return s > 0.0 ? 2.0 * s / (speed_in + speed(s)) : 0.0; }
  [[nodiscard]] double acceleration() const { return 0.5 * (speed_out - speed_in) * (speed_out + speed_in) / length; }
};

/// The phases of a segment, from its start to its end; none of a segment without length. Those of rounding are left
/// out.
class MotionPhases {
 public:
  /// @param top_speed  see top_speed of speed_profile.h.
  MotionPhases(const TimedSegment& timed, double top_speed, double acceleration);

  [[nodiscard]] const Phase* begin() const { return phases_.data(); }
  [[nodiscard]] const Phase* end() const { return phases_.data() + count_; }

 private:
  std::array<Phase, 3> phases_;
  std::size_t count_ = 0;
};

}  // namespace arcway::internal
