#include "core/model/swept_widths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/vehicle.h"
#include "core/base/infinity.h"
#include "core/geometry/distance.h"
#include "tests/support/boxes.h"
#include "tests/support/random_bodies.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// By the definition: nearest and farthest point of the parts as seen from the center.
SweptAnnulus annulus_by_distances(std::span<const Ring> parts, Side side, double radius) {
  const Vec2 center(0.0, sign_of(side) * radius);
  SweptAnnulus annulus{kInfinity, 0.0};
  for (const Ring& ring : parts) {
    annulus.inner = std::min(annulus.inner, distance(center, Polygon{ring, {}}));
    for (const Vec2& p : ring) annulus.outer = std::max(annulus.outer, (p - center).norm());
  }
  return annulus;
}

bool is_in(const std::vector<RadiusRange>& ranges, double radius) {
  return std::ranges::any_of(ranges, [&](const RadiusRange& r) { return r.low <= radius && radius <= r.high; });
}

void expect_ordered(const std::vector<RadiusRange>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    EXPECT_LE(ranges[i].low, ranges[i].high);
    if (i > 0) {
      EXPECT_LT(ranges[i - 1].high, ranges[i].low);
    }
  }
}

TEST(SweptWidths, AreThoseOfTheNearestAndFarthestPoint) {
  test::RandomInputs random(1);
  for (int k = 0; k < 100; ++k) {
    const Vehicle vehicle = test::random_body_vehicle(random);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const SweptWidths widths(vehicle.outline(), side);
      for (int i = 0; i < 50; ++i) {
        const double radius = std::exp(random.uniform(-4.0, 4.0));
        const SweptAnnulus expected = annulus_by_distances(vehicle.outline(), side, radius);
        EXPECT_NEAR(widths.at(radius), expected.width(), 1e-12 * (1.0 + radius));
        EXPECT_NEAR(vehicle.swept_annulus(side, radius).inner, expected.inner, 1e-12 * (1.0 + radius));
        EXPECT_NEAR(vehicle.swept_annulus(side, radius).outer, expected.outer, 1e-12 * (1.0 + radius));
      }
    }
  }
}

// The width need not be monotone: several ranges, which a scan finds as well.
TEST(SweptWidths, AreBelowALimitWhereAScanSaysSo) {
  test::RandomInputs random(2);
  constexpr int kSteps = 3000;
  std::size_t several = 0, bounded = 0;
  for (int k = 0; k < 120; ++k) {
    const Vehicle vehicle = test::random_body_vehicle(random);
    const Side side = k % 2 == 0 ? Side::kLeft : Side::kRight;
    const SweptWidths widths(vehicle.outline(), side);
    const double least = std::exp(random.uniform(-3.0, 1.0));
    const double limit = widths.at(std::exp(random.uniform(-2.0, 4.0)));
    const std::vector<RadiusRange> ranges = widths.below(limit, least);
    expect_ordered(ranges);
    several += ranges.size() > 1;
    for (int i = 0; i <= kSteps; ++i) {
      const double radius = least * std::exp(9.0 * i / kSteps);
      EXPECT_EQ(is_in(ranges, radius), widths.at(radius) < limit) << k << " at " << radius;
    }
    for (const auto& [low, high] : ranges) {
      EXPECT_LT(widths.at(low), limit);
      if (low > least) {
        EXPECT_GE(widths.at(std::nextafter(low, 0.0)), limit);
      }
      if (high == kInfinity) continue;
      ++bounded;
      EXPECT_LT(widths.at(high), limit);
      EXPECT_GE(widths.at(std::nextafter(high, kInfinity)), limit);
    }
  }
  EXPECT_GT(several, 3u);
  EXPECT_GT(bounded, 10u);
}

TEST(SweptWidths, LoseNoDigitsAtLargeRadii) {
  const SweptWidths widths(std::vector<Ring>{test::box_ring(-0.1, -0.4, 1.4, 0.4)}, Side::kLeft);
  EXPECT_NEAR(widths.at(1e9) - 0.8, 0.5 * 1.4 * 1.4 / 1e9, 1e-15);
  EXPECT_EQ(widths.at(1e40), 0.8);
}

// A body bent along a circle of 3 m about (0, 3): in a turn with that radius it sweeps its own width.
TEST(SweptWidths, OfABentBodyAreLeastInATurn) {
  Ring bent;
  for (int i = 0; i <= 20; ++i) bent.push_back(Vec2(0.0, 3.0) + 3.2 * Vec2(std::sin(0.05 * i), -std::cos(0.05 * i)));
  for (int i = 20; i >= 0; --i) bent.push_back(Vec2(0.0, 3.0) + 2.8 * Vec2(std::sin(0.05 * i), -std::cos(0.05 * i)));
  const Vehicle vehicle({.max_speed = 2.0, .footprint = {bent}, .min_turning_radius = 2.0});
  EXPECT_FALSE(vehicle.fits_straight(0.5));
  const std::vector<RadiusRange> ranges = vehicle.fitting_radii(0.5, Side::kLeft);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_GT(ranges[0].low, 2.5);
  EXPECT_LT(ranges[0].high, 3.5);
  EXPECT_TRUE(is_in(ranges, 3.0));
  EXPECT_FALSE(vehicle.smallest_fitting_radius(0.5, Side::kLeft));
  EXPECT_TRUE(vehicle.fitting_radii(0.5, Side::kRight).empty());
  EXPECT_TRUE(vehicle.fits_turn(0.5, 3.0, Side::kLeft));
  EXPECT_FALSE(vehicle.fits_turn(0.5, 3.0, Side::kRight));
}

// The closed form of rectangles, against the same rectangle as any body.
TEST(SweptWidths, OfARectangleAreBelowWhereTheClosedFormSaysSo) {
  test::RandomInputs random(3);
  for (int k = 0; k < 200; ++k) {
    const VehicleParameters parameters{.wheelbase = random.uniform(0.2, 3.0),
                                       .max_steering_angle = random.uniform(0.1, 1.5)};
    const Vehicle vehicle(parameters);
    const SweptWidths widths(vehicle.outline(), Side::kLeft);
    const double gap = 0.8 + std::exp(random.uniform(-6.0, 1.0));
    const std::vector<RadiusRange> expected = widths.below(gap, vehicle.min_turning_radius());
    const std::vector<RadiusRange> ranges = vehicle.fitting_radii(gap, Side::kLeft);
    ASSERT_EQ(ranges.size(), expected.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      EXPECT_NEAR(ranges[i].low, expected[i].low, 1e-9 * expected[i].low);
      EXPECT_EQ(ranges[i].high, expected[i].high);
    }
    EXPECT_NEAR(vehicle.smallest_fitting_radius(gap, Side::kLeft).value(), ranges.back().low, 1e-9 * ranges.back().low);
  }
}

}  // namespace
}  // namespace arcway::internal
