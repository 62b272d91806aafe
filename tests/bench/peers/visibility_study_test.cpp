#include "bench/peers/visibility_study.h"

#include <gtest/gtest.h>

namespace arcway::internal::peers {
namespace {

TEST(VisibilityStudy, TimesEqualAnswersInTurn) {
  const auto duels = visibility_study({.obstacles = {3, 6}, .repetitions = 2}, [](const std::string&) {});
  ASSERT_GE(duels.size(), 4u);
  for (const report::Duel& d : duels) {
    EXPECT_EQ(d.error, "") << d.task;
    EXPECT_EQ(d.our_seconds.size(), 2u);
    EXPECT_EQ(d.peer_seconds.size(), 2u);
    EXPECT_EQ(d.our_wall_seconds.size(), 2u);
    EXPECT_EQ(d.peer_wall_seconds.size(), 2u);
  }
}

TEST(VisibilityStudy, LeavesOutWhatTakesTooLong) {
  const auto duels =
      visibility_study({.obstacles = {3, 6}, .repetitions = 1, .limit = 1e-12}, [](const std::string&) {});
  ASSERT_GE(duels.size(), 2u);
  EXPECT_EQ(duels[0].error, "");
  EXPECT_EQ(duels[1].error.substr(0, 9), "left out:");
}

}  // namespace
}  // namespace arcway::internal::peers
