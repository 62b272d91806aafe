#include "core/attach/occlusion_horizon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(OcclusionHorizon, EndsNoFreeStraightAndHidesNoPointThatOneReaches) {
  const Footprint body = Vehicle{}.footprint();
  int limited = 0, hidden = 0, reached = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const ClutterKind kind = seed % 2 == 0 ? ClutterKind::kStar : ClutterKind::kConvex;
    const World world = random_world({.kind = kind, .obstacles = 60, .vertices = 7, .fill = 0.25, .seed = seed});
    const QuerySet queries = make_reference_queries(world);
    const Outlines outlines(world);
    test::RandomInputs random(seed);
    for (int i = 0; i < 40; ++i) {
      const double far = world.box().max.x();
      const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
      const TurnCircle circle{random.point(0.0, far), i % 4 == 0 ? 20.0 : 1.3, side, kNone};
      OcclusionHorizon horizon(circle, 0.0, kTwoPi);
      horizon.shorten(outlines);
      for (int k = 0; k < 100; ++k) {
        const double heading = random.uniform(0.0, kTwoPi);
        const double length = random.uniform(0.0, 0.5 * far);
        const Pose start = pose_on(circle, heading);
        if (std::isfinite(horizon.reach(heading))) ++limited;
        const bool free = queries.sweep->straight_free(swept_rectangle(start, length, body));
        EXPECT_TRUE(!free || length <= horizon.reach(heading)) << seed << " " << i;
        const Vec2 end = start.position() + length * direction_of(heading);
        const Vec2 extent(random.uniform(0.0, 5.0), random.uniform(0.0, 5.0));
        const Box box{end - extent, end + random.unit() * extent};
        const bool hides = horizon.hides(box);
        EXPECT_NE(horizon.sectors_towards(box) & sectors_of(heading, heading), 0u) << seed << " " << i;
        EXPECT_FALSE(free && hides) << seed << " " << i;
        hidden += hides ? 1 : 0;
        reached += free ? 1 : 0;
      }
    }
  }
  EXPECT_GT(limited, 10000);
  EXPECT_GT(hidden, 5000);
  EXPECT_GT(reached, 500);
}

