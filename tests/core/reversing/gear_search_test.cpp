#include "core/reversing/gear_search.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/collision/path_cost.h"
#include "core/motion/reeds_shepp.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;
using test::expect_valid;

// A gap of a length between two boxes along the edge y = 0, a wall behind it. The paper's robot is 1.5 x 0.8 m.
World parking_gap(double length) {
  return World({box(-6.0, -1.2, 0.0, 0.0), box(length, -1.2, length + 6.0, 0.0), box(-6.0, -3.0, length + 6.0, -1.3)},
               box(-8.0, -5.0, length + 8.0, 6.0).outer);
}

TEST(GearSearch, InAnEmptyWorldIsAtLeastAsGoodAsEveryWord) {
  const World world({});
  const QuerySet queries = make_reference_queries(world);
  const Vehicle vehicle;
  test::RandomInputs random(6);
  for (int i = 0; i < 30; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(0.0, 6.0), random.uniform(0.0, 6.0), random.uniform(-kPi, kPi)};
    };
    const Pose start = pose(), goal = pose();
    const GearSearchResult found =
        search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.max_poses = 40});
    ASSERT_TRUE(found.path);
    EXPECT_EQ(found.cost, path_cost(*found.path, vehicle));
    expect_valid(world, vehicle, start, goal, *found.path);
    double shortest = std::numeric_limits<double>::infinity();
    std::optional<Path> best;
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const double length = reeds_shepp_length(word, start, goal, vehicle.min_turning_radius());
      if (length >= shortest) continue;
      shortest = length;
      best = reeds_shepp_path(word, start, goal, vehicle.min_turning_radius());
    }
    EXPECT_LE(found.cost, path_cost(*best, vehicle));
  }
}

TEST(GearSearch, ParksInGapsThatAreHardlyLongerThanTheBody) {
  const Vehicle vehicle;
  std::size_t cusps = 0;
  for (const double length : {3.0, 2.2, 1.9, 1.75}) {
    const World world = parking_gap(length);
    const QuerySet queries = make_reference_queries(world);
    const Pose start{-4.0, 1.2, 0.0};
    const Pose goal{0.5 * length - 0.65, -0.6, 0.0};
    const GearSearchResult in =
        search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.max_poses = 30000});
    ASSERT_TRUE(in.path) << length;
    expect_valid(world, vehicle, start, goal, *in.path);
    EXPECT_GE(cusps_of(*in.path), cusps) << length;
    cusps = cusps_of(*in.path);
    // Out again, and the same every time.
    const GearSearchResult out =
        search_gears({goal, start, vehicle, *queries.sweep, Outlines(world)}, {.max_poses = 30000});
    ASSERT_TRUE(out.path) << length;
    expect_valid(world, vehicle, goal, start, *out.path);
    EXPECT_EQ(search_gears({goal, start, vehicle, *queries.sweep, Outlines(world)}, {.max_poses = 30000}).cost,
              out.cost);
  }
  EXPECT_GT(cusps, 1u);
}

TEST(GearSearch, FindsNothingWhereThereIsNothing) {
  const World world = parking_gap(1.55);
  const QuerySet queries = make_reference_queries(world);
  const Pose start{-4.0, 1.2, 0.0}, goal{0.1 + 0.025, -0.6, 0.0};
  const GearSearchResult found =
      search_gears({start, goal, Vehicle{}, *queries.sweep, Outlines(world)}, {.max_poses = 3000});
  EXPECT_FALSE(found.path);
  EXPECT_FALSE(found.interrupted);
  EXPECT_LE(found.poses, 3000u);
}

TEST(GearSearch, KeepsItsLimits) {
  const World world = parking_gap(2.2);
  const QuerySet queries = make_reference_queries(world);
  const Vehicle vehicle;
  const Pose start{-4.0, 1.2, 0.0}, goal{0.45, -0.6, 0.0};
  const GearSearchResult all = search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {});
  ASSERT_TRUE(all.path);
  EXPECT_FALSE(search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.cutoff = 0.5 * all.cost}).path);
  const GearSearchResult stopped =
      search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.clock = StopClock(0.0)});
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_FALSE(stopped.path);
  // A cusp of high cost is avoided where a path without it exists.
  const GearSearchResult dear =
      search_gears({start, goal, vehicle, *queries.sweep, Outlines(world)}, {.cusp_cost = 10.0});
  ASSERT_TRUE(dear.path);
  EXPECT_LE(cusps_of(*dear.path), cusps_of(*all.path));
}

}  // namespace
}  // namespace arcway::internal
