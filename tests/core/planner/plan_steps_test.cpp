#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/driven_world.h"
#include "core/planner/strategy.h"
#include "core/refine/moves.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// A driven world, whose drive proves that a way exists, and the row of the strategy that finds one.
struct Narrow {
  std::string world, row;
  bool reverse;
  friend void PrintTo(const Narrow& narrow, std::ostream* out) { *out << narrow.world; }
};

PlanResult plan(const Narrow& narrow, std::vector<std::string> leave_out) {
  const DrivenWorld driven = *catalog_driven_world(narrow.world);
  const Planner planner(to_world(driven.map, "driven"), Vehicle(driven.robot), {.leave_out = std::move(leave_out)});
  PlanResult result = planner.plan({.start = *driven.map.start, .goal = *driven.map.goal, .reverse = narrow.reverse});
  if (result.solved()) test::expect_valid(planner, result, narrow.reverse);
  return result;
}

// A row that finds some ways of other rows as well.
constexpr const char* kSlimPlanRow = "plan of a slim body";
// Further ones.
std::vector<std::string> rows_for_other_ways() {
  return {"other ways by trees", kSlimPlanRow, "parts planned again quickly"};
}

double time_of_drive(const Narrow& narrow) { return plan_of_drive(*catalog_driven_world(narrow.world)).travel_time; }

// Trees in both gears that find some ways of other rows as well.
constexpr const char* kSlimGearTrees = "narrow trees of slim bodies in both gears";
// Moves that make some paths as fast as other rows and moves do.
constexpr const char* kGearOptimizer = "optimize turns in both gears";
std::vector<std::string> optimizers() { return {"optimize turns", "optimize turns at length"}; }

// A plan takes less than a share of the drive's time, and without its row more than the drive.
// @param leave_out  of both plans.
void expect_faster_than_the_drive_by_its_row(const Narrow& way, double share, std::vector<std::string> leave_out) {
  SCOPED_TRACE(way.world);
  const PlanResult with = plan(way, leave_out);
  leave_out.push_back(way.row);
  const PlanResult without = plan(way, std::move(leave_out));
  ASSERT_TRUE(with.solved() && without.solved());
  EXPECT_LT(with.travel_time, share * time_of_drive(way));
  EXPECT_GT(without.travel_time, time_of_drive(way));
}

// A plan takes less than a share of the time that it takes without its row.
// @param leave_out  of both plans.
void expect_faster_by_its_row(const Narrow& way, double share, std::vector<std::string> leave_out = {}) {
  SCOPED_TRACE(way.world);
  const PlanResult with = plan(way, leave_out);
  leave_out.push_back(way.row);
  const PlanResult without = plan(way, std::move(leave_out));
  ASSERT_TRUE(with.solved() && without.solved());
  EXPECT_LT(with.travel_time, share * without.travel_time);
}

// Words do not join the runs beside one that is left out here: least squares do.
TEST(GearChanges, AreLeftOutByPushingWhatRemains) {
  const Narrow way{"driven/carved/r9/g2/c50/s2006", "leave out changes of gear", true};
  const PlanResult pushed = plan(way, {kSlimGearTrees, kGearOptimizer});
  const PlanResult words = plan(way, {kSlimGearTrees, kGearOptimizer, way.row});
  ASSERT_TRUE(pushed.solved() && words.solved());
  EXPECT_LT(cusps_of(pushed.path()), cusps_of(words.path()));
  EXPECT_LT(pushed.travel_time, 0.95 * words.travel_time);
}

// The places of changes of gear move with all turns. The first robot has one turn speed.
TEST(GearChanges, AreOptimizedWithAllTurns) {
  for (const char* world : {"driven/hugging/r3/g2/c50/s17101", "driven/rooms/r7/g2/c50/s17195"})
    expect_faster_by_its_row({world, kGearOptimizer, true}, 0.95);
}

