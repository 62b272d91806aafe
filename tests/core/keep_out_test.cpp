#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arcway/backend.h"
#include "arcway/planner.h"
#include "arcway/validation.h"
#include "tests/support/boxes.h"

namespace arcway::internal {
namespace {

using test::box;

Vehicle truck() {
  VehicleParameters parameters;
  parameters.name = "truck";
  return Vehicle(parameters);
}

// A keep-out for trucks across the straight way.
World barred() {
  return World({box(0, 30, 4, 34)}, box(-20, -40, 60, 40).outer)
      .with_zones({{box(15, -10, 25, 10), KeepOut{{"truck"}}, "dock"}});
}

constexpr Pose kStart{0, 0, 0}, kGoal{40, 0, 0};

PlanResult plan_between(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal) {
  return Planner(world, vehicle).plan(start, goal);
}

TEST(KeepOut, IsAnObstacleOfTheVehiclesItIsFor) {
  const World world = barred(), as_obstacle({box(0, 30, 4, 34), box(15, -10, 25, 10)}, box(-20, -40, 60, 40).outer);
  const PlanResult car = plan_between(world, Vehicle{}, kStart, kGoal);
  ASSERT_TRUE(car.solved());
  EXPECT_NEAR(car.length, 40.0, 1e-9);
  const PlanResult kept_out = plan_between(world, truck(), kStart, kGoal);
  const PlanResult around = plan_between(as_obstacle, Vehicle{}, kStart, kGoal);
  ASSERT_TRUE(kept_out.solved());
  EXPECT_EQ(kept_out.travel_time, around.travel_time);
  EXPECT_GT(kept_out.length, 41.0);
  EXPECT_EQ(kept_out.scene->world.keep_out_of(1), 0u);
}

TEST(KeepOut, IsNamedWhereAPoseLiesInIt) {
  const PlanResult result = plan_between(barred(), truck(), {20, 0, 0}, kGoal);
  EXPECT_EQ(result.status, PlanStatus::kStartInCollision);
  EXPECT_EQ(result.certainty, Certainty::kProved);
  EXPECT_NE(result.reason.find("keepout zone \"dock\""), std::string::npos) << result.reason;
  EXPECT_EQ(plan_between(barred(), truck(), kStart, {20, 0, 0}).status, PlanStatus::kGoalInCollision);
}

TEST(KeepOut, ABackendOfEitherWorldServes) {
  const World world = barred(), closed = world.for_vehicle(truck());
  const Planner by_map(world, truck(), reference_backend(world));
  const Planner by_closed(world, truck(), reference_backend(closed));
  const Planner all_closed(closed, truck(), reference_backend(closed));
  const double time = by_map.plan(kStart, kGoal).travel_time;
  EXPECT_EQ(by_closed.plan(kStart, kGoal).travel_time, time);
  EXPECT_EQ(all_closed.plan(kStart, kGoal).travel_time, time);
  EXPECT_EQ(by_map.world().obstacle_count(), 2u);
  EXPECT_THROW(Planner(world, truck(), reference_backend(World({box(0, 0, 1, 1)}))), std::invalid_argument);
}

TEST(KeepOut, StaysThroughChangesAndGoesByItsKey) {
  const Planner planner(barred(), truck());
  const Planner without_wall =
      planner.with_obstacles(std::vector{planner.world().key_of(0)}, {{{{5, -30}, {6, -30}, {6, -29}}, {}}});
  EXPECT_GT(without_wall.plan(kStart, kGoal).length, 41.0);
  EXPECT_EQ(without_wall.world().keep_out_of(0), 0u);
  const Planner open = planner.with_obstacles(std::vector{planner.world().key_of(1)}, {});
  EXPECT_NEAR(open.plan(kStart, kGoal).length, 40.0, 1e-9);
}

TEST(KeepOut, IsCheckedByTheValidator) {
  const World world = barred();
  const TimedPath through{{{kStart, 40.0, 0.0}}, {}, {}, {}};
  EXPECT_TRUE(validate(world, Vehicle{}, kStart, kGoal, through).valid());
  const ValidationReport report = validate(world, truck(), kStart, kGoal, through);
  ASSERT_FALSE(report.valid());
  EXPECT_EQ(report.issues[0].violation, Violation::kCollision);
  EXPECT_NE(report.issues[0].message.find("keepout zone \"dock\""), std::string::npos) << report.issues[0].message;
  const PlanResult plan = plan_between(world, truck(), kStart, kGoal);
  EXPECT_TRUE(validate(world, truck(), kStart, kGoal, plan.timed_path()).valid());
}

}  // namespace
}  // namespace arcway::internal
