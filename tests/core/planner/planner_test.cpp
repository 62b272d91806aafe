#include "arcway/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "arcway/angle.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "core/motion/dubins.h"
#include "core/roadmap/feasible_graph.h"
#include "tests/support/boxes.h"
#include "tests/support/free_plans.h"
#include "tests/support/plans.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::expect_valid;

Vehicle one_speed() {
  VehicleParameters parameters;
  parameters.turn_speed = ConstantTurnSpeed{parameters.max_speed};
  return Vehicle(parameters);
}

TEST(Planner, AnEmptyWorldGivesTheShortestDubinsWord) {
  const Vehicle vehicle = one_speed();
  const Planner planner(World({}), vehicle);
  test::RandomInputs random(5);
  for (int i = 0; i < 200; ++i) {
    const double side = i % 2 == 0 ? 4.0 : 40.0;
    const auto pose = [&] {
      return Pose{random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(-kPi, kPi)};
    };
    const PlanRequest request{pose(), pose()};
    double shortest = std::numeric_limits<double>::infinity();
    for (const DubinsWord word : kDubinsWords)
      if (const auto path = dubins_path(word, request.start, request.goal, vehicle.min_turning_radius()))
        shortest = std::min(shortest, length_of(*path));
    const PlanResult result = planner.plan(request);
    ASSERT_TRUE(result.solved());
    EXPECT_NEAR(result.length, shortest, 1e-9);
    expect_valid(planner, result);
  }
}

TEST(Planner, StartAtTheGoalTakesNoTime) {
  const Planner planner(World({}), Vehicle{});
  const PlanResult result = planner.plan({{1, 2, 0.5}, {1, 2, 0.5}});
  EXPECT_TRUE(result.solved());
  EXPECT_TRUE(result.segments.empty());
  EXPECT_EQ(result.travel_time, 0.0);
  // Headings that differ by a whole turn, up to rounding, need no motion.
  const PlanResult turned = planner.plan({{1, 2, 473856.92551958817}, {1, 2, 473856.92551958817 + kTwoPi}});
  EXPECT_EQ(turned.travel_time, 0.0);
  EXPECT_EQ(turned.lower_bound, 0.0);
}

TEST(Planner, AGoalNextToNothingBehindTheStartTakesAWholeTurn) {
  for (const double radius : {1.0, 10.0, 1000.0}) {
    SCOPED_TRACE(radius);
    VehicleParameters parameters;
    parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
    const Planner planner(World({}), Vehicle(parameters));
    const double back = 1e-9 * radius;
    const PlanResult plan = planner.plan({.start = {1, 2, 0}, .goal = {1 - back, 2, 0}});
    ASSERT_TRUE(plan.solved());
    EXPECT_GT(plan.length, kTwoPi * radius * (1.0 - 1e-6));
    expect_valid(planner, plan);
  }
}

// Three turns to one side, the middle one around no obstacle: a Dubins word begins where a maneuver ends. Paths around
// the obstacle's vertices take 2.09 s.
TEST(Planner, AManeuverLeadsToTheGoalByAWord) {
  const World world({{{{18.783, 7.395}, {17.357, 7.183}, {17.444, 5.632}, {18.989, 4.853}}, {}}});
  const Planner planner(world,
                        Vehicle({.length = 1.887, .width = 0.62, .wheelbase = 1.334, .steering = Steering::kRear}));
  const PlanResult plan = planner.plan({.start = {16.2, 7.72, 0.0}, .goal = {13.73, 8.26, -1.25}});
  EXPECT_LT(plan.travel_time, 1.2);
  expect_valid(planner, plan);
}

class PlannerInClutter : public testing::TestWithParam<std::tuple<ClutterKind, double>> {};