// Slides of single circles end at turns that are wide before they are tight, where tight before wide is faster.
TEST(PlanSteps, OptimizeTurnsOfOneSpeed) {
  for (const char* world : {"driven/hugging/r6/g1/c50/s23077", "driven/hugging/r6/g1/c50/s23185"})
    expect_faster_than_the_drive_by_its_row({world, "optimize turns", false}, 1.0, {"optimize turns at length"});
}

// A gap between two obstacles is passed by a circle that touches both. The graph's path leads around one of them.
TEST(PlanSteps, LookForFasterPathsThroughGaps) {
  const std::string name = "clutter/convex/n100/m10/f45";
  const World world = catalog_world(name);
  const Planner with(world, Vehicle()), without(world, Vehicle(), {.leave_out = {"circles in gaps, for speed"}});
  const std::vector<PlanRequest> requests = catalog_queries(name, 24, 1);
  for (const std::size_t number : {8, 23}) {
    const PlanResult plan = with.plan(requests[number]), other = without.plan(requests[number]);
    ASSERT_TRUE(plan.solved() && other.solved());
    test::expect_valid(with, plan);
    EXPECT_LT(plan.travel_time, 0.95 * other.travel_time) << number;
  }
}

// The first path of all is refined on its own way. Trees that keep off the paths so far find the way of the drive, in
// the first round or in a later one.
TEST(PlanSteps, LookForOtherWaysByTrees) {
  for (const char* world : {"driven/scattered/r1/g1/c50/s17108", "driven/hugging/r9/g1/c50/s18341"})
    expect_faster_than_the_drive_by_its_row({world, "other ways by trees", false}, 1.0, {});
}

// The way of the drive is hardly wider than the body, and no circle of the roadmap fits there. A slimmer body drives
// it.
TEST(PlanSteps, PlanForASlimmerBody) {
  expect_faster_than_the_drive_by_its_row({"driven/hugging/r6/g1/c50/s32293", kSlimPlanRow, false}, 1.0, {});
  expect_faster_than_the_drive_by_its_row({"driven/hugging/r7/g2/c50/s18105", kSlimPlanRow, true}, 0.95, {});
}

// The way that is found first is another one than that of the drive.
TEST(PlanSteps, LookForAnotherWayThanTheFirst) {
  const Narrow way{"driven/hugging/r6/g1/c50/s12113", "", false};
  const PlanResult found = plan(way, {});
  ASSERT_TRUE(found.solved());
  EXPECT_LT(found.travel_time, 0.9 * time_of_drive(way));
}

// The graph's path passes an obstacle on the other side, and takes twice as long.
TEST(PlanSteps, PlanForASlimmerBodyOnTheOtherSide) {
  expect_faster_by_its_row({"driven/hugging/r4/g1/c50/s2172", kSlimPlanRow, false}, 0.5);
}

// The gap is 0.5 there, where few poses are grown.
TEST(PlanSteps, LookForFasterPathsByFewPosesOfSlimBodies) {
  expect_faster_by_its_row({"driven/hugging/r7/g2/c50/s17357", kSlimGearTrees, true}, 0.95);
}

TEST(PlanSteps, LookForOtherWaysByTreesInBothGears) {
  const Narrow way{"driven/scattered/r1/g2/c50/s16252", "other ways by trees in both gears", true};
  expect_faster_than_the_drive_by_its_row(way, 1.0, {});
}

// Trees and refinement lead along a bend in many short arcs, which are hardly optimized.
TEST(PlanSteps, DriveInFewerArcs) {
  expect_faster_by_its_row({"driven/hugging/r4/g1/c50/s17165", "fewer arcs", false}, 0.995);
}

// Refinement leaves the first path of this world in 36 arcs, 1 % slower than the drive.
TEST(PlanSteps, RefineAtLengthInFewerArcs) {
  const Narrow way{"driven/rooms/r8/g1/c50/s13223", "refinement at length", false};
  expect_faster_than_the_drive_by_its_row(way, 0.95, {"fewer arcs"});
}

