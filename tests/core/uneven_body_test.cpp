// Bodies that reach further to one side of the reference point than to the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "accel/backend/make_queries.h"
#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "core/base/infinity.h"
#include "core/gaps/dead_end.h"
#include "core/gaps/enclosure.h"
#include "core/geometry/distance.h"
#include "tests/support/boxes.h"
#include "tests/support/mirrored.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

constexpr std::array kUnevenBodies{Footprint{1.4, 0.1, 0.9, 0.2}, Footprint{0.8, 0.7, 0.1, 0.6},
                                   Footprint{1.0, 0.4, 1.0, -0.3}, Footprint{-0.3, 1.5, -0.2, 0.7}};

std::vector<Polygon> cluttered(std::uint64_t seed) {
  return generate_clutter({.kind = ClutterKind::kMixed, .obstacles = 40, .vertices = 7, .fill = 0.3, .seed = seed})
      .obstacles;
}

// The body at a pose, written out.
Polygon outline(const Footprint& body, const Pose& pose) {
  const Vec2 ahead = direction_of(pose.heading), left(-ahead.y(), ahead.x());
  const auto corner = [&](double x, double y) -> Vec2 { return pose.position() + x * ahead + y * left; };
  return {{corner(-body.rear, -body.right), corner(body.front, -body.right), corner(body.front, body.left),
           corner(-body.rear, body.left)},
          {}};
}

double room_around(const std::vector<Polygon>& obstacles, const Polygon& body) {
  double least = kInfinity;
  for (const Polygon& obstacle : obstacles) least = std::min(least, distance(body, obstacle));
  return least;
}

// Every pose of the turn on its own, as a polygon that meets an obstacle or not.
TEST(UnevenBody, HeadingsAreFreeWhereItsOutlineMeetsNothing) {
  const std::vector<Polygon> obstacles = cluttered(3);
  const World world(obstacles);
  const QuerySet reference = make_reference_queries(world), embree = make_embree_queries(world);
  test::RandomInputs random(4);
  int free = 0, blocked = 0;
  const Vec2 span = world.box().max - world.box().min;
  for (int i = 0; i < 160; ++i) {
    const Vec2 center = world.box().min + Vec2(random.uniform(0, 1) * span.x(), random.uniform(0, 1) * span.y());
    const TurningBody body{center, random.uniform(0.3, 4.0), i % 2 == 0 ? Side::kLeft : Side::kRight,
                           kUnevenBodies[static_cast<std::size_t>(i / 2) % kUnevenBodies.size()]};
    const HeadingSet set = reference.sweep->free_headings(body), same = embree.sweep->free_headings(body);
    ASSERT_TRUE(std::ranges::equal(set.intervals(), same.intervals(),
                                   [](const auto& a, const auto& b) { return a.low == b.low && a.high == b.high; }));
    for (int k = 0; k < 60; ++k) {
      const double heading = random.uniform(0.0, kTwoPi);
      const Vec2 at = center + body.radius * direction_of(heading - sign_of(body.side) * 0.5 * kPi);
      const double room = room_around(obstacles, outline(body.body, {at.x(), at.y(), heading}));
      if (room > 0.0 && room < 1e-9) continue;
      const bool is_free = set.contains(heading);
      ++(is_free ? free : blocked);
      bool near_an_end = false;
      for (const HeadingInterval& interval : set.intervals())
        for (const double end : {interval.low, interval.high})
          near_an_end = near_an_end || std::abs(wrap_signed(heading - end)) < 1e-6;
      if (near_an_end) continue;
      ASSERT_EQ(is_free, room > 0.0) << "body " << i << ", heading " << heading;
    }
  }
  EXPECT_GT(free, 500);
  EXPECT_GT(blocked, 500);
}

TEST(UnevenBody, StraightsAreFreeWhereItsOutlineMeetsNothing) {
  const std::vector<Polygon> obstacles = cluttered(5);
  const World world(obstacles);
  const QuerySet reference = make_reference_queries(world), embree = make_embree_queries(world);
  test::RandomInputs random(6);
  int free = 0, blocked = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec2 span = world.box().max - world.box().min;
    const Vec2 p = world.box().min + Vec2(random.uniform(0, 1) * span.x(), random.uniform(0, 1) * span.y());
    const Pose from{p.x(), p.y(), random.uniform(0.0, kTwoPi)};
    const double length = random.uniform(0.0, 8.0);
    Footprint body = kUnevenBodies[static_cast<std::size_t>(i) % kUnevenBodies.size()];
    const bool is_free = reference.sweep->straight_free(swept_rectangle(from, length, body));
    ASSERT_EQ(embree.sweep->straight_free(swept_rectangle(from, length, body)), is_free);
    body.front += length;
    const double room = room_around(obstacles, outline(body, from));
    if (room > 0.0 && room < 1e-9) continue;
    ASSERT_EQ(is_free, room > 0.0) << i;
    ++(is_free ? free : blocked);
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(blocked, 300);
}

