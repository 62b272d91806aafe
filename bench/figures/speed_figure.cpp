#include "bench/figures/canvas.h"
#include "bench/figures/figures.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal::figures {
namespace {

/// A straight with the speeds at its start and its end, the top speed [m/s] and the acceleration [m/s²].
struct Straight {
  double length, v1, v2, v3, a;
  [[nodiscard]] double seconds() const { return segment_time(length, v1, v2, v3, a); }
};

/// Draws the speed over time on a straight: up from v1, along v2 if it is reached, down to v3.
void draw_profile(Canvas& canvas, const Straight& straight, const char* color, const char* dash) {
  const auto& [length, v1, v2, v3, a] = straight;
  const double peak = segment_phases(length, v1, v2, v3, a).peak, seconds = straight.seconds();
  canvas.curve(canvas.at({0.0, v1}) + canvas.at({(peak - v1) / a, peak}) +
                   canvas.at({seconds - (peak - v3) / a, peak}) + canvas.at({seconds, v3}),
               color, 3.0, dash);
}

}  // namespace

Figure speed_profiles(const Vehicle& vehicle) {
  const double v2 = vehicle.max_speed(), v1 = vehicle.turn_speed(vehicle.min_turning_radius()), v3 = v1;
  const double a = vehicle.max_acceleration();
  const double critical = (2.0 * v2 * v2 - v1 * v1 - v3 * v3) / (2.0 * a);  // both forms meet here
  const double long_way = 3.0 * critical, short_way = 0.4 * critical;
  const Straight long_straight{long_way, v1, v2, v3, a}, short_straight{short_way, v1, v2, v3, a};
  const double long_time = long_straight.seconds(), short_time = short_straight.seconds();
  Canvas canvas({-0.06 * long_time, -0.12 * v2}, {1.05 * long_time, 1.12 * v2}, {640.0 / long_time, 330.0 / v2});
  canvas.line({0.0, 0.0}, {1.03 * long_time, 0.0}, "#1d2126", 1.5);
  canvas.line({0.0, 0.0}, {0.0, 1.1 * v2}, "#1d2126", 1.5);
  canvas.line({0.0, v2}, {1.03 * long_time, v2}, "#7a828c", 1.0, "4 4");
  draw_profile(canvas, long_straight, "#0072b2", "");
  draw_profile(canvas, short_straight, "#d55e00", "9 4");
  canvas.text({-0.01 * long_time, v2 - 0.02 * v2}, digits(v2, 0), "end");
  canvas.text({-0.01 * long_time, v1 - 0.02 * v2}, digits(v1, 0), "end");
  canvas.text({0.01 * long_time, 1.06 * v2}, "v [m/s]", "start");
  canvas.text({1.03 * long_time, 0.03 * v2}, "t", "end");
  canvas.text({0.6 * long_time, 0.93 * v2}, "(9): top speed reached", "middle", "#0072b2");
  canvas.text({1.04 * short_time, 0.85 * v1}, "(10): not reached", "start", "#d55e00");
  for (const double t : {short_time, long_time}) {
    canvas.line({t, 0.0}, {t, v3}, "#7a828c", 1.0, "4 4");
    canvas.text({t, -0.08 * v2}, digits(1e3 * t, 0) + " ms", "middle");
  }
  const std::string caption = "The fastest drive along a straight, from and to " + digits(v1, 0) + " m/s at " +
                              digits(a, 0) + " m/s²: " + digits(long_way, 2) + " m take " + digits(1e3 * long_time, 0) +
                              " ms, (9),\n" + digits(short_way, 2) + " m take " + digits(1e3 * short_time, 0) +
                              " ms, (10). Top speed is reached from " + digits(critical, 2) + " m on.";
  return {"figure6", canvas.str("Both speed profiles", caption), caption};
}

}  // namespace arcway::internal::figures
