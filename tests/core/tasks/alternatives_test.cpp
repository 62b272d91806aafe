#include "arcway/alternatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "tests/support/boxes.h"
#include "tests/support/counting_sweep.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::expect_valid;

using test::box;

// y where a path crosses x for the first time.
double height_at(const Path& path, double x) {
  for (const PathSegment& s : path)
    for (double i = 0.0; i <= 100.0; ++i)
      if (const Pose pose = s.at(s.length * i / 100.0); pose.x >= x) return pose.y;
  return std::nan("");
}

TEST(Alternatives, GoRoundABoxOnBothSides) {
  const World world({box(20, 20, 40, 40)}, box(0, 0, 60, 60).outer);
  const Planner planner(world, Vehicle{});
  const PlanRequest request{.start = {5, 28, 0}, .goal = {55, 28, 0}};
  const std::vector<PlanResult> plans = plan_alternatives(planner, request, 5);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].travel_time, planner.plan(request).travel_time);
  EXPECT_LT(plans[0].travel_time, plans[1].travel_time);
  for (const PlanResult& plan : plans) expect_valid(planner, plan);
  EXPECT_LT(height_at(plans[0].path(), 30.0), 20.0);
  EXPECT_GT(height_at(plans[1].path(), 30.0), 40.0);
  EXPECT_EQ(plan_alternatives(planner, request, 1).size(), 1u);
}

TEST(Alternatives, WithoutBoundsToo) {
  const World world({box(20, 20, 40, 40)});
  const Planner planner(world, Vehicle{});
  const std::vector<PlanResult> plans = plan_alternatives(planner, {.start = {5, 28, 0}, .goal = {55, 28, 0}}, 2);
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_GT(height_at(plans[1].path(), 30.0), 40.0);
}

TEST(Alternatives, AreOneWhereThereIsOneWay) {
  const World lane({}, box(0, 0, 60, 3).outer);
  const Planner planner(lane, Vehicle{});
  const PlanRequest request{.start = {5, 1.5, 0}, .goal = {50, 1.5, 0}};
  EXPECT_EQ(plan_alternatives(planner, request, 4).size(), 1u);
  const std::vector<PlanResult> none = plan_alternatives(planner, {.start = {5, 1.5, 0}, .goal = {70, 1.5, 0}}, 4);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].status, PlanStatus::kGoalOutsideBounds);
  EXPECT_THROW(plan_alternatives(planner, request, 0), std::invalid_argument);
  const std::vector<PlanResult> late = plan_alternatives(planner, request, 4, {.time = 0.0});
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].reason, "no path was found within the time limit of 0 s");
}

TEST(Alternatives, InClutterDifferPairwiseAndAreSorted) {
  const World world = random_world({.obstacles = 30, .vertices = 6, .fill = 0.2, .seed = 21});
  const Vehicle vehicle;
  const Planner planner(world, vehicle);
  int solved = 0;
  for (const PlanRequest& request :
       random_queries(world, make_reference_queries(world), vehicle, {.count = 4, .min_distance = 0.5})) {
    const PlanResult best = planner.plan(request);
    if (!best.solved()) continue;
    ++solved;
    const std::vector<PlanResult> plans = plan_alternatives(planner, request, 4);
    EXPECT_EQ(plans.size(), 4u);
    EXPECT_LE(plans[0].travel_time, best.travel_time);
    for (std::size_t i = 0; i < plans.size(); ++i) {
      expect_valid(planner, plans[i]);
      if (i > 0) {
        EXPECT_LE(plans[i - 1].travel_time, plans[i].travel_time);
      }
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(same_route(plans[i].path(), plans[j].path(), world));
    }
  }
  EXPECT_GE(solved, 2);
}

