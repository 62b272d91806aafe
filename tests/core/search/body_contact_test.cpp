#include "core/search/body_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "arcway/angle.h"
#include "arcway/path.h"

namespace arcway::internal {
namespace {

constexpr Footprint kTouchingBody{1.5, 0.5, 0.5, 0.5};
constexpr double kNear = 0.1;

std::optional<BodyContact> contact(const Pose& pose, const LineSegment& edge, const Footprint& body = kTouchingBody) {
  return body_contact(body, {pose.position(), direction_of(pose.heading), 0.0}, edge, kNear);
}

TEST(BodyContact, IsTheLeastWayOut) {
  const Pose pose{0.0, 0.0, 0.0};
  const auto beside = contact(pose, {{1.0, 0.4}, {1.0, 5.0}});
  ASSERT_TRUE(beside);
  EXPECT_DOUBLE_EQ(beside->depth, 0.1);
  const auto ahead = contact(pose, {{1.45, 0.0}, {5.0, 0.0}});
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->depth, 0.05, 1e-15);
  const auto behind = contact(pose, {{-0.3, 0.0}, {-5.0, 0.1}});
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->depth, 0.2, 1e-15);
}

TEST(BodyContact, OfAnEdgeThatACornerCutsIsTheDistanceOfTheCorner) {
  const auto cut = contact({0.0, 0.0, 0.0}, {{1.3, 0.5}, {1.5, 0.3}});
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->depth, 0.2, 1e-12);  // the whole edge lies inside: over the left side
  const auto long_edge = contact({0.0, 0.0, 0.0}, {{-8.2, 10.0}, {11.3, -9.5}});
  ASSERT_TRUE(long_edge);
  EXPECT_NEAR(long_edge->depth, 0.2 / std::sqrt(2.0), 1e-12);
}

TEST(BodyContact, KnowsEdgesNearBy) {
  const auto near = contact({0.0, 0.0, 0.0}, {{1.0, 0.55}, {1.0, 5.0}});
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->depth, -0.05, 1e-15);
  EXPECT_FALSE(contact({0.0, 0.0, 0.0}, {{1.0, 0.65}, {1.0, 5.0}}));
  EXPECT_FALSE(contact({0.0, 0.0, 0.0}, {{1.65, -1.0}, {1.65, 5.0}}));
}

TEST(BodyContact, IsNoneWithinTheDistanceBeside) {
  const auto beside = [](const LineSegment& edge) {
    return distance_beside(kTouchingBody, {2.0, 1.0}, direction_of(0.5 * kPi), edge);
  };
  // The body covers x in [1.5, 2.5] and y in [0.5, 2.5].
  EXPECT_NEAR(beside({{2.0, 4.5}, {3.0, 9.0}}), 2.0, 1e-12);
  EXPECT_NEAR(beside({{1.0, -2.5}, {3.0, -3.0}}), 3.0, 1e-12);
  EXPECT_NEAR(beside({{0.0, 0.0}, {-1.0, 5.0}}), 1.5, 1e-12);
  EXPECT_NEAR(beside({{6.5, 0.0}, {7.5, 1.5}}), 4.0, 1e-12);
  EXPECT_LE(beside({{0.0, 0.0}, {3.0, 1.0}}), 0.0);
}

TEST(BodyContact, KnowsTheSidesApart) {
  const Footprint body{1.5, 0.5, 0.5, 0.2};
  const auto left = contact({0.0, 0.0, 0.0}, {{1.0, 0.4}, {1.0, 5.0}}, body);
  ASSERT_TRUE(left);
  EXPECT_DOUBLE_EQ(left->depth, 0.1);
  const auto right = contact({0.0, 0.0, 0.0}, {{1.0, -0.15}, {1.0, -5.0}}, body);
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->depth, 0.05, 1e-15);
  EXPECT_FALSE(contact({0.0, 0.0, 0.0}, {{1.0, -0.35}, {1.0, -5.0}}, body));
}

// Where depths of two sides are equal the gradient is another one.
TEST(BodyContact, GradientsAreThoseOfTheDepth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  int contacts = 0, kinks = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Pose pose{place(random), place(random), 3.0 * place(random)};
    const LineSegment edge{{place(random), place(random)}, {place(random), place(random)}};
    const auto at = contact(pose, edge);
    if (!at) continue;
    constexpr double kChange = 1e-7;
    const auto x = contact({pose.x + kChange, pose.y, pose.heading}, edge);
    const auto y = contact({pose.x, pose.y + kChange, pose.heading}, edge);
    const auto turned = contact({pose.x, pose.y, pose.heading + kChange}, edge);
    if (!x || !y || !turned) continue;
    ++contacts;
    const double error = std::max({std::abs((x->depth - at->depth) / kChange - at->by_place.x()),
                                   std::abs((y->depth - at->depth) / kChange - at->by_place.y()),
                                   std::abs((turned->depth - at->depth) / kChange - at->by_turn)});
    kinks += error > 1e-4;
  }
  EXPECT_GT(contacts, 1000);
  EXPECT_LT(kinks, 5);
}

}  // namespace
}  // namespace arcway::internal