TEST_P(PlannerInClutter, EveryPlanIsValidAndMostAreFound) {
  const auto [kind, fill] = GetParam();
  const Clutter clutter = generate_clutter({.kind = kind, .obstacles = 40, .vertices = 8, .fill = fill, .seed = 7});
  const Planner planner(World(clutter.obstacles, clutter.bounds), Vehicle{});
  test::RandomInputs random(17);
  int asked = 0, solved = 0;
  for (int i = 0; i < 400 && asked < 15; ++i) {
    const Pose start = test::pose_in(planner.world(), random), goal = test::pose_in(planner.world(), random);
    const PlanResult result = planner.plan({start, goal});
    if (result.status == PlanStatus::kStartInCollision || result.status == PlanStatus::kGoalInCollision) continue;
    ++asked;
    if (!result.solved()) {
      EXPECT_FALSE(result.reason.empty());
      continue;
    }
    ++solved;
    expect_valid(planner, result);
  }
  EXPECT_EQ(asked, 15);
  EXPECT_GE(solved, 8);
}

INSTANTIATE_TEST_SUITE_P(Clutters, PlannerInClutter,
                         testing::Combine(testing::Values(ClutterKind::kConvex, ClutterKind::kStar),
                                          testing::Values(0.15, 0.3, 0.45)));

// Some of the queries need circles in narrow places, some maneuvers.
TEST(Planner, WarmedUpPlansTheSame) {
  const World world = random_world({.obstacles = 100, .vertices = 6, .fill = 0.3, .seed = 3});
  for (const bool several_radii : {false, true}) {
    VehicleParameters parameters;
    if (several_radii) parameters.turn_speed = LateralAccelerationLimit{4.0};
    const Vehicle vehicle(parameters);
    const PlannerOptions options{.refinement = {.max_trials = 50}};
    const Planner cold(world, vehicle, options), warm(world, vehicle, options);
    warm.warm_up(0);
    warm.warm_up(2);
    for (const PlanRequest& request : random_queries(world, warm.queries(), vehicle, {.count = 8, .seed = 5})) {
      test::expect_same_plan(warm.plan(request), cold.plan(request));
      warm.warm_up();
    }
  }
}

// The vehicle speeds up or brakes all the way. Of two arrivals on a circle, the earlier one is then the slower one.
TEST(Planner, PillarsOfManyVerticesTakeFewExpansionsWhereTheVehicleIsNeverAtItsTopSpeed) {
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  parameters.turn_speed = ConstantTurnSpeed{parameters.max_speed};
  test::RandomInputs random(1);
  std::vector<Polygon> pillars;
  for (int i = 0; i < 4; ++i) {
    const Vec2 middle = random.point(0.0, 16.0);
    Polygon& pillar = pillars.emplace_back();
    for (int k = 0; k < 16; ++k) pillar.outer.push_back(middle + 0.5 * direction_of(k * kTwoPi / 16));
  }
  const Planner planner{World(pillars), Vehicle(parameters)};
  const PlanResult plan = planner.plan({{-3, 8, random.uniform(-3.0, 3.0)}, {19, 8, random.uniform(-3.0, 3.0)}});
  EXPECT_LT(plan.statistics.nodes_expanded, 500u);
  expect_valid(planner, plan);
}

Vehicle turning_within(double radius, const TurnSpeedLaw& law, double wheelbase = VehicleParameters().wheelbase) {
  VehicleParameters parameters;
  parameters.wheelbase = wheelbase;
  parameters.max_steering_angle = std::atan(parameters.wheelbase / radius);
  parameters.turn_speed = law;
  return Vehicle(parameters);
}

// The body covers the center of a turn of less than half its width, so that such turns lead around no vertex. This
// holds also if the reference point lies behind the body.
TEST(Planner, FindsAWayForVehiclesThatTurnNearlyOnTheSpot) {
  const World world = random_world({.obstacles = 20, .vertices = 6, .fill = 0.15, .seed = 5});
  const QuerySet queries = make_reference_queries(world);
  for (const double wheelbase : {1.3, 2.0})
    for (const TurnSpeedLaw& law :
         {TurnSpeedLaw{ConstantTurnSpeed{8.0}}, TurnSpeedLaw{LateralAccelerationLimit{20.0}}}) {
      const Planner wider(world, turning_within(0.6, law, wheelbase));
      for (const double radius : {0.3, 0.001}) {
        const Planner planner(world, turning_within(radius, law, wheelbase));
        for (const PlanRequest& request : random_queries(world, queries, planner.vehicle(), {.count = 2})) {
          const PlanResult result = planner.plan(request);
          ASSERT_TRUE(result.solved()) << radius << ' ' << result.reason;
          expect_valid(planner, result);
          // It can drive every path of the vehicle with wider turns.
          const PlanResult bound = wider.plan(request);
          ASSERT_TRUE(bound.solved()) << bound.reason;
          EXPECT_LE(result.travel_time, 1.01 * bound.travel_time) << radius;
        }
      }
    }
}

