#include "core/zones/speed_zones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/boxes.h"
#include "tests/support/depth_in.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;

// The lowest limit of the zones around a point, by the sign of distances that are more than `border` (else nothing).
struct Sampled {
  double cap;
  bool near_border;
};
Sampled sampled_cap(const std::vector<Zone>& zones, const Vec2& p, double border) {
  Sampled result{INFINITY, false};
  for (const Zone& zone : zones) {
    const double depth = test::depth_in(zone.area, p);
    result.near_border = result.near_border || std::abs(depth) < border;
    if (depth > 0.0) result.cap = std::min(result.cap, std::get<SpeedLimit>(zone.rule).max_speed);
  }
  return result;
}

std::vector<Zone> random_zones(test::RandomInputs& random) {
  std::vector<Zone> zones;
  for (int i = 0; i < 4; ++i) {
    const Vec2 middle = random.point(-6, 6);
    const double radius = random.uniform(1, 6);
    Polygon area = Polygon::regular(middle, radius, static_cast<std::size_t>(random.integer(3, 7)), random.unit());
    if (i % 2 == 0) area.holes.push_back(Polygon::regular(middle, 0.3 * radius, 4, random.unit()).outer);
    zones.push_back({area, SpeedLimit{random.uniform(1, 5)}});
  }
  return zones;
}

PathSegment random_segment(test::RandomInputs& random) {
  const Vec2 at = random.point(-8, 8);
  const double curvature = random.integer(0, 2) == 0 ? 0.0 : random.uniform(-1.0, 1.0);
  const double longest = curvature == 0.0 ? 12.0 : std::min(30.0, kTwoPi / std::abs(curvature));
  return {{at.x(), at.y(), random.uniform(-kPi, kPi)},
          random.uniform(0.0, longest),
          curvature,
          random.integer(0, 1) == 0 ? Gear::kForward : Gear::kReverse};
}

// A path that was cut at the border ends there within the margin by which the limit lasts longer.
TEST(SpeedZones, HoldToTheEndOfASegmentThatEndsRightBehindThem) {
  const SpeedZones zones(std::vector<Zone>{{box(33, -5, 39, 5), SpeedLimit{0.7}}});
  std::vector<SpeedZones::Stretch> stretches;
  for (const double behind : {-1e-9, 0.0, 1e-9, 3.9e-8, 3.9e-8 + 1e-14}) {
    const double length = 4.0 + behind;
    zones.cut({{35.0, 0.0, 0.0}, length, 0.0}, stretches);
    ASSERT_EQ(stretches.size(), 1u) << behind;
    EXPECT_EQ(stretches[0].cap, 0.7);
    EXPECT_NEAR(stretches[0].length, length, 1e-15);
  }
  zones.cut({{35.0, 0.0, 0.0}, 4.0 + 1e-6, 0.0}, stretches);
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[1].cap, INFINITY);
}

// So does one that begins there.
TEST(SpeedZones, HoldFromTheBeginningOfASegmentThatBeginsRightBeforeThem) {
  const SpeedZones zones(std::vector<Zone>{{box(33, -5, 39, 5), SpeedLimit{0.7}}});
  std::vector<SpeedZones::Stretch> stretches;
  for (const double before : {-1e-9, 0.0, 1e-9, 3.9e-8, 3.9e-8 + 1e-14, 4.2e-8}) {
    zones.cut({{33.0 - before, 0.0, 0.0}, 4.0, 0.0}, stretches);
    ASSERT_EQ(stretches.size(), 1u) << before;
    EXPECT_EQ(stretches[0].cap, 0.7);
    EXPECT_EQ(stretches[0].length, 4.0);
    zones.cut({{33.0 - before, 0.0, 0.0}, 8.0, 0.0}, stretches);
    ASSERT_EQ(stretches.size(), 2u) << before;
    EXPECT_EQ(stretches[0].cap, 0.7);
    EXPECT_NEAR(stretches[0].length, 6.0 + before, 1e-7);
    EXPECT_NEAR(stretches[0].length + stretches[1].length, 8.0, 1e-14);
  }
  zones.cut({{33.0 - 1e-6, 0.0, 0.0}, 4.0, 0.0}, stretches);
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].cap, INFINITY);
}