// Trees for narrow places take what they find first.
TEST(PlanSteps, PlanPartsOfANarrowWayAgain) {
  const Narrow way{"driven/carved/r1/g2/c50/s5058", "parts planned again", true};
  const PlanResult in_parts = plan(way, {}), whole = plan(way, {way.row});
  ASSERT_TRUE(in_parts.solved() && whole.solved());
  EXPECT_LT(in_parts.travel_time, 0.95 * whole.travel_time);
  EXPECT_GT(in_parts.statistics.maneuver_poses, whole.statistics.maneuver_poses);
}

// Far above the lower bound, on a way with changes of gear.
TEST(PlanSteps, PlanPartsOfAWayThatIsHardToFindAgain) {
  expect_faster_than_the_drive_by_its_row(
      {"driven/carved/r8/g2/c50/s14106", "parts planned again", true}, 1.0,
      {"other ways by trees", "other ways by trees in both gears", kSlimPlanRow, kGearOptimizer});
}

// Circles around vertices lead a way that is found by single arcs on other sides of obstacles than the drive.
TEST(PlanSteps, PlanPartsOfAnEasyWayAgainQuickly) {
  const std::string row = "parts planned again quickly";
  for (const char* world : {"driven/scattered/r1/g1/c50/s16288", "driven/hugging/r4/g1/c50/s17129"})
    expect_faster_than_the_drive_by_its_row({world, row, false}, 1.0, optimizers());
  const Narrow way{"driven/hugging/r4/g1/c50/s17129", row, false};
  EXPECT_EQ(plan(way, {}).statistics.tree_poses, plan(way, {row}).statistics.tree_poses);
}

TEST(PlanSteps, PlanPartsOfAWayInBothGearsAgainQuickly) {
  expect_faster_by_its_row({"driven/scattered/r3/g2/c50/s17020", "parts planned again quickly", true}, 0.97,
                           {kGearOptimizer});
}

// A query of which only the first path is known must not take parts of the query before it.
TEST(PlanSteps, PlanPartsOfNoOtherQuery) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 20, .vertices = 10, .fill = 0.3, .seed = 1});
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{4.0}, .max_acceleration = 2.0});
  const Planner planner(world, vehicle, {.leave_out = {"single arcs"}});
  test::RandomInputs random(5);
  int solved = 0;
  for (int i = 0; i < 40; ++i) {
    const PlanResult plan = planner.plan({test::pose_in(world, random), test::pose_in(world, random)});
    if (!plan.solved()) continue;
    ++solved;
    test::expect_valid(planner, plan, false);
  }
  EXPECT_GT(solved, 5);
}

// The only turn is at the start; what two circles leave of one at the goal costs 2 ms.
TEST(PlanSteps, MergeAllTurnsOfAPathIntoOne) {
  expect_faster_than_the_drive_by_its_row({"driven/carved/r6/g1/c50/s18302", "merge all turns", false}, 1.0, {});
}

// What the trees find first turns in another place than the drive, with three changes of gear.
TEST(PlanSteps, LookAgainForAPlaceToTurn) {
  const Narrow way{"driven/hugging/r6/g2/c50/s12149", "", true};
  const PlanResult result = plan(way, {});
  ASSERT_TRUE(result.solved());
  EXPECT_EQ(cusps_of(result.path()), 1u);
  EXPECT_LT(result.travel_time, time_of_drive(way));
}

// Trees of the usual weight find other ways, by 10 and 13 % slower than the drives.
TEST(PlanSteps, LookForAFasterPathByTreesOfASmallerWeight) {
  for (const char* world : {"driven/hugging/r6/g2/c50/s9041", "driven/rooms/r7/g2/c50/s16159"}) {
    const Narrow way{world, "", true};
    const PlanResult result = plan(way, {});
    ASSERT_TRUE(result.solved()) << world;
    EXPECT_LT(result.travel_time, time_of_drive(way)) << world;
  }
}