// Counts what is asked about the world, as time is not tested.
TEST(Alternatives, TakeAFewPlansWorkEach) {
  const World world = random_world({.obstacles = 60, .vertices = 8, .fill = 0.25, .seed = 4});
  const Vehicle vehicle;
  QuerySet queries = make_reference_queries(world);
  const std::vector<PlanRequest> requests =
      random_queries(world, queries, vehicle, {.count = 6, .min_distance = 0.6, .seed = 2});
  const auto counting = std::make_shared<test::CountingSweep>(world);
  queries.sweep = counting;
  std::size_t once = 0, thrice = 0;
  for (const PlanRequest& request : requests) {
    const auto asked = [&](const auto& plan) {
      const std::size_t before = counting->asked() + counting->headings_asked();
      plan(Planner(world, vehicle, backend_of(world, queries), {.graph_mode = GraphMode::kLazy}));
      return counting->asked() + counting->headings_asked() - before;
    };
    once += asked([&](const Planner& planner) { (void)planner.plan(request); });
    thrice += asked([&](const Planner& planner) { (void)plan_alternatives(planner, request, 3); });
  }
  EXPECT_LT(thrice, 7 * once);
}

TEST(Alternatives, InBothGears) {
  const World world({box(6, -1, 8, 1)}, box(-20, -10, 20, 10).outer);
  const Planner planner(world, Vehicle{});
  const PlanRequest request{.start = {0, 0, kPi}, .goal = {14, 0, kPi}, .reverse = true};
  const std::vector<PlanResult> plans = plan_alternatives(planner, request, 2);
  ASSERT_EQ(plans.size(), 2u);
  for (const PlanResult& plan : plans) expect_valid(planner, plan, true);
}

TEST(SameRoute, CountsTheWindingRoundEveryObstacle) {
  const World world({box(4, -1, 6, 1), box(4, 5, 6, 6)});
  const auto over = [](double height) {  // (0, 0) up, across, down
    return Path{{{0, 0, 0.5 * kPi}, height, 0.0}, {{0, height, 0}, 10, 0.0}, {{10, height, -0.5 * kPi}, height, 0.0}};
  };
  Path under = over(2.0);
  for (PathSegment& s : under) s.start = {s.start.x, -s.start.y, -s.start.heading};
  EXPECT_TRUE(same_route(over(2.0), over(4.0), world));
  EXPECT_FALSE(same_route(over(2.0), over(8.0), world));
  EXPECT_FALSE(same_route(over(2.0), under, world));
  // A full turn round an obstacle is a different way as well.
  Path loop = over(2.0);
  loop.insert(loop.begin() + 1, PathSegment{{0, 2, 0}, kTwoPi * 10.0, 0.1});
  EXPECT_FALSE(same_route(over(2.0), loop, world));
}

TEST(SameRoute, SeesWhatLiesBetweenAWideArcAndItsChord) {
  const double radius = 1e4, turn = 0.04;  // 2 m between the arc and its chord, 400 m long
  for (const Gear gear : {Gear::kForward, Gear::kReverse})
    for (const double side : {1.0, -1.0}) {
      const PathSegment arc{{0, 0, 0}, radius * turn, side / radius, gear};
      const Vec2 to = arc.end().position();
      const double along = std::atan2(to.y(), to.x());
      const Path straight{{{0, 0, along}, to.norm(), 0.0}};
      const Vec2 middle = 0.5 * to, away = (arc.at(0.5 * arc.length).position() - middle).normalized();
      const auto obstacle_at = [&](double distance) {
        const Vec2 p = middle + distance * away;
        return World({box(p.x() - 0.01, p.y() - 0.01, p.x() + 0.01, p.y() + 0.01)});
      };
      EXPECT_FALSE(same_route({&arc, 1}, straight, obstacle_at(1.0)));
      EXPECT_TRUE(same_route({&arc, 1}, straight, obstacle_at(-1.0)));
      EXPECT_TRUE(same_route({&arc, 1}, straight, obstacle_at(3.0)));
    }
  // Most of a circle, which starts and ends near the obstacle.
  const Path loop{{{0, 0, 0}, 6.0, 1.0}};
  const Vec2 to = loop[0].end().position();
  const Path back{{{0, 0, std::atan2(to.y(), to.x())}, to.norm(), 0.0}};
  EXPECT_FALSE(same_route(loop, back, World({box(-0.1, 0.9, 0.1, 1.1)})));
  EXPECT_TRUE(same_route(loop, back, World({box(-0.1, 2.1, 0.1, 2.2)})));
}

}  // namespace
}  // namespace arcway::internal