TEST(SpeedZones, CutsWhereSamplesOfEachMillimeterSay) {
  test::RandomInputs random(5);
  std::size_t cuts = 0;
  for (int round = 0; round < 200; ++round) {
    const std::vector<Zone> zones = random_zones(random);
    const SpeedZones speed_zones(zones);
    const PathSegment segment = random_segment(random);
    std::vector<SpeedZones::Stretch> stretches;
    speed_zones.cut(segment, stretches);
    cuts += stretches.size() - 1;
    double end = 0.0;
    std::size_t at = 0;
    for (const auto& stretch : stretches) end += stretch.length;
    EXPECT_NEAR(end, segment.length, 1e-12 * segment.length);
    end = stretches[0].length;
    for (double s = 0.0; s < segment.length; s += 1e-3) {
      while (s > end && at + 1 < stretches.size()) end += stretches[++at].length;
      const Sampled sampled = sampled_cap(zones, segment.at(s).position(), 1e-7);
      if (sampled.near_border) continue;
      ASSERT_EQ(stretches[at].cap, sampled.cap) << "round " << round << " at " << s;
    }
  }
  EXPECT_GT(cuts, 150u);
}

TEST(SpeedZones, NeighborsDiffer) {
  const std::vector<Zone> zones{{box(1, -1, 2, 1), SpeedLimit{2.0}},
                                {box(2, -1, 3, 1), SpeedLimit{2.0}},
                                {box(1.5, -1, 2.5, 1), SpeedLimit{1.0}},
                                {box(0, -9, 9, 9), SpeedLimit{3.0}}};
  std::vector<SpeedZones::Stretch> stretches;
  SpeedZones(zones).cut({{-1, 0, 0}, 12.0, 0.0}, stretches);
  ASSERT_EQ(stretches.size(), 7u);
  const double caps[] = {INFINITY, 3, 2, 1, 2, 3, INFINITY}, lengths[] = {1, 1, 0.5, 1, 0.5, 6, 2};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(stretches[i].cap, caps[i]);
    EXPECT_NEAR(stretches[i].length, lengths[i], 1e-7);
  }
  // A limit holds a little longer than its zone.
  EXPECT_LT(stretches[0].length, 1.0);
  EXPECT_GT(stretches[3].length, 1.0);
}

TEST(SpeedZones, ABorderBelongsToItsZone) {
  const std::vector<Zone> zones{{box(0, 0, 4, 4), SpeedLimit{2.0}}};
  const SpeedZones speed_zones(zones);
  std::vector<SpeedZones::Stretch> stretches;
  speed_zones.cut({{-1, 0, 0}, 6.0, 0.0}, stretches);
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_EQ(stretches[1].cap, 2.0);
  EXPECT_EQ(speed_zones.cap_at({4, 4}), 2.0);
  EXPECT_EQ(speed_zones.cap_at({4.001, 4}), INFINITY);
}

TEST(SpeedZones, ASegmentWithoutLengthHasOneStretch) {
  const std::vector<Zone> zones{{box(0, 0, 4, 4), SpeedLimit{2.0}}};
  std::vector<SpeedZones::Stretch> stretches;
  SpeedZones(zones).cut({{1, 1, 0}, 0.0, 0.0}, stretches);
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_EQ(stretches[0].length, 0.0);
  EXPECT_EQ(stretches[0].cap, 2.0);
}

TEST(SpeedZones, ThereAreNoneWithoutALimit) {
  EXPECT_EQ(SpeedZones::of(World({})), nullptr);
  EXPECT_EQ(SpeedZones::of(World({}).with_zones({{box(0, 0, 4, 4), KeepOut{}}})), nullptr);
  EXPECT_NE(SpeedZones::of(World({}).with_zones({{box(0, 0, 4, 4), SpeedLimit{1.0}}})), nullptr);
}

TEST(SpeedZones, ACutPathJoinsUpAndIsIndexed) {
  const std::vector<Zone> zones{{box(1, -1, 2, 1), SpeedLimit{2.0}}};
  const std::vector<PathSegment> path{{{0, 0, 0}, 3.0, 0.0}, {{3, 0, 0}, 1.0, 0.5}};
  CappedPath capped;
  cut(path, SpeedZones(zones), capped);
  EXPECT_EQ(capped.first, (std::vector<std::uint32_t>{0, 3, 4}));
  ASSERT_EQ(capped.segments.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_LT((capped.segments[i].start.position() - capped.segments[i - 1].end().position()).norm(), 1e-12);
  EXPECT_EQ(capped.segments[3].curvature, 0.5);
}

}  // namespace
}  // namespace arcway::internal
