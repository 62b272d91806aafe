#include "core/geometry/quick_direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arcway/angle.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(QuickDirection, IsTheDirection) {
  test::RandomInputs random(1);
  double worst = 0.0;
  const auto compare = [&](double heading) {
    const double error = (quick_direction_of(heading) - direction_of(heading)).cwiseAbs().maxCoeff();
    worst = std::max(worst, error);
    ASSERT_LE(error, 0x1p-51) << heading;
  };
  for (int i = 0; i < 1'000'000; ++i) compare(random.uniform(0.0, kTwoPi));
  for (int eighth = 0; eighth <= 16; ++eighth)
    for (double heading = eighth * kPi / 8.0, step = 1e-16; step < 0.1; step *= 3.0)
      for (const double h : {heading - step, heading + step})
        if (h >= 0.0 && h <= kTwoPi) compare(h);
  compare(0.0);
  compare(kTwoPi);
  EXPECT_GT(worst, 0.0);  // it is another function
}

TEST(QuickAngle, IsNearlyThatOfAtan2) {
  test::RandomInputs random(2);
  double worst = 0.0;
  const auto compare = [&](const Vec2& d) {
    const double error = std::abs(wrap_signed(quick_angle_of(d) - std::atan2(d.y(), d.x())));
    worst = std::max(worst, error);
    ASSERT_LE(error, kQuickAngleError) << d.x() << " " << d.y();
  };
  for (int i = 0; i < 100'000; ++i) compare(random.uniform(0.1, 100.0) * direction_of(random.uniform(0.0, kTwoPi)));
  for (const double x : {-2.0, 0.0, 2.0})
    for (const double y : {-2.0, 0.0, 2.0})
      if (x != 0.0 || y != 0.0) compare({x, y});
  EXPECT_GT(worst, 0.1 * kQuickAngleError);  // it is another function
}

}  // namespace
}  // namespace arcway::internal
