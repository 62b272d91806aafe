#include "core/motion/gear_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/infinity.h"

namespace arcway::internal {
namespace {

TEST(GearWords, AreThoseOfReedsAndSheppAndOfDubinsInBothGears) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-6.0, 6.0), angle(-4.0, 4.0);
  const SideRadii radii(1.0, 1.5);
  std::size_t forwards = 0, backwards = 0;
  for (int round = 0; round < 200; ++round) {
    const Pose start{place(random), place(random), angle(random)}, goal{place(random), place(random), angle(random)};
    const GearWords words(start, goal, radii);
    for (std::size_t word = 0; word < kGearWords; ++word) {
      const double length = words.length(word);
      const auto path = words.path(word);
      ASSERT_EQ(path.has_value(), std::isfinite(length)) << word;
      if (word < kReedsSheppWords) {
        EXPECT_EQ(length, reeds_shepp_length(word, start, goal, radii.larger()));
      }
      if (!path || path->empty()) continue;
      EXPECT_NEAR(length_of(*path), length, 1e-9);
      EXPECT_LT((path->back().end().position() - goal.position()).norm(), 1e-9) << word;
      if (word < kReedsSheppWords) continue;
      EXPECT_EQ(cusps_of(*path), 0u);
      ++(path->front().gear == Gear::kForward ? forwards : backwards);
    }
  }
  EXPECT_GT(forwards, 600u);
  EXPECT_GT(backwards, 600u);
}

}  // namespace
}  // namespace arcway::internal
