#include "core/refine/refine_reversing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/path/speed_profile.h"
#include "core/planner.h"
#include "core/query/query_set.h"
#include "core/search/gear_search.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"

namespace arcway {
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
    const GearSearchResult found = search_gears(start, goal, vehicle, *queries.sweep, {.max_poses = 20000});
    ASSERT_TRUE(found.path) << length;
    RefineOptions options;
    options.max_trials = 100000;
    const RefinedPath fine = refine_reversing_path(*found.path, vehicle, *queries.sweep, 0.0, options, {});
    options.smallest_step = 1.0;  // so large that nothing moves
    const RefinedPath words = refine_reversing_path(*found.path, vehicle, *queries.sweep, 0.0, options, {});
    expect_valid(world, vehicle, start, goal, fine.path);
    expect_valid(world, vehicle, start, goal, words.path);
    EXPECT_LE(fine.travel_time, words.travel_time);
    EXPECT_LE(words.travel_time, found.cost);
    EXPECT_EQ(fine.travel_time, travel_cost(fine.path, vehicle, 0.0));
    gain += 1.0 - fine.travel_time / words.travel_time;
  }
  EXPECT_GT(gain, 0.015);
}

TEST(RefineReversing, RefusesStepsThatNeverEnd) {
  const QuerySet queries = make_reference_queries(World({}));
  const Path path{{{0, 0, 0}, 2.0, 0.0}};
  for (const double step : {0.0, -0.01, std::nan(""), HUGE_VAL}) {
    RefineOptions options;
    options.smallest_step = step;
    EXPECT_THROW((void)refine_reversing_path(path, Vehicle{}, *queries.sweep, 0.0, options, {}), std::invalid_argument);
    EXPECT_THROW((void)refine_path(path, {0, 0, 0}, {2, 0, 0}, Vehicle{}, *queries.sweep, options),
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
      refine_reversing_path(there_and_back, vehicle, *queries.sweep, 0.0, {}, [] { return true; });
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_EQ(stopped.trials, 0u);
  EXPECT_EQ(stopped.path.size(), 2u);
  const RefinedPath refined = refine_reversing_path(there_and_back, vehicle, *queries.sweep, 0.0, {}, {});
  EXPECT_FALSE(refined.interrupted);
  EXPECT_EQ(cusps_of(refined.path), 0u);
  EXPECT_NEAR(length_of(refined.path), 1.0, 1e-9);
}

}  // namespace
}  // namespace arcway
