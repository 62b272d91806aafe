#include "bench/report/words.h"

#include <gtest/gtest.h>

namespace arcway::internal::report {
namespace {

TEST(Words, AreThoseOfStagesAndSeries) {
  EXPECT_EQ(stage_words("ReducedGraph"), "Reduced visibility graph");
  EXPECT_EQ(key_words("fill_percent"), "percent of the map that obstacles cover");
}

TEST(Words, SplitNamesThatAreNotKnown) {
  EXPECT_EQ(stage_words("FastNewThing"), "Fast new thing");
  EXPECT_EQ(key_words("new_things"), "new things");
}

TEST(Words, AreThoseOfSettingsAndPlanners) {
  EXPECT_EQ(setting_words("n1000"), "the paper's robot, 1,000 obstacles");
  EXPECT_EQ(setting_words("car"), "passenger car, 100 obstacles");
  EXPECT_EQ(setting_words("lateral2_along2"),
            "the paper's robot with at most 2 m/s² sideways and 2 along, 100 obstacles");
  EXPECT_EQ(setting_words("other"), "other");
  EXPECT_EQ(planner_words("ompl_rrtconnect_wide 10 s"), "OMPL's RRTConnect with wide turns, 10 s");
  EXPECT_EQ(planner_words("arcway, map and all"), "arcway, map and all");
}

TEST(Words, MakeAnchors) {
  EXPECT_EQ(anchor_of("Parking, by room [cm]"), "parking-by-room-cm");
  EXPECT_EQ(anchor_of("What it costs"), "what-it-costs");
}

}  // namespace
}  // namespace arcway::internal::report
