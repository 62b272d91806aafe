#include "core/collision/turning_headings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "accel/backend/make_queries.h"
#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// The body at one heading, as a rectangle of its own: decided by the straight check, which is exact.
bool free_at(const SweepQuery& sweep, const TurningBody& body, double heading) {
  const Vec2 p = body.center - sign_of(body.side) * body.radius * perpendicular(direction_of(heading));
  return sweep.straight_free(swept_rectangle({p.x(), p.y(), heading}, 0.0, body.body));
}

void expect_agreement(const World& world, const QuerySet& queries, const Footprint& footprint) {
  test::RandomInputs random(11);
  std::size_t partly_free = 0;
  for (int i = 0; i < 150; ++i) {
    const Vec2 span = world.box().max - world.box().min;
    const Vec2 center =
        world.box().min + Vec2(random.uniform(0.0, 1.0) * span.x(), random.uniform(0.0, 1.0) * span.y());
    const TurningBody body{center, random.uniform(0.8, 4.0), i % 2 == 0 ? Side::kLeft : Side::kRight, footprint};
    const HeadingSet set = queries.sweep->free_headings(body);
    partly_free += !set.empty() && !set.is_full();
    for (int k = 0; k < 100; ++k) {
      const double heading = random.uniform(0.0, kTwoPi);
      bool near_an_end = false;
      for (const HeadingInterval& interval : set.intervals())
        for (const double end : {interval.low, interval.high})
          near_an_end = near_an_end || std::abs(wrap_signed(heading - end)) < 1e-6;
      if (near_an_end) continue;
      ASSERT_EQ(set.contains(heading), free_at(*queries.sweep, body, heading))
          << "body " << i << ", heading " << heading;
    }
  }
  EXPECT_GT(partly_free, 30u);
}

// A wheelbase longer than the body leaves the reference point ahead of it or behind.
constexpr Footprint kAhead{.front = 0.9, .rear = -0.5, .left = 0.1, .right = 0.1};
constexpr Footprint kBehind{.front = -0.5, .rear = 0.9, .left = 0.1, .right = 0.1};
constexpr Footprint kUneven{.front = 1.4, .rear = 0.1, .left = 0.2, .right = 0.6};
constexpr Footprint kBeside{.front = 0.9, .rear = 0.5, .left = 0.5, .right = -0.3};

TEST(FreeHeadings, AgreeWithTheBodyPlacedAtEachHeading) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kMixed, .obstacles = 40, .vertices = 7, .fill = 0.4, .seed = 3});
  const World world(clutter.obstacles, clutter.bounds);
  for (const Footprint& footprint : {Vehicle{}.footprint(0.0005), kAhead, kBehind, kUneven, kBeside})
    for (const QuerySet& queries : {make_reference_queries(world), make_embree_queries(world)})
      expect_agreement(world, queries, footprint);
}

// The body turns around a square; its reference point is always within.
TEST(FreeHeadings, ABodyApartFromItsReferencePointIsAskedAboutItself) {
  const Ring square = test::square(-1.1, -1.1, 2.2);
  const World post({{square, {}}});
  const World hole({{test::square(-50, -50, 100), {square}}});
  const TurningBody body{{0, 0}, 1.0, Side::kLeft, Footprint{.front = 3.0, .rear = -1.5, .left = 0.3, .right = 0.3}};
  for (const auto make : {make_reference_queries, +[](const World& world) { return make_embree_queries(world); }}) {
    EXPECT_TRUE(make(post).sweep->free_headings(body).is_full());
    EXPECT_TRUE(make(hole).sweep->free_headings(body).empty());
  }
}

TEST(FreeHeadings, AnEmptyWorldIsFreeAllRound) {
  const World world({});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kLeft, Vehicle{}.footprint()}).is_full());
}

TEST(FreeHeadings, ABodySwallowedByAnObstacleIsNotFree) {
  const World world({{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {}}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kRight, Vehicle{}.footprint()}).empty());
  EXPECT_FALSE(queries.sweep->straight_free(swept_rectangle({0, 0, 0.3}, 5.0, Vehicle{}.footprint())));
}

TEST(FreeHeadings, ABodyInsideAHoleIsFree) {
  const World world({{{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{0, 0}, 2.0, Side::kRight, Vehicle{}.footprint()}).is_full());
}

TEST(FreeHeadings, OutsideTheBoundsNothingIsFree) {
  const World world({}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const QuerySet queries = make_reference_queries(world);
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{30, 30}, 2.0, Side::kLeft, Vehicle{}.footprint()}).empty());
  EXPECT_TRUE(queries.sweep->free_headings(TurningBody{{5, 5}, 2.0, Side::kLeft, Vehicle{}.footprint()}).is_full());
}

// Contacts of ends that edges share are found once.
TEST(EdgeContacts, HaveTheBitsOfEachEdgeAlone) {
  test::RandomInputs random(12);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const TurningBody body{random.point(-1.0, 1.0), random.uniform(0.3, 4.0), i % 2 == 0 ? Side::kLeft : Side::kRight,
                           i % 4 < 2 ? kUneven : kBeside};
    std::vector<Vec2> places(7);
    for (Vec2& place : places) place = random.point(-5.0, 5.0);
    EdgeContacts contacts(body);
    for (int k = 0; k < 40; ++k) {
      const LineSegment edge{places[static_cast<std::size_t>(random.integer(0, 6))],
                             k % 5 == 0 ? random.point(-5.0, 5.0) : places[static_cast<std::size_t>(k % 7)]};
      if (edge.a == edge.b) continue;
      EXPECT_EQ(contacts.may_touch(edge), may_touch(body, edge));
      std::vector<HeadingInterval> together, alone;
      contacts.append_blocked(edge, together);
      append_blocked_headings(body, edge, alone);
      ASSERT_EQ(together.size(), alone.size()) << i << ' ' << k;
      for (std::size_t n = 0; n < alone.size(); ++n) {
        EXPECT_EQ(together[n].low, alone[n].low) << i << ' ' << k;
        EXPECT_EQ(together[n].high, alone[n].high) << i << ' ' << k;
      }
      found += alone.size();
    }
  }
  EXPECT_GT(found, 1000u);
}

}  // namespace
}  // namespace arcway::internal
