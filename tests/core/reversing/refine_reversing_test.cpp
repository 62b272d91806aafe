#include "core/reversing/refine_reversing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/planner.h"
#include "arcway/query_set.h"
#include "core/collision/path_cost.h"
#include "core/motion/dubins.h"
#include "core/motion/speed_profile.h"
#include "core/refine/moves.h"
#include "core/reversing/gear_search.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;
using test::expect_valid;

// Into gaps between two boxes, along a lane that leaves little room to swing out. The paper's robot is 1.5 x 0.8 m.
TEST(RefineReversing, CuspsMoveToWhereParkingTakesLessTime) {
  const Vehicle vehicle({.max_acceleration = 2.0});
  double gain = 0.0;
  for (const double length : {1.9, 2.2, 2.6, 3.0}) {
    const World world({box(-6.0, -1.2, 0.0, 0.0), box(length, -1.2, length + 6.0, 0.0),
                       box(-6.0, -3.0, length + 6.0, -1.3), box(-6.0, 2.2, length + 6.0, 3.0)},
                      box(-8.0, -5.0, length + 8.0, 6.0).outer);
    const QuerySet queries = make_reference_queries(world);
    const Pose start{-4.0, 1.2, 0.0}, goal{0.5 * length - 0.65, -0.6, 0.0};
    const GearSearchResult found =
        search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.max_poses = 20000});
    ASSERT_TRUE(found.path) << length;
    RefineOptions options;
    options.max_trials = 100000;
    const RefinedPath fine = refine_reversing_path({*found.path, {}, {}, vehicle, *queries.sweep, options, {}}, {});
    options.smallest_step = 1.0;  // so large that nothing moves
    const RefinedPath words = refine_reversing_path({*found.path, {}, {}, vehicle, *queries.sweep, options, {}}, {});
    expect_valid(world, vehicle, start, goal, fine.path);
    expect_valid(world, vehicle, start, goal, words.path);
    EXPECT_LE(fine.travel_time, words.travel_time);
    EXPECT_LE(words.travel_time, found.cost);
    EXPECT_EQ(fine.travel_time, path_cost(fine.path, vehicle));
    gain += 1.0 - fine.travel_time / words.travel_time;
  }
  EXPECT_GT(gain, 0.015);
}

// Words join places of the path in rounds, and again at the end.
TEST(RefineReversing, TriesAMoveOnceWhereItFoundNothing) {
  const Vehicle vehicle;
  const World world({box(-5.0, 0.8, 60.0, 1.8), box(-5.0, -1.8, 60.0, -0.8)});
  const QuerySet queries = make_reference_queries(world);
  const Pose start{0.0, 0.0, 0.0};
  const Path path{{start, 20.0, 0.0, Gear::kForward}, {{20.0, 0.0, 0.0}, 10.0, 0.0, Gear::kReverse}};
  RefineOptions options;
  options.moves = move_bit("words between places");
  const RefinedPath refined = refine_reversing_path({path, {}, {}, vehicle, *queries.sweep, options, {}}, {});
  const RefinedPath again = refine_reversing_path({refined.path, {}, {}, vehicle, *queries.sweep, options, {}}, {});
  EXPECT_EQ(again.improvements, 0u);
  EXPECT_EQ(again.trials, 151u);  // one sweep over the places
}

// Back and forth along a lane too narrow to turn in: all of it is one line.
TEST(RefineReversing, LeavesNoChangeOfGearThatAWordSaves) {
  const Vehicle vehicle;
  const World world({box(-5.0, 0.8, 60.0, 1.8), box(-5.0, -1.8, 60.0, -0.8)});
  const QuerySet queries = make_reference_queries(world);
  Path zigzag;
  Pose pose{0.0, 0.0, 0.0};
  for (int i = 0; i < 120; ++i) {
    const Gear gear = i % 2 == 0 ? Gear::kForward : Gear::kReverse;
    zigzag.push_back({pose, i % 2 == 0 ? 1.0 : 0.6, 0.02 * (i % 3 - 1), gear});
    pose = zigzag.back().end();
  }
  const RefinedPath refined = refine_reversing_path({zigzag, {}, {}, vehicle, *queries.sweep, {}, {}}, {.cost = 10.0});
  expect_valid(world, vehicle, zigzag.front().start, pose, refined.path);
  EXPECT_EQ(cusps_of(refined.path), 0u);
  EXPECT_LE(refined.trials, RefineOptions{}.max_trials);
}

