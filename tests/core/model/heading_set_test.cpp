#include "arcway/heading_set.h"

#include <gtest/gtest.h>

#include <vector>

#include "arcway/angle.h"

namespace arcway::internal {
namespace {

TEST(HeadingSet, NothingBlockedIsTheFullCircle) {
  const HeadingSet set = HeadingSet::complement({});
  EXPECT_TRUE(set.is_full());
  EXPECT_EQ(set.reach(1.0, Side::kLeft), kTwoPi);
}

TEST(HeadingSet, AFullBlockLeavesNothing) {
  EXPECT_TRUE(HeadingSet::complement({{1.0, 1.0 + kTwoPi}}).empty());
  EXPECT_TRUE(HeadingSet::complement({{0.0, 3.5}, {3.0, 6.5}}).empty());
}

TEST(HeadingSet, BlockedEndsAreNotFree) {
  const HeadingSet set = HeadingSet::complement({{1.0, 2.0}, {3.0, 4.0}});
  for (const double end : {1.0, 2.0, 3.0, 4.0}) EXPECT_FALSE(set.contains(end)) << end;
  EXPECT_TRUE(set.contains(std::nextafter(2.0, 3.0)));
  EXPECT_TRUE(set.contains(std::nextafter(3.0, 2.0)));
  EXPECT_TRUE(set.contains(std::nextafter(4.0, 5.0)));
}

TEST(HeadingSet, OneIntervalCrossesTheSeam) {
  const HeadingSet set = HeadingSet::complement({{1.0, 5.0}});
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_TRUE(set.contains(0.0));
  EXPECT_TRUE(set.contains(6.0));
  EXPECT_TRUE(set.contains(-0.5));
  EXPECT_NEAR(set.reach(6.0, Side::kLeft), 1.0 + kTwoPi - 6.0, 1e-12);
  EXPECT_NEAR(set.reach(0.5, Side::kRight), 0.5 + kTwoPi - 5.0, 1e-12);
  EXPECT_LT(set.reach(3.0, Side::kLeft), 0.0);
}

TEST(HeadingSet, ABlockAcrossTheSeamIsCutOutOnBothSides) {
  const HeadingSet set = HeadingSet::complement({{6.0, 6.0 + 1.0}, {3.0, 4.0}});
  ASSERT_EQ(set.intervals().size(), 2u);
  EXPECT_FALSE(set.contains(0.5));
  EXPECT_FALSE(set.contains(6.1));
  EXPECT_TRUE(set.contains(1.0));
  EXPECT_TRUE(set.contains(5.0));
  EXPECT_FALSE(set.contains(3.5));
}

TEST(HeadingSet, OverlappingAndTouchingBlocksMerge) {
  const HeadingSet set = HeadingSet::complement({{1.0, 2.0}, {1.5, 2.5}, {2.5, 3.0}});
  ASSERT_EQ(set.intervals().size(), 1u);
  EXPECT_FALSE(set.contains(2.5));
}

TEST(HeadingSet, AroundAHeadingIsWhatCanBeReachedFromIt) {
  const HeadingSet free = HeadingSet::complement({{1.0, 2.0}, {3.0, 4.0}});
  EXPECT_TRUE(free.around(1.5, 1.0).empty());
  const HeadingSet between = free.around(2.2, 0.5);
  ASSERT_EQ(between.intervals().size(), 1u);
  EXPECT_NEAR(between.intervals()[0].low, 2.0, 1e-12);
  EXPECT_NEAR(between.intervals()[0].high, 2.7, 1e-12);
  const HeadingSet across = free.around(0.1, 0.5);  // the seam
  EXPECT_TRUE(across.contains(6.0));
  EXPECT_TRUE(across.contains(0.6));
  EXPECT_FALSE(across.contains(0.7));
  EXPECT_FALSE(across.contains(5.8));
  EXPECT_NEAR(HeadingSet::full().around(3.0, 0.25).intervals()[0].low, 2.75, 1e-12);
}

TEST(HeadingSet, IsMadeOfDisjointIntervals) {
  EXPECT_EQ(HeadingSet::of_intervals({{0.5, 1.0}, {2.0, 6.5}}).intervals().size(), 2u);
  EXPECT_TRUE(HeadingSet::of_intervals({{0.0, kTwoPi}}).is_full());
  for (const std::vector<HeadingInterval>& bad : {std::vector<HeadingInterval>{{1.0, 0.5}},
                                                  {{-0.1, 0.5}},
                                                  {{kTwoPi, 7.0}},
                                                  {{0.5, 2.0}, {2.0, 3.0}},
                                                  {{0.5, 1.0}, {2.0, 0.5 + kTwoPi}}})
    EXPECT_THROW((void)HeadingSet::of_intervals(bad), std::invalid_argument) << bad.front().low;
}

// Nothing is left before the seam but what rounding leaves.
TEST(HeadingSet, IsMadeAgainOfWhatAComplementHas) {
  for (const double high : {kTwoPi, std::nextafter(kTwoPi, 0.0), std::nextafter(std::nextafter(kTwoPi, 0.0), 0.0), 6.0})
    for (const double low : {1.0, 1e-300, 0.0}) {
      const HeadingSet set = HeadingSet::complement({{low, high}});
      EXPECT_EQ(HeadingSet::of_intervals({set.intervals().begin(), set.intervals().end()}).intervals().size(),
                set.intervals().size());
      EXPECT_EQ(set.find(0.5) >= 0, low == 1.0);
    }
}

TEST(HeadingSet, ComplementsIntoASetThatWasInUse) {
  HeadingSet set = HeadingSet::complement({{1.0, 2.0}, {3.0, 4.0}});
  for (const std::vector<HeadingInterval>& blocked :
       {std::vector<HeadingInterval>{{6.0, 7.0}, {3.0, 4.0}}, {}, {{0.5, 0.75}}, {{1.0, 1.0 + kTwoPi}}}) {
    const HeadingSet fresh = HeadingSet::complement(blocked);
    std::vector<HeadingInterval> used = blocked;
    HeadingSet::complement(used, set);
    ASSERT_EQ(set.intervals().size(), fresh.intervals().size());
    for (std::size_t i = 0; i < fresh.intervals().size(); ++i) {
      EXPECT_EQ(set.intervals()[i].low, fresh.intervals()[i].low);
      EXPECT_EQ(set.intervals()[i].high, fresh.intervals()[i].high);
    }
  }
}

}  // namespace
}  // namespace arcway::internal
