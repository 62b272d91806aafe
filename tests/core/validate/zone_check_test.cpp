#include "core/validate/zone_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

using test::box;

SegmentSpeeds steady(double speed, double length) { return {speed, speed, speed, 2.0, length}; }

TEST(ZoneCheck, FindsWhereAMotionIsTooFast) {
  const ZoneCheck zone(box(2, -1, 4, 1));
  const PathSegment line{{0, 0, 0}, 10.0, 0.0};
  EXPECT_FALSE(zone.too_fast(line, steady(2.0, 10.0), 2.0));
  const auto place = zone.too_fast(line, steady(2.1, 10.0), 2.0);
  ASSERT_TRUE(place);
  EXPECT_GT(*place, 2.0);
  EXPECT_LT(*place, 4.0);
  // From rest to 2 m/s after 1 m, at the zone's border to 2.83.
  EXPECT_TRUE(zone.too_fast(line, {0.0, 0.0, 9.0, 2.0, 10.0}, 3.9));
  EXPECT_FALSE(zone.too_fast(line, {0.0, 0.0, 9.0, 2.0, 10.0}, 4.1));
}

TEST(ZoneCheck, PassesWhatMissesTheZoneOrRunsAlongItsBorder) {
  const ZoneCheck zone({box(2, -1, 4, 1).outer, {box(2.5, -0.5, 3.5, 0.5).outer}});
  EXPECT_FALSE(zone.too_fast({{0, 1.5, 0}, 10.0, 0.0}, steady(5.0, 10.0), 2.0));
  EXPECT_FALSE(zone.too_fast({{0, 1.0 - 0.5 * ZoneCheck::kBorder, 0}, 10.0, 0.0}, steady(5.0, 10.0), 2.0));
  EXPECT_TRUE(zone.too_fast({{0, 1.0 - 2.0 * ZoneCheck::kBorder, 0}, 10.0, 0.0}, steady(5.0, 10.0), 2.0));
  EXPECT_FALSE(zone.too_fast({{3, 0, 0}, 0.4, 0.0}, steady(5.0, 0.4), 2.0));  // in the hole
  EXPECT_TRUE(zone.too_fast({{3, 0, 0}, 0.8, 0.0}, steady(5.0, 0.8), 2.0));
  EXPECT_TRUE(zone.too_fast({{1, 0, 0}, 2.0, 0.0, Gear::kForward}, steady(5.0, 2.0), 2.0));
  EXPECT_FALSE(zone.too_fast({{1, 0, 0}, 2.0, 0.0, Gear::kReverse}, steady(5.0, 2.0), 2.0));
  EXPECT_TRUE(zone.too_fast({{3, -3, 0}, 9.0, 1.0 / 1.5}, steady(5.0, 9.0), 2.0));
}

TEST(ZoneCheck, FindsWhereAMotionIsAgainstADirection) {
  const ZoneCheck zone(box(2, -1, 4, 1));
  const PathSegment line{{0, 0, 0}, 10.0, 0.0};
  EXPECT_FALSE(zone.against(line, 0.3, 0.3 + 1e-9));
  const auto place = zone.against(line, 0.3, 0.29);
  ASSERT_TRUE(place);
  EXPECT_GT(*place, 2.0);
  EXPECT_LT(*place, 4.0);
  EXPECT_TRUE(zone.against(line, std::numbers::pi, 1.0));
  EXPECT_FALSE(zone.against({{10, 0, 0}, 10.0, 0.0, Gear::kReverse}, std::numbers::pi - 4.0 * std::numbers::pi, 1.0));
  EXPECT_TRUE(zone.against({{10, 0, 0}, 10.0, 0.0, Gear::kReverse}, 0.0, 1.0));
  EXPECT_FALSE(zone.against({{3, 0, 0}, 0.0, 0.0}, std::numbers::pi, 1.0));
  // Along the border, at once, and a little inside of it.
  EXPECT_FALSE(zone.against({{0, 1.0 - 0.5 * ZoneCheck::kBorder, 0}, 10.0, 0.0}, std::numbers::pi, 1.0));
  EXPECT_TRUE(zone.against({{0, 1.0 - 2.0 * ZoneCheck::kBorder, 0}, 10.0, 0.0}, std::numbers::pi, 1.0));
  EXPECT_FALSE(zone.against({{-1e6, 1.0, 0}, 2e6, 0.0}, std::numbers::pi, 1.0));
  // A turn by pi that begins below the zone, is upright at x = 3.5 and leads back: allowed up to 0.1 beyond upright.
  const PathSegment arc{{2, -1.5, 0}, 1.5 * std::numbers::pi, 1.0 / 1.5};
  EXPECT_FALSE(zone.against(arc, 0.5 * std::numbers::pi, 0.5 * std::numbers::pi + 0.01));
  const auto turned = zone.against(arc, 0.0, 0.5 * std::numbers::pi + 0.1);
  ASSERT_TRUE(turned);
  EXPECT_GT(arc.at(*turned).heading, 0.5 * std::numbers::pi + 0.1);
}

TEST(ZoneCheck, TheTopSpeedFollowsFromTheDuration) {
  // 10 m from 1 to 2 m/s, at most at 3 m/s, with 2 m/s^2.
  const SegmentSpeeds speeds{1.0, 2.0, 3.0, 2.0, 10.0};
  const double up = 1.0, down = 0.5, ramps = 2.0 + 1.25;
  EXPECT_NEAR(top_speed_within({1.0, 2.0, 9.0, 2.0, 10.0}, up + down + (10.0 - ramps) / 3.0), 3.0, 1e-7);
  EXPECT_EQ(top_speed_within(speeds, 0.0), 3.0);
  EXPECT_NEAR(top_speed_within(speeds, 100.0), 2.0, 1e-9);  // slower than any motion between these speeds
}

}  // namespace
}  // namespace arcway::internal