// Circles around both corners at the end of a thin wall do not depend on which corner comes first.
TEST(Planner, TurnsRoundTheEndOfAWallWhereverItsRingBegins) {
  const Vehicle vehicle(
      {.length = 0.6, .width = 1.2, .wheelbase = 0.5, .max_steering_angle = 0.9, .max_acceleration = 2.0});
  Ring wall{{0, 0}, {10, 0}, {10, 0.2}, {0, 0.2}};
  for (int i = 0; i < 8; ++i) {
    std::rotate(wall.begin(), wall.begin() + 1, wall.end());
    if (i == 4) std::ranges::reverse(wall);
    const Planner planner(World({{wall, {}}}, Ring{{-2, -2}, {13, -2}, {13, 2.2}, {-2, 2.2}}), vehicle,
                          {.refinement = {.max_trials = 0}});
    const PlanResult plan = planner.plan({{8, -0.7, 0}, {8, 0.9, kPi}});
    ASSERT_TRUE(plan.solved());
    expect_valid(planner, plan);
    EXPECT_NEAR(plan.travel_time, 3.541606, 1e-5) << i;
    EXPECT_EQ(planner.feasible_graph().counts().kept, 16u) << i;
  }
}

// A door too narrow to turn in, whose walls have vertices on their edges.
TEST(Planner, DrivesThroughADoorWhoseWallsAreDivided) {
  const auto divided = [](const Ring& ring) {
    Ring twice;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      twice.push_back(ring[i]);
      twice.push_back(0.5 * (ring[i] + ring[(i + 1) % ring.size()]));
    }
    return twice;
  };
  const Ring low{{4, 0}, {4.25, 0}, {4.25, 3.75}, {4, 3.75}}, high{{4, 4.75}, {4.25, 4.75}, {4.25, 8}, {4, 8}};
  const Ring bounds{{0, 0}, {8.25, 0}, {8.25, 8}, {0, 8}};
  const PlanRequest request{{1.503328, 6.581904, -1.387555}, {6.476310, 2.784536, -2.777039}};
  double time = 0.0;
  for (const bool is_divided : {false, true}) {
    const World world = is_divided ? World({{divided(low), {}}, {divided(high), {}}}, divided(bounds))
                                   : World({{low, {}}, {high, {}}}, bounds);
    const Planner planner(world, Vehicle{}, {.maneuver_poses = 0});
    const PlanResult plan = planner.plan(request);
    ASSERT_TRUE(plan.solved()) << plan.reason;
    expect_valid(planner, plan);
    if (is_divided) {
      EXPECT_NEAR(plan.travel_time, time, 1e-9);
    }
    time = plan.travel_time;
  }
}

