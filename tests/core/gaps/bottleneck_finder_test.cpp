#include "core/gaps/bottleneck_finder.h"

#include <gtest/gtest.h>

#include <optional>

#include "arcway/sweep_query.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

const Vehicle kVehicle;

std::optional<Bottleneck> bottleneck_of_door(double width) {
  const World world({test::box(0, -20, 1, 0), test::box(0, width, 1, 20 + width)}, test::box(-20, -20, 21, 20).outer);
  return BottleneckFinder(world, kVehicle)({-10, 0, 0}, {11, 0, 0});
}

TEST(BottleneckFinder, NamesDoorsThatNoTurnFitsInto) {
  const double to_turn =
      swept_annulus(kVehicle.footprint(0.5 * kVehicle.safety_margin()), Side::kLeft, kVehicle.min_turning_radius())
          .width();
  for (const double width : {0.5 * widest_hopeless_gap(kVehicle), 0.99 * to_turn}) {
    const auto found = bottleneck_of_door(width);
    ASSERT_TRUE(found) << width;
    EXPECT_NEAR(found->width, width, 1e-12);
    EXPECT_EQ(found->too_narrow(), width < widest_hopeless_gap(kVehicle));
    EXPECT_EQ(found->needed_to_turn, to_turn);
  }
}

// Though its gaps are known.
TEST(BottleneckFinder, HasNothingToSayOfWiderOnes) {
  const SweptAnnulus swept =
      swept_annulus(kVehicle.footprint(0.5 * kVehicle.safety_margin()), Side::kLeft, kVehicle.min_turning_radius());
  ASSERT_LT(1.01 * swept.width(), swept.outer);
  EXPECT_FALSE(bottleneck_of_door(1.01 * swept.width()));
}

}  // namespace
}  // namespace arcway::internal