TEST(UnevenBody, IsFreeInAMirrorWhereItsMirrorImageIs) {
  const World world(cluttered(7)), mirrored(test::mirrored(cluttered(7)));
  const QuerySet queries = make_embree_queries(world), others = make_embree_queries(mirrored);
  test::RandomInputs random(8);
  int partly_free = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec2 span = world.box().max - world.box().min;
    const Vec2 p = world.box().min + Vec2(random.uniform(0, 1) * span.x(), random.uniform(0, 1) * span.y());
    const Footprint& body = kUnevenBodies[static_cast<std::size_t>(i) % kUnevenBodies.size()];
    const Pose pose{p.x(), p.y(), random.uniform(-kPi, kPi)};
    EXPECT_EQ(queries.sweep->straight_free(swept_rectangle(pose, 1.0, body)),
              others.sweep->straight_free(swept_rectangle(test::mirrored(pose), 1.0, test::mirrored(body))));
    const TurningBody turning{p, random.uniform(0.3, 3.0), i % 3 == 0 ? Side::kLeft : Side::kRight, body};
    const TurningBody other{test::mirrored(p), turning.radius, opposite(turning.side), test::mirrored(body)};
    const HeadingSet free = queries.sweep->free_headings(turning), other_free = others.sweep->free_headings(other);
    for (int k = 0; k < 20; ++k) {
      const double heading = random.uniform(-kPi, kPi);
      EXPECT_NEAR(free.reach(heading, Side::kLeft), other_free.reach(-heading, Side::kRight), 1e-7);
    }
    partly_free += !free.empty() && !free.is_full();
  }
  EXPECT_GT(partly_free, 100);
}

// A lane that ends, with more room on one side than on the other.
TEST(UnevenBody, DeadEndsAreThoseOfItsMirrorImage) {
  const Footprint body{1.0, 0.5, 0.9, 0.2};
  int proofs = 0, at_start = 0;
  for (const double left : {0.95, 1.2, 2.0, 4.0})
    for (const double right : {0.25, 0.5, 1.5, 4.0})
      for (const bool is_start : {true, false}) {
        const std::vector<Polygon> walls{test::box(-9, left, 9, left + 1), test::box(-9, -right - 1, 9, -right),
                                         test::box(is_start ? 1.5 : -2.0, -right, is_start ? 2.5 : -1.0, left)};
        const World world(walls), mirrored(test::mirrored(walls));
        const Pose near{0.0, 0.0, 0.0}, far{30.0, 30.0, 1.0};
        const auto proof_in = [&](const World& in, const Footprint& of, bool is_mirrored) {
          const Pose a = is_mirrored ? test::mirrored(near) : near, b = is_mirrored ? test::mirrored(far) : far;
          const QuerySet queries = make_reference_queries(in);
          return find_dead_end(is_start ? a : b, is_start ? b : a, {of, 1.3, *queries.sweep, Outlines(in)}, {1, 20000});
        };
        const auto proof = proof_in(world, body, false), other = proof_in(mirrored, test::mirrored(body), true);
        ASSERT_EQ(proof.has_value(), other.has_value()) << left << " " << right << " " << is_start;
        if (!proof) continue;
        ++proofs;
        at_start += proof->at_start;
        EXPECT_EQ(proof->at_start, other->at_start);
        EXPECT_NEAR(proof->reach, other->reach, 1e-6);
      }
  EXPECT_GT(at_start, 3);
  EXPECT_GT(proofs, at_start + 3);
}

// Backwards from a goal the vehicle drives as a turned one does forwards: front and rear change places, and the sides.
TEST(UnevenBody, DeadEndsOfGoalsAreThoseOfStartsOfTheTurnedBody) {
  const Footprint body{1.0, 0.5, 0.9, 0.2}, turned{0.5, 1.0, 0.2, 0.9};
  int proofs = 0;
  for (const double left : {0.95, 1.2, 2.0, 4.0})
    for (const double right : {0.25, 0.5, 1.5, 4.0}) {
      const World world({test::box(-9, left, 9, left + 1), test::box(-9, -right - 1, 9, -right),
                         test::box(-2.0, -right, -1.0, left)});
      const QuerySet queries = make_reference_queries(world);
      const Outlines outlines(world);
      const Pose near{0.0, 0.0, 0.0}, far{30.0, 30.0, 1.0}, turned_near{0.0, 0.0, kPi},
          turned_far{30.0, 30.0, 1.0 + kPi};
      const auto goal = find_dead_end(far, near, {body, 1.3, *queries.sweep, outlines}, {1, 20000});
      const auto start = find_dead_end(turned_near, turned_far, {turned, 1.3, *queries.sweep, outlines}, {1, 20000});
      ASSERT_EQ(goal.has_value(), start.has_value()) << left << " " << right;
      if (!goal) continue;
      ++proofs;
      EXPECT_FALSE(goal->at_start);
      EXPECT_TRUE(start->at_start);
      EXPECT_NEAR(goal->reach, start->reach, 1e-6);
    }
  EXPECT_GT(proofs, 3);
}

// Where F is on a body does not matter to what encloses it.
TEST(UnevenBody, IsEnclosedAsTheSameBodyIsAboutItsMiddle) {
  const World cell(
      {test::box(-3, 2, 3, 3), test::box(-3, -3, 3, -2), test::box(2, -2, 3, 2), test::box(-3, -2, -2, 2)});
  const QuerySet queries = make_reference_queries(cell);
  const Footprint even{0.75, 0.75, 0.4, 0.4}, uneven{0.75, 0.75, 0.1, 0.7};
  const auto proof = find_enclosure({0, 0, 0.3}, {30, 0, 0}, {even, *queries.sweep}, 1 << 16);
  const Vec2 moved = 0.3 * perpendicular(direction_of(0.3));
  const auto other = find_enclosure({moved.x(), moved.y(), 0.3}, {30, 0.3, 0}, {uneven, *queries.sweep}, 1 << 16);
  ASSERT_TRUE(proof);
  ASSERT_TRUE(other);
  EXPECT_EQ(proof->at_start, other->at_start);
  EXPECT_NEAR(proof->reach, other->reach, 1e-9);
}

}  // namespace
}  // namespace arcway::internal