// In a ring that leaves 2 cm beside a turn that is wider than those of words, to and fro along it.
TEST(RefineReversing, BendsAsALaneDoes) {
  const Vehicle vehicle;
  const double radius = 3.0 * vehicle.min_turning_radius();
  const Footprint body = vehicle.footprint(vehicle.safety_margin());
  const SweptAnnulus swept = swept_annulus(body, Side::kLeft, radius);
  constexpr int kCorners = 256;
  const auto circle = [&](double r) {
    Ring ring;
    for (int i = 0; i < kCorners; ++i) ring.push_back(Vec2(0.0, radius) + r * direction_of(i * kTwoPi / kCorners));
    return ring;
  };
  const World world({Polygon{circle(swept.inner - 0.02), {}}}, circle((swept.outer + 0.02) / std::cos(kPi / kCorners)));
  const QuerySet queries = make_reference_queries(world);
  Path to_and_fro;
  Pose pose{0.0, 0.0, 0.0};
  for (const auto& [turn, gear] :
       {std::pair{1.2, Gear::kForward}, std::pair{0.4, Gear::kReverse}, std::pair{1.2, Gear::kForward}}) {
    to_and_fro.push_back({pose, turn * radius, 1.0 / radius, gear});
    pose = to_and_fro.back().end();
  }
  expect_valid(world, vehicle, to_and_fro.front().start, pose, to_and_fro);
  const RefinedPath refined = refine_reversing_path({to_and_fro, {}, {}, vehicle, *queries.sweep, {}, {}}, {});
  expect_valid(world, vehicle, to_and_fro.front().start, pose, refined.path);
  EXPECT_EQ(cusps_of(refined.path), 0u);
}

// Aside on an open field two changes of gear are faster than a loop without any.
TEST(RefineReversing, TakesNoMoreChangesOfGearThanAllowed) {
  const Vehicle vehicle({.max_acceleration = 50.0});
  const World world({});
  const QuerySet queries = make_reference_queries(world);
  const Pose start{0.0, 0.0, 0.0}, goal{0.0, 2.0, 0.0};
  const Path loop = *dubins_path(DubinsWord::kLSL, start, goal, 3.0);
  const auto refined_with = [&](std::size_t most) {
    const RefinedPath refined = refine_reversing_path({loop, {}, {}, vehicle, *queries.sweep, {}, {}}, {.most = most});
    expect_valid(world, vehicle, start, goal, refined.path);
    return refined;
  };
  const RefinedPath none = refined_with(0), any = refined_with(10);
  EXPECT_EQ(cusps_of(none.path), 0u);
  EXPECT_GT(cusps_of(any.path), 0u);
  EXPECT_LT(any.travel_time, none.travel_time);
}

TEST(RefineReversing, RefusesStepsThatNeverEnd) {
  const QuerySet queries = make_reference_queries(World({}));
  const Path path{{{0, 0, 0}, 2.0, 0.0}};
  for (const double step : {0.0, -0.01, std::nan(""), HUGE_VAL}) {
    RefineOptions options;
    options.smallest_step = step;
    EXPECT_THROW((void)refine_reversing_path({path, {}, {}, Vehicle{}, *queries.sweep, options, {}}, {}),
                 std::invalid_argument);
    EXPECT_THROW((void)refine_path({path, {0, 0, 0}, {2, 0, 0}, Vehicle{}, *queries.sweep, options}),
                 std::invalid_argument);
    EXPECT_THROW(Planner(World({}), Vehicle{}, {.refinement = options}), std::invalid_argument);
  }
}

TEST(RefineReversing, StopsWhenItIsAsked) {
  const Vehicle vehicle;
  const World world({});
  const QuerySet queries = make_reference_queries(world);
  const Path there_and_back{{{0.0, 0.0, 0.0}, 5.0, 0.0, Gear::kForward}, {{5.0, 0.0, 0.0}, 4.0, 0.0, Gear::kReverse}};
  const RefinedPath stopped =
      refine_reversing_path({there_and_back, {}, {}, vehicle, *queries.sweep, {}, StopClock(0.0)}, {});
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(stopped.trials, 0u);
  EXPECT_EQ(stopped.path.size(), 2u);
  const RefinedPath refined = refine_reversing_path({there_and_back, {}, {}, vehicle, *queries.sweep, {}, {}}, {});
  EXPECT_FALSE(refined.interrupted);
  EXPECT_EQ(cusps_of(refined.path), 0u);
  EXPECT_NEAR(length_of(refined.path), 1.0, 1e-9);
}