TEST(OcclusionHorizon, HidesNoCircleOntoWhichAStraightIsFree) {
  const Footprint body = Vehicle{}.footprint();
  int hidden = 0, free = 0, overlapping = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const World world = random_world({.obstacles = 50, .vertices = 6, .fill = 0.2, .seed = seed});
    const QuerySet queries = make_reference_queries(world);
    const Outlines outlines(world);
    test::RandomInputs random(seed);
    for (int i = 0; i < 20; ++i) {
      const double far = world.box().max.x();
      const TurnCircle circle{random.point(0.0, far), 1.3, i % 2 == 0 ? Side::kLeft : Side::kRight, kNone};
      OcclusionHorizon horizon(circle, 0.0, kTwoPi);
      horizon.shorten(outlines);
      horizon.finish();
      for (int k = 0; k < 200; ++k) {
        // Far away, near by, overlapping, and of another radius.
        const double spread = k % 4 == 0 ? 4.0 : 0.3 * far;
        const TurnCircle to{circle.center + Vec2(random.uniform(-spread, spread), random.uniform(-spread, spread)),
                            k % 3 == 0 ? 2.6 : 1.3, k % 2 == 0 ? Side::kLeft : Side::kRight, kNone};
        const auto line = directed_bitangent(circle, to);
        const bool is_free = line && queries.sweep->straight_free(swept_rectangle(line->start, line->length, body));
        const OcclusionHorizon::TangentLine tangent = horizon.tangent_to(to);
        EXPECT_FALSE(is_free && horizon.hides(tangent)) << seed << " " << i << " " << k;
        EXPECT_TRUE(line || !horizon.hides(tangent));
        const auto quick = horizon.free_tangent_to(to);
        EXPECT_TRUE(!line || quick.has_value() != horizon.hides(tangent)) << seed << " " << i << " " << k;
        overlapping += !line && !quick ? 1 : 0;
        if (line && tangent.length > 0.0) {
          EXPECT_LT(std::abs(wrap_signed(tangent.heading - line->start.heading)), OcclusionHorizon::kTangentError);
          EXPECT_NEAR(tangent.length, line->length, 1e-6 * line->length);
          EXPECT_TRUE(tangent.heading >= 0.0 && tangent.heading < kTwoPi);
        }
        hidden += horizon.hides(tangent) ? 1 : 0;
        free += is_free ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 5000);
  EXPECT_GT(free, 500);
  EXPECT_GT(overlapping, 500);
}

// Ranges of headings begin at every 512th part of a turn: what lies just beside an obstacle that ends there is not
// hidden.
TEST(OcclusionHorizon, HidesNothingJustBesideAnObstacle) {
  constexpr double kRange = kTwoPi / 512, kBeside = 1e-5;
  const auto at = [](double heading) { return Vec2(5.0 * direction_of(heading)); };
  int limited = 0;
  for (int k = 0; k < 512; ++k) {
    const double first = k * kRange, last = first + 4.0 * kRange;
    const World world({{{at(first + kBeside), at(first + 2.0 * kRange) * 1.1, at(last - kBeside)}, {}}});
    OcclusionHorizon horizon({{0.0, 0.0}, 0.0, Side::kLeft, kNone}, 0.0, kTwoPi);
    horizon.shorten(Outlines(world));
    EXPECT_TRUE(std::isinf(horizon.reach(first + 0.5 * kBeside))) << k;
    EXPECT_TRUE(std::isinf(horizon.reach(last - 0.5 * kBeside))) << k;
    limited += std::isfinite(horizon.reach(first + 2.0 * kRange)) ? 1 : 0;
  }
  EXPECT_EQ(limited, 512);
}

TEST(OcclusionHorizon, HidesNothingFromWhereItBegins) {
  for (int k = 0; k < 512; ++k) {
    const double heading = (k * kTwoPi) / 512 + 2e-6;
    const TurnCircle circle{{1.0, 2.0}, 1.3, k % 2 == 0 ? Side::kLeft : Side::kRight, kNone};
    const OcclusionHorizon horizon(circle, heading, 0.1);
    const TurnCircle to{circle.center + 20.0 * direction_of(heading), circle.radius, circle.side, kNone};
    EXPECT_FALSE(horizon.hides(horizon.tangent_to(to))) << k;
  }
}

TEST(OcclusionHorizon, IsUnlimitedWithoutObstacles) {
  const Outlines outlines{World({})};
  OcclusionHorizon horizon({{3, 4}, 2.0, Side::kLeft, kNone}, 0.0, kTwoPi);
  horizon.shorten(outlines);
  EXPECT_TRUE(std::isinf(horizon.reach(1.0)));
  EXPECT_FALSE(horizon.hides({{10, 10}, {20, 20}}));
}

TEST(OcclusionHorizon, HasOnlyTheHeadingsWithinTheTurn) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const OcclusionHorizon horizon({{3, 4}, 2.0, side, kNone}, 0.2, 0.5);
    for (double turn = -3.0; turn < 3.0; turn += 0.1) {
      const double heading = 0.2 + sign_of(side) * turn;
      const bool within = turn >= 0.0 && turn <= 0.5;
      const bool beyond = turn < -0.05 || turn > 0.55;
      EXPECT_TRUE(!within || std::isinf(horizon.reach(heading)));
      EXPECT_TRUE(!beyond || horizon.reach(heading) < 0.0);
    }
  }
}

TEST(OcclusionHorizon, IsCutOffByALongWall) {
  const World world({{{{-50, 10}, {50, 10}, {50, 12}, {-50, 12}}, {}}});
  const Outlines outlines(world);
  OcclusionHorizon below({{0, 0}, 1.0, Side::kLeft, kNone}, 0.0, kTwoPi);
  below.shorten(outlines);
  EXPECT_LT(below.reach(0.5 * kPi), 60.0);
  EXPECT_TRUE(std::isinf(below.reach(1.5 * kPi)));
  EXPECT_TRUE(below.hides({{-1, 60}, {1, 62}}));
  EXPECT_FALSE(below.hides({{-1, -62}, {1, -60}}));
}

}  // namespace
}  // namespace arcway::internal
