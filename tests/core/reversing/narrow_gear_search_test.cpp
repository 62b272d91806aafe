#include "core/reversing/narrow_gear_search.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"
#include "tests/support/narrow_queries.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

using test::car;
using test::NarrowQuery;
using test::planner_of;
using test::ring_of_box;
using test::Variant;

// A room around the middle of a car whose rear axle is at the origin, closed all round.
NarrowQuery room(const char* name, double length, double width, const Pose& goal) {
  const double middle = 0.5 * car().wheelbase, x = 0.5 * length, y = 0.5 * width;
  return {name, car(), {}, ring_of_box(middle - x, -y, middle + x, y), {0.0, 0.0, 0.0}, goal};
}

std::vector<NarrowQuery> narrow_queries() {
  return {
      room("car turns round in a room of 7.5 m", 7.5, 7.5, {2.7, 0.0, kPi}),
      {"car parks in a bay that is 1 m longer",
       car(),
       {ring_of_box(-6.0, -2.2, 0.0, 0.0), ring_of_box(5.5, -2.2, 10.0, 0.0), ring_of_box(-6.0, -4.0, 10.0, -2.2)},
       ring_of_box(-12.0, -6.0, 16.0, 7.0),
       {-6.0, 1.4, 0.0},
       {1.4, -1.1, 0.0}},
      {"car turns round in an aisle",
       car(),
       {ring_of_box(-15.0, 3.0, 15.0, 4.0), ring_of_box(-15.0, -4.0, 15.0, -3.0)},
       ring_of_box(-15.0, -4.0, 15.0, 4.0),
       {0.0, 0.0, 0.0},
       {2.7, 0.0, kPi}},
  };
}

class NarrowWaysInBothGears : public testing::TestWithParam<Variant> {};

TEST_P(NarrowWaysInBothGears, AreFound) {
  for (const NarrowQuery& query : narrow_queries()) {
    SCOPED_TRACE(query.name);
    const Planner planner = planner_of(query, GetParam());
    const PlanResult result =
        planner.plan({.start = GetParam()(query.start), .goal = GetParam()(query.goal), .reverse = true});
    EXPECT_TRUE(result.solved()) << result.reason;
    if (result.solved()) test::expect_valid(planner, result, true);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, NarrowWaysInBothGears, testing::ValuesIn(test::variants()),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

// In a room that is a little longer than the body and shorter than its diagonal.
TEST(NarrowGearSearch, TheRoomForAnAboutTurnIsProvedTooSmall) {
  const NarrowQuery query = room("too short", 4.7, 4.7, {2.7, 0.0, kPi});
  const Planner planner = planner_of(query, test::variants().front());
  const PlanResult result = planner.plan({.start = query.start, .goal = query.goal, .reverse = true});
  EXPECT_EQ(result.status, PlanStatus::kNoPassage);
  EXPECT_EQ(result.certainty, Certainty::kProved) << result.reason;
}

// There may be a path of more changes of gear than were tried.
TEST(NarrowGearSearch, WhatWasNotFoundIsNotCalledBlocked) {
  const NarrowQuery query = room("tight", 5.35, 5.35, {2.7, 0.0, kPi});
  const Planner planner = planner_of(query, test::variants().front());
  const PlanResult result =
      planner.plan({.start = query.start, .goal = query.goal, .reverse = true, .max_gear_changes = 1});
  EXPECT_EQ(result.status, PlanStatus::kNoPath);
  EXPECT_EQ(result.certainty, Certainty::kGaveUp);
  EXPECT_NE(result.reason.find("at most 1 changes of gear were allowed"), std::string::npos) << result.reason;
}

// Two walls with a car between them and the goal on the other side of one; the inner sides have so many equal edges.
std::size_t poses_between_walls(int edges) {
  const auto wall = [edges](double inner, double outer) {
    Ring ring{{-12.0, outer}, {16.0, outer}};
    for (int i = 0; i <= edges; ++i) ring.emplace_back(16.0 - 28.0 * i / edges, inner);
    return Polygon{std::move(ring)};
  };
  const World world(
      {wall(2.5, 3.5), wall(-2.5, -3.5), test::box(-13.0, -3.5, -12.0, 3.5), test::box(16.0, -3.5, 17.0, 3.5)});
  const Roadmap map = test::lazy_map(world, Vehicle(car()));
  return search_narrow_gears(map, {0.0, 0.0, 0.0}, {0.0, 20.0, 0.0}, {.max_poses = 300}).poses;
}

// Where motions are compared with thousands of edges each, the search ends after fewer poses.
TEST(NarrowGearSearch, EndsAfterFewerPosesWhereEachTakesLong) {
  const std::size_t simple = poses_between_walls(1), fine = poses_between_walls(2'000);
  EXPECT_EQ(simple, 300u);
  EXPECT_GT(fine, 0u);
  EXPECT_LT(fine, simple / 2);
}

}  // namespace
}  // namespace arcway::internal