// The real body's trees find the way with more changes of gear, slower than the drive.
TEST(PlanSteps, LookForAWayInBothGearsByTreesOfASlimBody) {
  const Narrow way{"driven/hugging/r1/g2/c2/s2061", "narrow trees of slim bodies in both gears", true};
  const PlanResult slim = plan(way, {}), real = plan(way, {way.row});
  ASSERT_TRUE(slim.solved() && real.solved());
  EXPECT_LT(slim.travel_time, 0.9 * real.travel_time);
  EXPECT_LT(cusps_of(slim.path()), cusps_of(real.path()));
}

// The path of slim bodies is a fifth cheaper before refinement than the one of the real body's trees: that one is not
// refined.
TEST(PlanSteps, RefineNoPathBesideAMuchCheaperOneOfSlimBodies) {
  const Narrow way{"driven/hugging/r6/g2/c50/s3065", "", true};
  const PlanResult best = plan(way, {});
  ASSERT_TRUE(best.solved());
  EXPECT_LT(best.statistics.refine_trials, 25'000u);
}

// Trees have found the way, at a gap of 50 %: 12 more poses of each end are tried in each gear at most.
TEST(PlanSteps, TryFewPlacesToTurnBesideAWayOfTrees) {
  const Narrow way{"driven/hugging/r3/g2/c50/s6041", "changes of gear further away", true};
  const PlanResult few = plan(way, {}), none = plan(way, {way.row});
  ASSERT_TRUE(few.solved() && none.solved());
  EXPECT_GT(few.statistics.maneuver_poses, none.statistics.maneuver_poses);
  EXPECT_LE(few.statistics.maneuver_poses, none.statistics.maneuver_poses + 52);
}

// The way in both gears is a quarter slower before refinement than the one that is driven forwards.
TEST(PlanSteps, LeaveAMuchDearerWayInBothGearsAlone) {
  const Narrow way{"driven/carved/r5/g2/c50/s6034", "", true};
  const PlanResult best = plan(way, {"fewer arcs", kSlimGearTrees});
  ASSERT_TRUE(best.solved());
  EXPECT_LT(best.statistics.refine_trials, 20'000u);
}

// Paths of the graph turn around vertices, the drive between them.
TEST(PlanSteps, LookForAFasterPathByTreesOfASlimBody) {
  const Narrow way{"driven/carved/r1/g1/c50/s3222", "trees of a slim body, for a faster path", false};
  std::vector<std::string> leave_out = rows_for_other_ways();
  for (const std::string& move : optimizers()) leave_out.push_back(move);
  expect_faster_than_the_drive_by_its_row(way, 1.0, leave_out);
}

class NarrowWay : public testing::TestWithParam<Narrow> {};

TEST_P(NarrowWay, IsFoundByItsRowAlone) {
  const PlanResult found = plan(GetParam(), {});
  EXPECT_TRUE(found.solved()) << found.reason;
  const PlanResult missed = plan(GetParam(), {GetParam().row});
  EXPECT_FALSE(missed.solved());
  EXPECT_EQ(missed.certainty, Certainty::kGaveUp);
}

INSTANTIATE_TEST_SUITE_P(
    Driven, NarrowWay,
    testing::Values(
        // The shortest route misleads the trees for thousands of poses.
        Narrow{"driven/hugging/r9/g1/c50/s2121", "trees of a slim body", false},
        // No motion of the real body that trees find leads out of the end; one of the slimmer body does.
        Narrow{"driven/hugging/r3/g1/c2/s2189", "trees of a less slim body", false},
        // Fewer poses, or trees of a larger weight of the rest, find none.
        Narrow{"driven/hugging/r8/g2/c50/s16277", "narrow trees of slim bodies in both gears", true},
        Narrow{"driven/hugging/r1/g2/c50/s17009", "narrow trees in both gears", true}),
    [](const testing::TestParamInfo<Narrow>& test) {
      std::string name = test.param.row;
      std::ranges::replace(name, ' ', '_');
      return name;
    });

// There is one way between long walls, which all roadmaps lead along. Its first path is refined, and in the end the
// best one at length: other roadmaps add no trials, though they are searched.
TEST(PlanSteps, RefineAWayOnce) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world(
      {test::box(0.0, -3.0, 1.0, 60.0), test::box(10.0, -60.0, 11.0, 3.0), test::box(20.0, -3.0, 21.0, 60.0)});
  const PlanRequest request{.start = {-40.0, 0.0, 0.0}, .goal = {60.0, 0.0, 0.0}};
  // The only row that may not take that way.
  const std::string other_sides = "other sides of obstacles";
  const PlanResult all = Planner(world, vehicle, {.leave_out = {other_sides}}).plan(request);
  std::vector<std::string> other_radii{other_sides};
  for (const StrategyRow& row : kStrategy)
    if (std::holds_alternative<TryOtherRadii>(row.step)) other_radii.emplace_back(row.name);
  ASSERT_GT(other_radii.size(), 1u);
  const PlanResult few = Planner(world, vehicle, {.leave_out = other_radii}).plan(request);
  ASSERT_TRUE(all.solved());
  ASSERT_LT(all.optimality_gap(), kTooFarForRadii);
  EXPECT_EQ(all.travel_time, few.travel_time);
  EXPECT_EQ(all.statistics.refine_trials, few.statistics.refine_trials);
  EXPECT_GT(all.statistics.nodes_expanded, few.statistics.nodes_expanded);
}

// Rows that find the routes of rows for several radii too.
std::vector<std::string> trees_for_other_routes() {
  return {"trees of a slim body, for a faster path", "other ways by trees"};
}

// A query of a robot of a lateral acceleration [m/s^2], and the row that finds a faster path.
struct FasterByRow {
  World world;
  double lateral;
  PlanRequest request;
  std::string row;
};

// A plan takes less than a share of the time that it takes without its row.
void expect_faster_by_row(const FasterByRow& of, double share, PlannerOptions options) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{of.lateral}, .max_acceleration = 2.0});
  const PlanResult all = Planner(of.world, vehicle, options).plan(of.request);
  options.leave_out.push_back(of.row);
  const PlanResult few = Planner(of.world, vehicle, options).plan(of.request);
  ASSERT_TRUE(all.solved() && few.solved());
  EXPECT_LT(all.travel_time, share * few.travel_time);
}

