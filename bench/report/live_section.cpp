#include "bench/report/live_section.h"

#include <string>

#include "bench/report/markup.h"
#include "bench/report/noise.h"

namespace arcway::internal::report {

Section live_section(const Results& results) {
  Section section{
      .title = "A drive through a map that changes",
      .paragraphs = {"In each cycle an obstacle moves, vanishes or comes back, and the vehicle plans on from where it "
                     "is, with its speed. Every motion is validated. `changed` is a planner that follows each change, "
                     "`rebuilt` one that is made anew. Processor times of a cycle: the change and planning on."},
      .figures = {},
      .table = {{"planner", "cycles a second", "change, median", "cycle, median", "99 %", "worst", "with a free motion",
                 "to the goal", "to a stop", "resident after a tenth", "at the end"},
                {},
                1}};
  for (const Measurement* m : of_stage(results, "Live")) {
    const auto value = [&](const char* counter) {
      const auto found = m->counters.find(counter);
      return found == m->counters.end() ? 0.0 : found->second;
    };
    const auto share = [&](const char* counter) { return number_text("%.1f", 100.0 * value(counter)) + " %"; };
    const auto megabytes = [&](const char* counter) { return number_text("%.1f", 1e-6 * value(counter)) + " MB"; };
    const SeriesPlace place = place_of(m->name);
    section.table.rows.push_back({place.variant, count_text(place.size), time_text(value("change_seconds_median")),
                                  time_text(value("cycle_seconds_median")), time_text(value("cycle_seconds_p99")),
                                  time_text(value("cycle_seconds_worst")), share("motion_share"), share("goal_share"),
                                  share("stop_share"), megabytes("resident_bytes_early"), megabytes("resident_bytes")});
  }
  return section;
}

}  // namespace arcway::internal::report
