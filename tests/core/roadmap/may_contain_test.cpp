#include "core/roadmap/may_contain.h"

#include <gtest/gtest.h>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr double kError = 1e-3;

// Across the seam and beside it, known up to an error.
TEST(MayContain, IsTrueForHeadingsOfTheSetAndFalseFarFromThem) {
  const HeadingSet set = HeadingSet::of_intervals({{0.5, 1.0}, {5.0, kTwoPi + 0.2}});
  test::RandomInputs random(1);
  int inside = 0, outside = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double heading = random.uniform(0.0, kTwoPi);
    const double about = heading + random.uniform(-kError, kError);
    const double same = about > kPi ? about - kTwoPi : about;  // as atan2 gives it
    if (set.contains(heading)) {
      ++inside;
      EXPECT_TRUE(may_contain(set, same, kError)) << heading;
    } else if (!set.contains(heading - 3.0 * kError) && !set.contains(heading + 3.0 * kError)) {
      ++outside;
      EXPECT_FALSE(may_contain(set, same, kError)) << heading;
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 2000);
}

TEST(MayContain, KnowsTheEndsOfSets) {
  EXPECT_TRUE(may_contain(HeadingSet::of_intervals({{2.0, 2.0}}), 2.0 + 0.5 * kError, kError));
  EXPECT_FALSE(may_contain(HeadingSet::of_intervals({{2.0, 2.0}}), 2.0 + 1.5 * kError, kError));
  EXPECT_TRUE(may_contain(HeadingSet::of_intervals({{0.0, 1.0}}), -0.5 * kError, kError));
  EXPECT_TRUE(may_contain(HeadingSet::of_intervals({{6.0, kTwoPi}}), 0.5 * kError, kError));
  EXPECT_TRUE(may_contain(HeadingSet::full(), -1.0, kError));
  EXPECT_FALSE(may_contain(HeadingSet(), 1.0, kError));
}

}  // namespace
}  // namespace arcway::internal