struct Stars {
  double lateral, fill;  // acceleration [m/s^2], share of the area
  std::uint64_t seed;
};

// A plan among stars takes less than a share of the time that it takes without a row, both without trees.
void expect_faster_among_stars(const Stars& of, const PlanRequest& request, const std::string& row, double share) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = of.fill, .seed = of.seed});
  expect_faster_by_row({world, of.lateral, request, row}, share, {.leave_out = trees_for_other_routes()});
}

// Without trees of a slim body, only the search for a vehicle whose tightest turns are nearly as fast as lines finds
// the route of the plan.
TEST(PlanSteps, LookForTheRouteOfFastTightTurns) {
  const PlanRequest request{.start = {4.7, 13.8, -0.59}, .goal = {47.1, 47.0, 0.97}};
  expect_faster_among_stars({2.0, 0.3, 18}, request, "1 radius, 16 x lateral acceleration", 0.92);
}

struct Cluttered {
  const char* world;
  std::uint64_t seed;  // of its queries
  std::size_t number;  // of the query
  double lateral;      // acceleration [m/s^2]
};

// A plan takes less than a share of the time that it takes without the search for turns that are nearly as fast as
// lines.
void expect_faster_by_fast_turns(const Cluttered& of, double share) {
  SCOPED_TRACE(of.world);
  const PlanRequest request = catalog_queries(of.world, of.number + 1, of.seed)[of.number];
  expect_faster_by_row({catalog_world(of.world), of.lateral, request, "2 radii, 16 x lateral acceleration"}, share,
                       {.graph_mode = GraphMode::kLazy});
}