TEST(Planner, HeuristicsAgreeWhereTheyMust) {
  const Clutter clutter =
      generate_clutter({.kind = ClutterKind::kConvex, .obstacles = 30, .vertices = 6, .fill = 0.2, .seed = 2});
  const World world(clutter.obstacles, clutter.bounds);
  // The graph's fastest, with nothing done to them.
  PlannerOptions plain{.maneuver_poses = 0, .gap_circles = false, .refinement = {.max_trials = 0}};
  const Planner best(world, Vehicle{}, plain);
  plain.heuristic = Heuristic::kDijkstra;
  const Planner dijkstra(world, Vehicle{}, plain);
  const Planner paper(world, Vehicle{}, {.heuristic = Heuristic::kPaperDistance, .radii = {}});
  const Vec2 low = world.box().min;
  const Vec2 span = world.box().max - low;
  test::RandomInputs random(3);
  int solved = 0;
  for (int i = 0; i < 60; ++i) {
    const auto pose = [&] {
      return Pose{low.x() + random.uniform(0.1, 0.9) * span.x(), low.y() + random.uniform(0.1, 0.9) * span.y(),
                  random.uniform(-kPi, kPi)};
    };
    const PlanRequest request{pose(), pose()};
    const PlanResult a = best.plan(request), b = dijkstra.plan(request), c = paper.plan(request);
    EXPECT_EQ(a.status, b.status);
    if (c.solved()) expect_valid(paper, c);
    if (!a.solved() || !b.solved()) continue;
    ++solved;
    EXPECT_NEAR(a.travel_time, b.travel_time, 1e-9 * a.travel_time);
    EXPECT_LE(a.statistics.nodes_expanded, b.statistics.nodes_expanded);
  }
  EXPECT_GT(solved, 10);
}

World walled() { return World({{{{4, 0}, {6, 0}, {6, 10}, {4, 10}}, {}}}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}); }

TEST(Planner, EndsASearchThatMayNotTakeAnyTime) {
  const Planner planner(walled(), Vehicle{});
  const PlanResult result = planner.plan({{2, 2, 1.57}, {2, 8, 1.57}}, {.time = 0.0});
  EXPECT_EQ(result.status, PlanStatus::kTimeLimit);
  EXPECT_TRUE(result.interrupted);
  EXPECT_TRUE(result.segments.empty());
  EXPECT_EQ(result.reason, "no path was found within the time limit of 0 s");
  const PlanResult unlimited = planner.plan({{2, 2, 1.57}, {2, 8, 1.57}}, {.time = 1e300});
  EXPECT_TRUE(unlimited.solved());
  EXPECT_FALSE(unlimited.interrupted);
  EXPECT_THROW((void)planner.plan({{2, 2, 1.57}, {2, 8, 1.57}}, {.time = NAN}), std::invalid_argument);
}

TEST(Planner, EndsASearchThatIsStopped) {
  const Planner planner(walled(), Vehicle{});
  std::stop_source stop;
  const PlanRequest request{{2, 2, 1.57}, {2, 8, 1.57}};
  EXPECT_TRUE(planner.plan(request, {.stop = stop.get_token()}).solved());
  stop.request_stop();
  const PlanResult result = planner.plan(request, {.stop = stop.get_token()});
  EXPECT_EQ(result.status, PlanStatus::kCanceled);
  EXPECT_TRUE(result.interrupted);
}

// Asks for a stop at the given question about a straight motion.
class StoppingSweep final : public SweepQuery {
 public:
  StoppingSweep(const World& world, std::size_t last) : exact_(make_reference_queries(world).sweep), last_(last) {}
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  void do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const override {
    asked_ += rectangles.size();
    if (asked_ >= last_) stop_.request_stop();
    exact_->straight_free(rectangles, free);
  }
  void do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const override {
    asked_ += bodies.size();
    if (asked_ >= last_) stop_.request_stop();
    exact_->straight_free(bodies, free);
  }
  void do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const override {
    exact_->free_headings(bodies, result);
  }

  std::shared_ptr<const SweepQuery> exact_;
  std::size_t last_;
  mutable std::stop_source stop_;
  mutable std::size_t asked_ = 0;
};

