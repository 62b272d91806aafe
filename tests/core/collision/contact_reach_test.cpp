#include "core/collision/contact_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "arcway/angle.h"
#include "arcway/datasets/catalog.h"
#include "arcway/query_set.h"
#include "core/roadmap/turn_circle.h"
#include "tests/support/random_bodies.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

class ContactReachOnClutter : public testing::TestWithParam<Footprint> {
 protected:
  // Calls visit(pose) for some poses at which the body is free, most of them near obstacles.
  template <class Visit>
  void for_free_poses(Visit&& visit) {
    test::RandomInputs random(7);
    for (int i = 0; i < 3000; ++i) {
      const Pose pose{random.uniform(0.0, 120.0), random.uniform(0.0, 120.0), random.uniform(0.0, kTwoPi)};
      if (queries_.sweep->straight_free(swept_rectangle(pose, 0.0, body_))) visit(pose);
    }
  }

  const World world_ = catalog_world("clutter/star/n100/m10/f30");
  const QuerySet queries_ = make_reference_queries(world_);
  const Outlines outlines_{world_};
  const Footprint body_ = GetParam();
};

INSTANTIATE_TEST_SUITE_P(Bodies, ContactReachOnClutter,
                         testing::Values(Footprint{1.4, 0.1, 0.4, 0.4}, Footprint{1.4, 0.1, 0.6, 0.1},
                                         Footprint{1.4, 0.1, -0.1, 0.7}, Footprint{1.4, 0.1, 0.7, -0.4}),
                         [](const auto& body) { return "Body" + std::to_string(body.index); });

TEST_P(ContactReachOnClutter, IsThatOfFreeHeadingsOnArcs) {
  constexpr double kMost = 6.0;
  ContactReach contact(outlines_, body_);
  int early = 0;
  for_free_poses([&](const Pose& pose) {
    contact.begin(pose, kMost);
    for (const double radius : {0.3, 1.3, 20.0})
      for (const Side side : {Side::kLeft, Side::kRight})
        for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
          const TurnCircle circle = turn_circle(pose, radius, side);
          const double reach = queries_.sweep->free_headings({circle.center, radius, side, body_})
                                   .reach(pose.heading, gear == Gear::kForward ? side : opposite(side));
          const double expected = std::min(radius * reach, kMost);
          EXPECT_NEAR(contact(sign_of(side) / radius, gear), expected, 1e-6);
          if (expected < kMost) ++early;
        }
  });
  EXPECT_GT(early, 1000);
}

TEST_P(ContactReachOnClutter, IsThatOfSweptRectanglesOnLines) {
  constexpr double kMost = 6.0, kSlack = 1e-9;
  ContactReach contact(outlines_, body_);
  int early = 0;
  for_free_poses([&](const Pose& pose) {
    contact.begin(pose, kMost);
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      const double reach = contact(0.0, gear);
      const auto is_free = [&](double length) {
        return queries_.sweep->straight_free(
            swept_rectangle(PathSegment{pose, length, 0.0, gear}.forwards().start, length, body_));
      };
      EXPECT_TRUE(is_free(reach - kSlack));
      if (reach >= kMost) continue;
      EXPECT_FALSE(is_free(reach + kSlack));
      ++early;
    }
  });
  EXPECT_GT(early, 100);
}

class ContactReachOfShapes : public ::testing::Test {
 protected:
  const World world_ = catalog_world("clutter/star/n100/m10/f30");
  const QuerySet queries_ = make_reference_queries(world_);
  const Outlines outlines_{world_};
  test::RandomInputs random_{8};
};

TEST_F(ContactReachOfShapes, IsThatOfTheSweepQuery) {
  constexpr double kMost = 6.0, kSlack = 1e-6;
  int arcs = 0, lines = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vehicle vehicle = test::random_body_vehicle(random_);
    const Body body = vehicle.body(0.0005);
    const Pose pose{random_.uniform(0.0, 120.0), random_.uniform(0.0, 120.0), random_.uniform(0.0, kTwoPi)};
    if (!queries_.sweep->straight_free({pose, 0.0, body})) continue;
    ContactReach contact(outlines_, body);
    contact.begin(pose, kMost);
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      const double radius = random_.uniform(0.3, 10.0);
      const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
      const TurnCircle circle = turn_circle(pose, radius, side);
      const double reach = queries_.sweep->free_headings(TurningBody{circle.center, radius, side, body})
                               .reach(pose.heading, gear == Gear::kForward ? side : opposite(side));
      const double expected = std::min(radius * reach, kMost);
      EXPECT_NEAR(contact(sign_of(side) / radius, gear), expected, 1e-6) << i;
      arcs += expected < kMost;
      const double driven = contact(0.0, gear);
      const auto is_free = [&](double length) {
        return queries_.sweep->straight_free({PathSegment{pose, length, 0.0, gear}.forwards().start, length, body});
      };
      EXPECT_TRUE(is_free(std::max(0.0, driven - kSlack))) << i;
      if (driven >= kMost) continue;
      EXPECT_FALSE(is_free(driven + kSlack)) << i;
      ++lines;
    }
  }
  EXPECT_GT(arcs, 300);
  EXPECT_GT(lines, 300);
}

// What a motion costs: an edge in the way ends it before those further away are looked at.
TEST(ContactReach, CountsTheEdgesThatItCompares) {
  const Footprint body{1.4, 0.1, 0.4, 0.4};
  std::vector<Polygon> walls;
  for (const double x : {3.0, 6.0, 9.0, 12.0})
    walls.push_back({{{x, -1.0}, {x + 0.5, -1.0}, {x + 0.5, 1.0}, {x, 1.0}}, {}});
  const Outlines outlines{World(std::move(walls))};
  ContactReach contact(outlines, body);
  contact.begin({0.0, 0.0, 0.0}, 15.0);
  EXPECT_EQ(contact.edges_compared(), 0u);
  EXPECT_NEAR(contact(0.0, Gear::kForward), 1.6, 1e-12);
  const std::uint64_t ahead = contact.edges_compared();
  EXPECT_GT(ahead, 0u);
  EXPECT_LT(ahead, 8u);
  EXPECT_NEAR(contact(0.0, Gear::kReverse), 15.0, 1e-12);
  EXPECT_EQ(contact.edges_compared(), ahead + 16u);
}

// A body much longer than what it can drive: edges beside its tail are near the reference point, but not in its way.
TEST(ContactReach, ComparesNoEdgesFurtherFromTheBodyThanItMoves) {
  const Footprint body{10.0, 0.1, 0.4, 0.4};
  std::vector<Polygon> obstacles{{{{10.1, -1.0}, {10.2, -1.0}, {10.2, 1.0}, {10.1, 1.0}}, {}}};
  for (const double x : {1.0, 2.0, 3.0, 4.0}) obstacles.push_back({{{x, 2.0}, {x + 0.5, 2.0}, {x, 2.5}}, {}});
  const Outlines outlines{World(std::move(obstacles))};
  ContactReach contact(outlines, body);
  contact.begin({0.0, 0.0, 0.0}, 15.0);
  EXPECT_NEAR(contact(0.0, Gear::kForward), 0.1, 1e-12);
  EXPECT_LE(contact.edges_compared(), 4u);
  const std::uint64_t line = contact.edges_compared();
  EXPECT_LT(contact(0.01, Gear::kForward), 0.2);
  EXPECT_LE(contact.edges_compared(), line + 4u);
}

}  // namespace
}  // namespace arcway::internal
