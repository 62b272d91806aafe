#include "arcway/evading_plan.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "arcway/planner.h"
#include "arcway/validation.h"
#include "core/motion/clearance.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

// A lane along the x axis, with a box beside it that is nearest at 15 m.
PlanResult lane() {
  const World world({{test::box_ring(14.5, 2.0, 15.5, 3.0), {}}});
  return plan(world, Vehicle(), {0.0, 0.0, 0.0}, {40.0, 0.0, 0.0});
}

// Stands across the lane until it vanishes.
MovingObstacle barrier(double until) {
  return {.outline = test::box_ring(20.0, -3.0, 21.0, 1.0), .velocity = {0.0, 0.0}, .until = until};
}

TEST(EvadingPlan, DrivesTheSamePathLater) {
  const PlanResult given = lane();
  ASSERT_TRUE(given.solved()) << given.reason;
  const std::vector obstacles{barrier(10.0)};
  const PlanResult evading = evading_plan(given, obstacles);
  ASSERT_TRUE(evading.solved()) << evading.reason;
  EXPECT_GT(evading.travel_time, given.travel_time);
  EXPECT_GT(evading.segments.size(), given.segments.size());
  EXPECT_NEAR(evading.min_clearance, given.min_clearance, 1e-9);
  const PathSegment& nearest = evading.segments.at(evading.clearance_index).segment;
  const Clearance clearance = clearance_along(nearest, evading.scene->vehicle.body(), evading.scene->world);
  EXPECT_EQ(clearance.distance, evading.min_clearance);
  const ValidationReport report = Validator(given.scene->world)(given.scene->vehicle, given.start, given.goal,
                                                                evading.timed_path(), {.moving = obstacles});
  EXPECT_TRUE(report.valid()) << to_string(report);
  EXPECT_NEAR(report.travel_time, evading.travel_time, 1e-9);
}

TEST(EvadingPlan, ObeysTheSpeedLimitsOfZones) {
  const World world = World({{test::box_ring(14.5, 2.0, 15.5, 3.0), {}}})
                          .with_zones({{Polygon::rectangle({3.0, -50.0}, {9.0, 50.0}), SpeedLimit{1.5}},
                                       {Polygon::rectangle({24.0, -50.0}, {32.0, 50.0}), SpeedLimit{2.0}}});
  const PlanResult given = plan(world, Vehicle(), {0.0, 0.0, 0.0}, {40.0, 0.0, 0.0});
  ASSERT_TRUE(given.solved()) << given.reason;
  const std::vector obstacles{barrier(10.0)};
  const PlanResult evading = evading_plan(given, obstacles);
  ASSERT_TRUE(evading.solved()) << evading.reason;
  EXPECT_GT(evading.travel_time, given.travel_time);
  const ValidationReport report =
      Validator(world)(given.scene->vehicle, given.start, given.goal, evading.timed_path(), {.moving = obstacles});
  EXPECT_TRUE(report.valid()) << to_string(report);
}

TEST(EvadingPlan, KeepsAPlanThatIsFree) {
  const PlanResult given = lane();
  const PlanResult kept = evading_plan(given, std::vector{barrier(0.1)});
  EXPECT_EQ(kept.travel_time, given.travel_time);
  EXPECT_EQ(kept.min_clearance, given.min_clearance);
  EXPECT_EQ(kept.segments.size(), given.segments.size());
}

TEST(EvadingPlan, HasNoPathWhereNoneIsFree) {
  const PlanResult given = lane();
  const PlanResult none = evading_plan(given, std::vector{barrier(100.0)});
  EXPECT_EQ(none.status, PlanStatus::kConflict);
  EXPECT_EQ(none.certainty, Certainty::kGaveUp);
  EXPECT_NE(none.reason.find("the horizon of 60 s"), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find("meets moving obstacle 0 in segment 0 from "), std::string::npos) << none.reason;
  EXPECT_TRUE(none.segments.empty());
  EXPECT_EQ(none.travel_time, 0.0);
  EXPECT_TRUE(evading_plan(given, std::vector{barrier(100.0)}, {.horizon = 150.0}).solved());
  EXPECT_EQ(evading_plan(none, std::vector{barrier(0.1)}).status, PlanStatus::kConflict);
}

}  // namespace
}  // namespace arcway::internal