TEST(Planner, SaysThatRefinementWasStopped) {
  const World world({{{{6, 0}, {8, 0}, {8, 8}, {6, 8}}, {}}}, Ring{{0, 0}, {16, 0}, {16, 16}, {0, 16}});
  const PlanRequest request{{3, 3, 1.57}, {11, 3, -1.57}};
  const auto plan = [&](const StoppingSweep& sweep, std::uint32_t max_trials) {
    QuerySet queries = make_reference_queries(world);
    queries.sweep = std::shared_ptr<const SweepQuery>(std::shared_ptr<void>(), &sweep);
    const Planner planner(world, Vehicle{}, backend_of(world, queries), {.refinement = {.max_trials = max_trials}});
    return planner.plan(request, {.stop = sweep.token()});
  };
  constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
  const StoppingSweep counting(world, kNever);
  const PlanResult first = plan(counting, 0);
  ASSERT_TRUE(first.solved());
  const StoppingSweep never(world, kNever);
  const PlanResult best = plan(never, RefineOptions{}.max_trials);
  ASSERT_TRUE(best.solved());
  ASSERT_GT(never.asked(), counting.asked() + 1);
  EXPECT_FALSE(best.interrupted);

  const StoppingSweep stopping(world, counting.asked() + 1);  // the first question of the refinement
  const PlanResult cut_off = plan(stopping, RefineOptions{}.max_trials);
  ASSERT_TRUE(cut_off.solved());
  EXPECT_TRUE(cut_off.interrupted);
  EXPECT_LE(cut_off.travel_time, first.travel_time);
  EXPECT_LT(cut_off.statistics.refine_trials, best.statistics.refine_trials);
}

TEST(Planner, PlansTheSameFromManyThreadsAtOnce) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 20, .vertices = 6, .fill = 0.2, .seed = 3});
  const Planner eager(world, Vehicle{});
  const Planner lazy(world, Vehicle{}, {.graph_mode = GraphMode::kLazy});
  std::vector<PlanRequest> requests;
  test::RandomInputs random(6);
  const double side = world.box().max.x();
  for (int i = 0; i < 12; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
    };
    requests.push_back({.start = pose(), .goal = pose()});
  }
  std::vector<std::vector<PlanResult>> results(4);
  std::vector<std::thread> threads;
  for (auto& mine : results)
    threads.emplace_back([&] {
      for (const PlanRequest& request : requests) mine.push_back(lazy.plan(request));
    });
  for (std::thread& thread : threads) thread.join();
  int solved = 0;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const PlanResult expected = eager.plan(requests[i]);
    solved += expected.solved() ? 1 : 0;
    for (const auto& mine : results) {
      EXPECT_EQ(mine[i].status, expected.status);
      EXPECT_EQ(mine[i].travel_time, expected.travel_time);
      EXPECT_EQ(mine[i].length, expected.length);
      EXPECT_EQ(mine[i].segments.size(), expected.segments.size());
    }
  }
  EXPECT_GT(solved, 3);
}

TEST(Planner, SwingsWideWhereThatIsFasterAndIsNeverSlowerForIt) {
  VehicleParameters parameters;
  parameters.max_acceleration = 2.0;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  const Vehicle vehicle(parameters);
  const World world =
      random_world({.kind = ClutterKind::kConvex, .obstacles = 40, .vertices = 8, .fill = 0.15, .seed = 4});
  const Planner narrow(
      world, vehicle,
      {.graph_mode = GraphMode::kLazy, .radii = {vehicle.min_turning_radius()}, .refinement = {.max_trials = 0}});
  const Planner wide(world, vehicle, {.graph_mode = GraphMode::kLazy, .refinement = {.max_trials = 0}});
  test::RandomInputs random(12);
  const double side = world.box().max.x();
  std::vector<double> ratios;
  for (int i = 0; i < 30; ++i) {
    const auto pose = [&] {
      return Pose{random.uniform(1.0, side - 1.0), random.uniform(1.0, side - 1.0), random.uniform(-kPi, kPi)};
    };
    const PlanRequest request{pose(), pose()};
    const PlanResult before = narrow.plan(request);
    if (!before.solved()) continue;
    const PlanResult after = wide.plan(request);
    ASSERT_TRUE(after.solved());
    expect_valid(wide, after);
    ratios.push_back(after.travel_time / before.travel_time);
    EXPECT_LE(ratios.back(), 1.0 + 1e-9);
  }
  ASSERT_GT(ratios.size(), 10u);
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
  EXPECT_LT(ratios[ratios.size() / 2], 0.9);
}

