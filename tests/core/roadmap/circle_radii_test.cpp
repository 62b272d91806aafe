#include "core/roadmap/circle_radii.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace arcway::internal {
namespace {

std::vector<double> list(std::span<const double> radii) { return {radii.begin(), radii.end()}; }

Vehicle turning(double left, double right) {
  return Vehicle({.min_turning_radius = left, .min_turning_radius_right = right});
}

TEST(CircleRadii, AreTheGivenOnesToBothSidesOfAnEvenVehicle) {
  const std::vector<double> given{1.3, 2.7, 9.1};
  const CircleRadii radii(turning(1.3, 1.3), given);
  EXPECT_EQ(list(radii.of(Side::kLeft)), given);
  EXPECT_EQ(list(radii.of(Side::kRight)), given);
}

TEST(CircleRadii, ReachTheLargestOneFromTheSmallestOfTheirSide) {
  const std::vector<double> given{1.0, 2.0, 4.0, 16.0};
  const CircleRadii radii(turning(4.0, 1.0), given);
  EXPECT_EQ(list(radii.of(Side::kRight)), given);
  const std::vector<double> left = list(radii.of(Side::kLeft));
  ASSERT_EQ(left.size(), 4u);
  EXPECT_EQ(left[0], 4.0);
  EXPECT_NEAR(left[3], 16.0, 1e-12);
  // In equal shares of the ratio: 16 to 4, where the others have 16 to 1.
  EXPECT_NEAR(left[1], 4.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(left[2], 8.0, 1e-12);
  EXPECT_EQ(radii.front(), SideRadii(4.0, 1.0));
}

TEST(CircleRadii, AreTheSmallestOnesWhereTheOthersDoNotReachThem) {
  EXPECT_EQ(list(CircleRadii(turning(1.0, 50.0), {1.0, 2.0}).of(Side::kRight)), std::vector<double>({50.0, 50.0}));
  EXPECT_EQ(list(CircleRadii(turning(1.0, 5.0), {2.0}).of(Side::kRight)), std::vector<double>{5.0});
}

TEST(CircleRadii, FirstOnesKeepTheirSides) {
  const CircleRadii radii = CircleRadii(turning(1.0, 3.0), {1.0, 9.0}).first(1);
  EXPECT_EQ(radii.size(), 1u);
  EXPECT_EQ(radii[0], SideRadii(1.0, 3.0));
}

TEST(CircleRadii, TightestOnesLeadRoundVerticesToBothSides) {
  const CircleRadii radii{0.3, 0.6, 1.2};
  EXPECT_EQ(radii.tightest({1.0, 1.0, 0.2, 0.2}), 1u);
  EXPECT_EQ(radii.tightest({1.0, 1.0, 0.2, 0.5}), 2u);
  EXPECT_EQ(radii.tightest({1.0, 1.0, 0.6, 0.5}), 3u);
  EXPECT_EQ(radii.tightest({1.0, 1.0, 1.2, 0.5}), 3u);
  EXPECT_EQ(CircleRadii(turning(0.3, 0.5), {0.3, 0.6}).tightest({1.0, 1.0, 0.2, 0.4}), 1u);
}

}  // namespace
}  // namespace arcway::internal
