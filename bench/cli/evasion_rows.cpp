#include "bench/cli/evasion_rows.h"

#include "bench/cli/arguments.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal::cli {

EvasionSummary evasion_of(const PlanResult& plan, const Vehicle& vehicle, double planned_time) {
  constexpr double kSlower = 1.0 - 1e-6;  // of the highest speed: more than rounding
  EvasionSummary summary{.delay = plan.travel_time - planned_time};
  double time = 0.0;
  for (const TimedSegment& timed : plan.segments) {
    time += timed.duration;
    if (timed.segment.length == 0.0) {
      summary.waiting += timed.duration;
      summary.waits_until = time;
    } else if (top_speed(timed, vehicle) < kSlower * speed_limit(timed.segment, vehicle)) {
      summary.slower_until = time;
    }
  }
  return summary;
}

std::string to_string(const EvasionSummary& summary) {
  if (summary.delay == 0.0) return "none is met";
  std::string text;
  if (summary.waiting > 0.0)
    text += "waits " + fixed(summary.waiting, 3) + " s, until " + fixed(summary.waits_until, 3) + " s; ";
  if (summary.slower_until > 0.0) text += "drives more slowly until " + fixed(summary.slower_until, 3) + " s; ";
  return text + fixed(summary.delay, 3) + " s later at the goal";
}

}  // namespace arcway::internal::cli