TEST(Planner, SaysWhyThereIsNoPath) {
  const Planner planner(walled(), Vehicle{});
  EXPECT_EQ(planner.plan({{5, 5, 0}, {8, 5, 0}}).status, PlanStatus::kStartInCollision);
  EXPECT_EQ(planner.plan({{2, 5, 1.57}, {5, 5, 0}}).status, PlanStatus::kGoalInCollision);
  EXPECT_EQ(planner.plan({{2, 5, 1.57}, {50, 5, 0}}).status, PlanStatus::kGoalOutsideBounds);
  EXPECT_EQ(planner.plan({{-3, 5, 1.57}, {8, 5, 0}}).status, PlanStatus::kStartOutsideBounds);
  const PlanResult result = planner.plan({{2, 2, 1.57}, {8, 2, 1.57}});
  EXPECT_FALSE(result.solved());
  EXPECT_FALSE(result.reason.empty());
}

TEST(Planner, RefusesQueriesAndGraphsThatAreNotTheWorlds) {
  const World world = walled();
  const QuerySet queries = make_reference_queries(world);
  const VisibilityGraph graph = build_reduced_visibility_graph(world, *queries.visibility);
  const auto make = [&](const QuerySet& q, const VisibilityGraph& g) {
    return Planner(world, Vehicle{}, backend_of(world, q, g));
  };
  EXPECT_NO_THROW(make(queries, graph));
  EXPECT_THROW(make({}, graph), std::invalid_argument);
  EXPECT_THROW(make(queries, {}), std::invalid_argument);
  // As many vertices, but one of them is reflex.
  const World square({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}}), dart({{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, {}}});
  const VisibilityGraph around =
      build_reduced_visibility_graph(square, *make_reference_queries(square).visibility, SerialExecutor());
  EXPECT_THROW(Planner(dart, Vehicle{}, backend_of(dart, make_reference_queries(dart), around)), std::invalid_argument);
  EXPECT_THROW(Planner(world, Vehicle{}, backend_of(world, queries, std::shared_ptr<const VisibilityRows>())),
               std::invalid_argument);
  EXPECT_THROW(Planner(dart, Vehicle{}, reference_backend(square)), std::invalid_argument);
}

TEST(Planner, DoesNotKeepItsProcessGroup) {
  const World world = walled();
  const QuerySet queries = make_reference_queries(world);
  std::optional<Planner> planner;
  {
    const SingleProcess process_group;
    planner.emplace(world, Vehicle{}, backend_of(world, queries), PlannerOptions{.process_group = &process_group});
  }
  EXPECT_EQ(planner->options().process_group, nullptr);
}