// All turns and the places of both changes of gear are optimized at once, for a vehicle of one turn speed as well.
TEST(RefineReversing, OptimizesChangesOfGearWithAllTurns) {
  const World world({box(-6.0, -4.0, 12.0, -3.0), box(-6.0, 4.0, 12.0, 5.0)});
  const Outlines outlines(world);
  const QuerySet queries = make_reference_queries(world);
  for (const TurnSpeedLaw& law : {TurnSpeedLaw(ConstantTurnSpeed{1.0}), TurnSpeedLaw(LateralAccelerationLimit{2.0})}) {
    const Vehicle vehicle({.turn_speed = law, .max_acceleration = 2.0});
    Path path{{{0.0, -1.0, 0.0}, 2.0, 0.0}};
    for (const auto& [length, curvature, gear] :
         {std::tuple{2.0, 0.6, Gear::kForward}, {1.5, -0.7, Gear::kReverse}, {1.5, 0.5, Gear::kForward}})
      path.push_back({path.back().end(), length, curvature, gear});
    const Pose start = path.front().start, goal = path.back().end();
    const auto refined = [&](std::uint32_t moves) {
      RefineOptions options;
      options.moves = moves;
      const RefinedPath result = refine_reversing_path({.path = path,
                                                        .start = start,
                                                        .goal = goal,
                                                        .vehicle = vehicle,
                                                        .sweep = *queries.sweep,
                                                        .options = options,
                                                        .world = &world,
                                                        .outlines = &outlines},
                                                       {});
      expect_valid(world, vehicle, start, goal, result.path);
      return result.travel_time;
    };
    const std::uint32_t alone = move_bit("optimize turns in both gears");
    EXPECT_LT(refined(alone), 0.95 * refined(0));
    EXPECT_LE(refined(~0u), 1.0001 * refined(~alone));
  }
}

// Forwards through a clutter and back again: where no word is tried, the change of gear stays. The outlines let the
// turns on either side be optimized.
TEST(RefineReversing, OptimizesTurnsInBothGears) {
  VehicleParameters parameters;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  parameters.max_acceleration = 2.0;
  const Vehicle vehicle(parameters);
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kConvex, .obstacles = 40, .vertices = 10, .fill = 0.25, .seed = 3});
  const World world(clutter.obstacles, clutter.bounds);
  const Outlines outlines(world);
  const QuerySet queries = make_reference_queries(world);
  const Planner planner(world, vehicle, {.radii = {}, .refinement = {.max_trials = 0}});
  RefineOptions options;
  options.moves = move_bit("optimize turns at length") | move_bit("refine between changes of gear");
  test::RandomInputs random(31);
  double there = 0.0, back = 0.0, before_there = 0.0, before_back = 0.0;
  for (int i = 0; i < 6; ++i) {
    Path path = test::next_free_plan(planner, random).path;
    const Path way_back = reversed(path);
    path.insert(path.end(), way_back.begin(), way_back.end());
    const Pose& start = path.front().start;
    const RefineQuery query{.path = path,
                            .start = start,
                            .goal = start,
                            .vehicle = vehicle,
                            .sweep = *queries.sweep,
                            .options = options,
                            .world = &world,
                            .outlines = &outlines};
    const RefinedPath refined = refine_reversing_path(query, {});
    expect_valid(world, vehicle, start, start, refined.path);
    ASSERT_EQ(cusps_of(refined.path), 1u);
    const auto times = [&](const Path& of, double& forwards, double& backwards) {
      const SpeedProfile profile = speed_profile(of, vehicle);
      for (std::size_t k = 0; k < of.size(); ++k)
        (of[k].gear == Gear::kForward ? forwards : backwards) += profile.durations[k];
    };
    times(path, before_there, before_back);
    times(refined.path, there, back);
  }
  EXPECT_LT(there, 0.97 * before_there);
  EXPECT_LT(back, 0.97 * before_back);
}

}  // namespace
}  // namespace arcway::internal