// The path that is faster once its turns are optimized takes twice as long as the best one before that.
TEST(PlanSteps, OptimizeTheTurnsOfAPathThatIsFarDearerBefore) {
  expect_faster_by_fast_turns({"clutter/star/n300/m10/f30/s1", 202, 6, 4.0}, 0.95);
}

// The gap is 63 % there.
TEST(PlanSteps, LookForFastTightTurnsFarFromTheBound) {
  expect_faster_by_fast_turns({"clutter/convex/n100/m10/f45/s1", 101, 1, 2.0}, 0.99);
}

// Only the search that must not turn around an obstacle as the best path does finds the way of the plan.
TEST(PlanSteps, PassAnObstacleOnItsOtherSide) {
  const PlanRequest request{.start = {46.6, 46.6, -2.56}, .goal = {11.8, 28.7, 0.64}};
  expect_faster_among_stars({2.0, 0.3, 37}, request, "other sides of obstacles", 0.96);
}

// The best path by then joins the roadmap by maneuvers. Only the search for a vehicle with slower turns, by maneuvers
// as well, finds the route of the plan.
TEST(PlanSteps, LookForTheRouteOfSlowTurnsBehindManeuvers) {
  const PlanRequest request{.start = {30.84, 9.75, 1.04}, .goal = {2.69, 41.04, 2.01}};
  expect_faster_among_stars({4.0, 0.45, 7}, request, "slower turns behind maneuvers", 0.99);
}

// Of two paths that cost about the same, the one that costs more becomes the faster one at length. Refined at length,
// the other one takes 11.02 s.
TEST(PlanSteps, RefineTheSecondBestPathAtLength) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 30, .vertices = 8, .fill = 0.3, .seed = 38});
  const PlanRequest request{.start = {60.5, 44.3, 2.62}, .goal = {57.3, 18.2, 2.63}};
  const PlanResult found = Planner(world, vehicle, {.leave_out = trees_for_other_routes()}).plan(request);
  ASSERT_TRUE(found.solved());
  EXPECT_LT(found.travel_time, 10.8);
}

// Refinement has no moves.
PlannerOptions only_with(std::initializer_list<std::string_view> rows) {
  PlannerOptions options;
  for (const StrategyRow& row : kStrategy)
    if (std::ranges::find(rows, row.name) == rows.end()) options.leave_out.emplace_back(row.name);
  for (const MoveRow& row : kMoves) options.leave_out.emplace_back(row.name);
  return options;
}