TEST(Planner, RefusesPosesAndOptionsThatCannotBe) {
  const Planner planner(walled(), Vehicle{});
  EXPECT_THROW((void)planner.plan({{NAN, 5, 0}, {8, 5, 0}}), std::invalid_argument);
  for (const double radius : {0.5, 1e9, 1e200, static_cast<double>(INFINITY), static_cast<double>(NAN)})
    EXPECT_THROW(Planner(walled(), Vehicle{}, {.radii = {2.0, radius}}), std::invalid_argument) << radius;
  EXPECT_THROW(Planner(walled(), Vehicle{}, {.maneuver_poses = 4'000'000'000}), std::invalid_argument);
  const World far({{{{1e9, 1e9}, {1e9 + 4, 1e9}, {1e9, 1e9 + 4}}, {}}});
  EXPECT_THROW(Planner(far, Vehicle{}), std::invalid_argument);
  EXPECT_THROW((void)planner.plan({{2, 5, 1e10}, {8, 5, 0}}), std::invalid_argument);
  EXPECT_THROW((void)planner.plan({{2, 5, 0}, {8, 5, 1e-120}}), std::invalid_argument);
  EXPECT_EQ(planner.plan({{2, 2, 1e-50}, {2, 2, -1e-50}}).status, planner.plan({{2, 2, 0}, {2, 2, 0}}).status);
}

// A double has seven digits behind the point at 1e9 rad, and fifteen for a heading within a turn.
TEST(Planner, GetsToTheGoalWhateverTurnsHeadingsHave) {
  for (const World& world : {World({}), World({{{{400, 140}, {420, 140}, {420, 160}, {400, 160}}, {}}})}) {
    const Planner planner(world, Vehicle{});
    for (const PlanRequest& request :
         {PlanRequest{{0, 0, 1e9}, {800, 300, 1}}, PlanRequest{{0, 0, 0}, {800, 300, -1e8}}}) {
      const PlanResult result = planner.plan(request);
      ASSERT_TRUE(result.solved()) << result.reason;
      EXPECT_EQ(result.start.heading, request.start.heading);
      EXPECT_EQ(result.goal.heading, request.goal.heading);
      expect_valid(planner, result);
    }
  }
}

TEST(Planner, RefusesPosesThatDoublesAreTooCoarseFor) {
  const Planner planner(walled(), Vehicle({.safety_margin = 1e-7}));
  EXPECT_TRUE(planner.plan({{2, 2, 1.57}, {2, 8, 1.57}}).solved());
  try {
    (void)planner.plan({{2, 2, 1.57}, {1e5, 0, 0}});
    ADD_FAILURE() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(
        std::string(error.what()).find("safety margin 1e-07 m is too small for the coordinate of the goal pose 1e+05"),
        std::string::npos)
        << error.what();
  }
}

TEST(Planner, PlansWithTheSlowestAndTheFastestTurns) {
  for (const double limit : {kSmallestVehicleNumber, kLargestVehicleNumber}) {
    for (const TurnSpeedLaw& law :
         {TurnSpeedLaw(ConstantTurnSpeed{limit}), TurnSpeedLaw(LateralAccelerationLimit{limit}),
          TurnSpeedLaw(TurnSpeedTable{{{1.0, limit}}})}) {
      const Planner planner(walled(), Vehicle({.turn_speed = law}));
      EXPECT_TRUE(planner.plan({{2, 2, 1.57}, {2, 8, 1.57}}).solved());
    }
  }
}

TEST(Planner, RefusesVehiclesThatDoublesAreTooCoarseFor) {
  const auto error_of = [](const VehicleParameters& parameters) -> std::string {
    try {
      const Planner planner(World({}), Vehicle(parameters));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of({.width = 1e20}).find("safety margin 0.001 m is too small for a body of 1e+20: "),
            std::string::npos);
  EXPECT_NE(error_of({.max_steering_angle = 1e-16}).find("for a smallest turning radius of 1.3e+16: "),
            std::string::npos);
  EXPECT_EQ(error_of({.max_steering_angle = 1e-6}), "");
}

TEST(Planner, SegmentTimesFindNothingFasterThanTrueTimes) {
  const World world = random_world({.obstacles = 40, .vertices = 6, .fill = 0.3, .seed = 4});
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{2.0}, .max_acceleration = 2.0});
  PlannerOptions options{.maneuver_poses = 0};
  options.refinement.max_trials = 0;
  const Planner exact(world, vehicle, options);
  options.time_model = TimeModel::kSegments;
  const Planner by_segments(world, vehicle, options);
  int slower = 0;
  for (const PlanRequest& request :
       random_queries(world, make_reference_queries(world), vehicle, {.count = 15, .min_distance = 0.4})) {
    const PlanResult best = exact.plan(request), other = by_segments.plan(request);
    ASSERT_EQ(best.solved(), other.solved());
    if (!best.solved()) continue;
    expect_valid(by_segments, other);
    EXPECT_GE(other.travel_time, best.travel_time * (1.0 - 1e-9));
    slower += other.travel_time > best.travel_time * (1.0 + 1e-6) ? 1 : 0;
  }
  EXPECT_GT(slower, 0);
}

TEST(Planner, TellsWhetherAPoseIsFree) {
  const Planner planner(World({test::box(8.0, -4.0, 12.0, 4.0)}, test::box_ring(-10.0, -20.0, 40.0, 20.0)), Vehicle{});
  EXPECT_TRUE(planner.is_free({0, 0, 0}));
  EXPECT_FALSE(planner.is_free({10, 0, 0}));
  EXPECT_FALSE(planner.is_free({50, 0, 0}));
  // The body's front is 1.4 m ahead, and half of the safety margin is 0.5 mm.
  EXPECT_FALSE(planner.is_free(Pose{6.5996, 0, 0}));
  EXPECT_TRUE(planner.is_free(Pose{6.5994, 0, 0}));
  EXPECT_THROW(static_cast<void>(planner.is_free(Pose{std::nan(""), 0, 0})), std::invalid_argument);
}

TEST(Planner, TellsWhetherAPathIsFree) {
  const Planner planner(World({test::box(8.0, -4.0, 12.0, 4.0)}), Vehicle{});
  EXPECT_TRUE(planner.is_free(planner.plan({.start = {0, 0, 0}, .goal = {20, 0, 0}}).path()));
  EXPECT_FALSE(planner.is_free(Path{{{0, 0, 0}, 20.0, 0.0}}));
  EXPECT_TRUE(planner.is_free(Path{{{0, 0, 0}, 6.5, 0.0}}));
  EXPECT_TRUE(planner.is_free(Path{{{0, 0, 0}, 9.0, 0.0, Gear::kReverse}}));
  // Around the obstacle: of the tight arc only the ends are free.
  const PathSegment arc{{10, -8, 0}, 8.0 * kPi, 1.0 / 8.0};
  EXPECT_TRUE(planner.is_free(arc.start) && planner.is_free(arc.end()));
  EXPECT_TRUE(planner.is_free(Path{arc}));
  const PathSegment tight{{10, -4.5, 0}, 4.5 * kPi, 1.0 / 4.5};
  EXPECT_TRUE(planner.is_free(tight.start) && planner.is_free(tight.end()));
  EXPECT_FALSE(planner.is_free(Path{tight}));
  EXPECT_FALSE(planner.is_free(Path{tight.reversed()}));
  EXPECT_TRUE(planner.is_free(Path{}));
  EXPECT_THROW(static_cast<void>(planner.is_free(Path{{{0, 0, 0}, -1.0, 0.0}})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(planner.is_free(Path{{{0, 0, 0}, 1.0, std::nan("")}})), std::invalid_argument);
}

TEST(Planner, FindsTheNearestFreePose) {
  const Planner planner(World({test::box(8.0, -4.0, 12.0, 4.0)}), Vehicle{});
  const Pose free{0, 0, 0};
  EXPECT_EQ(planner.nearest_free(free)->x, 0.0);
  const std::optional<Pose> moved = planner.nearest_free({7.0, 0, 0});
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(planner.is_free(*moved));
  EXPECT_NEAR(moved->x, 6.5995, 1e-3);
  const Planner filled(World({test::box(-20.0, -20.0, 20.0, 20.0)}), Vehicle{});
  EXPECT_EQ(filled.nearest_free({0, 0, 0}), std::nullopt);
}

TEST(Plan, IsThatOfAPlanner) {
  const World world({test::box(8.0, -4.0, 12.0, 4.0)});
  const PlanResult result = plan(world, Vehicle{}, {0, 0, 0}, {20, 0, 0});
  const PlanResult expected = Planner(world, Vehicle{}).plan({.start = {0, 0, 0}, .goal = {20, 0, 0}});
  EXPECT_TRUE(result.solved());
  EXPECT_EQ(result.travel_time, expected.travel_time);
  EXPECT_EQ(Planner(world, Vehicle{}).plan({0, 0, 0}, {20, 0, 0}).travel_time, expected.travel_time);
  EXPECT_EQ(plan(world, Vehicle{}, {.start = {0, 0, 0}, .goal = {20, 0, 0}}).travel_time, expected.travel_time);
  EXPECT_EQ(plan(reference_backend(world), Vehicle{}, {.start = {0, 0, 0}, .goal = {20, 0, 0}}).travel_time,
            expected.travel_time);
  const PlanResult late = plan(world, Vehicle{}, {0, 0, 0}, {20, 0, 0}, {.time = 0.0});
  EXPECT_EQ(late.reason, "no path was found within the time limit of 0 s");
  EXPECT_THROW(plan(world, Vehicle{}, {std::nan(""), 0, 0}, {20, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal
