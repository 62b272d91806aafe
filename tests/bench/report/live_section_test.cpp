#include "bench/report/live_section.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace arcway::internal::report {
namespace {

TEST(LiveSection, HasARowADrive) {
  const Measurement drive{.name = "Live/amr/changed/hertz:10",
                          .wall_seconds = {0.007},
                          .cpu_seconds = {0.006},
                          .counters = {{"change_seconds_median", 0.0012},
                                       {"cycle_seconds_median", 0.005},
                                       {"cycle_seconds_p99", 0.009},
                                       {"cycle_seconds_worst", 0.012},
                                       {"motion_share", 1.0},
                                       {"goal_share", 0.875},
                                       {"stop_share", 0.125},
                                       {"resident_bytes_early", 24e6},
                                       {"resident_bytes", 25.5e6}},
                          .label = {},
                          .error = {}};
  EXPECT_EQ(live_section({.name = "r.json", .context = {}, .measurements = {drive}}).table.rows,
            (std::vector<std::vector<std::string>>{{"amr/changed", "10", "1.2 ms", "5 ms", "9 ms", "12 ms", "100.0 %",
                                                    "87.5 %", "12.5 %", "24.0 MB", "25.5 MB"}}));
  EXPECT_TRUE(live_section({.name = "r.json", .context = {}, .measurements = {}}).table.rows.empty());
}

}  // namespace
}  // namespace arcway::internal::report