// The rear swings towards a wall 6 mm beside the body, the more the tighter the turn. By tight arcs, a path leads
// around the whole wall.
TEST(PlanSteps, JoinByWideArcsWhereTightOnesAreBlocked) {
  const Vehicle vehicle({.wheelbase = 0.8, .turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world(
      {test::box(-50.0, -3.0, 80.0, -0.406), test::box(20.0, 2.0, 22.0, 60.0), test::box(-50.0, 5.0, 19.0, 7.0)});
  const PlanRequest request{.start = {8.0, 0.0, 0.0}, .goal = {60.0, 20.0, 0.0}};
  const PlanResult tight = Planner(world, vehicle, only_with({"single arcs"})).plan(request);
  const PlanResult wide = Planner(world, vehicle, only_with({"single arcs", "single arcs of all radii"})).plan(request);
  ASSERT_TRUE(tight.solved() && wide.solved());
  EXPECT_LT(wide.travel_time, 0.5 * tight.travel_time);
}

// Of five radii, two serve the ends, as long as there is a path.
TEST(PlanSteps, LookForNoOtherWayWhereZonesAloneAreSlow) {
  const World open = random_world({.obstacles = 30, .vertices = 6, .fill = 0.05, .seed = 4});
  const Box& box = open.box();
  const Vec2 size = box.max - box.min, center = 0.5 * (box.min + box.max);
  const Vehicle vehicle((VehicleParameters()));
  const Planner without(open, vehicle);
  const PlanRequest request{.start = *without.nearest_free({box.min.x() + 5.0, center.y(), 0.0}),
                            .goal = *without.nearest_free({box.max.x() - 5.0, center.y(), 0.0})};
  const PlanResult fast = without.plan(request);
  // Across the whole map: no way leads around it.
  const Zone band{.area = Polygon::rectangle(center, 0.4 * size.x(), 20.0 * size.y()), .rule = SpeedLimit{2.0}};
  const Planner with(open.with_zones({band}), vehicle, {.leave_out = {"routes through zones"}});
  const PlanResult slow = with.plan(request);
  ASSERT_TRUE(fast.solved() && slow.solved()) << fast.reason << slow.reason;
  test::expect_valid(with, slow);
  ASSERT_LT(fast.optimality_gap(), 0.04);
  ASSERT_GT(slow.optimality_gap(), 0.2);
  // A search counts the poses of its ends; with maneuvers it has 48 more at the least.
  EXPECT_LT(slow.statistics.maneuver_poses, 48u);
}

TEST(PlanSteps, JoinByFewRadiiFirst) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world = random_world({.obstacles = 60, .vertices = 8, .fill = 0.25, .seed = 3});
  const Planner planner(world, vehicle, only_with({"single arcs"}));
  const std::vector<double>& radii = planner.options().radii;
  ASSERT_GT(radii.size(), kEndRadii);
  test::RandomInputs random(1);
  int joined = 0;
  for (int i = 0; i < 60; ++i) {
    const PlanResult plan = planner.plan({test::pose_in(world, random), test::pose_in(world, random)});
    const Path& path = plan.first_path;
    if (path.size() <= 3) continue;  // none, or a Dubins path, which joins no roadmap
    ++joined;
    for (const PathSegment& end : {path.front(), path.back()})
      if (!end.is_line()) {
        EXPECT_LT(1.0 / std::abs(end.curvature), 1.001 * radii[kEndRadii - 1]) << "query " << i;
      }
  }
  EXPECT_GE(joined, 15);
}

// Among the tightest radii alone a path is there soon. It is the answer where nothing else is tried, and changes no
// plan.
TEST(PlanSteps, FindAPathSoon) {
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  const World world = random_world({.obstacles = 30, .vertices = 8, .fill = 0.25, .seed = 3});
  const Planner all(world, vehicle), without(world, vehicle, {.leave_out = {"first path"}});
  const Planner alone(world, vehicle, only_with({"first path"}));
  ASSERT_GT(all.options().radii.size(), 1u);
  const auto are_same = [](const Path& a, const Path& b) {
    return std::ranges::equal(a, b, [](const PathSegment& p, const PathSegment& q) {
      return p.start == q.start && p.length == q.length && p.curvature == q.curvature;
    });
  };
  test::RandomInputs random(1);
  int solved = 0, others = 0;
  for (int i = 0; i < 24; ++i) {
    const PlanRequest request{test::pose_in(world, random), test::pose_in(world, random)};
    const PlanResult soon = alone.plan(request), plan = all.plan(request), later = without.plan(request);
    if (!soon.solved()) continue;
    ++solved;
    test::expect_valid(alone, soon);
    EXPECT_TRUE(are_same(soon.path(), plan.first_path)) << "query " << i;
    for (const PathSegment& segment : soon.path()) {
      EXPECT_LE(std::abs(segment.curvature), 1.001 / all.options().radii[0]);
      if (!segment.is_line()) {
        EXPECT_GE(std::abs(segment.curvature), 0.999 / all.options().radii[0]);
      }
    }
    EXPECT_TRUE(are_same(plan.path(), later.path())) << "query " << i;
    others += !are_same(plan.first_path, later.first_path);
  }
  EXPECT_GE(solved, 5);
  EXPECT_GE(others, 3);
}

}  // namespace
}  // namespace arcway::internal
