#include "core/planner/strategy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/driven_world.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/planner.h"
#include "core/planner/strategy_text.h"
#include "core/refine/moves.h"
#include "tests/support/boxes.h"
#include "tests/support/plans.h"

namespace arcway::internal {
namespace {

TEST(Strategy, LeavesOutAllRowsOfAName) {
  const std::vector<StrategyRow> all = strategy_without({}), some = strategy_without(std::vector<std::string>{"trees"});
  EXPECT_EQ(all.size(), std::size(kStrategy));
  EXPECT_EQ(std::ranges::count(all, "trees", &StrategyRow::name), 2);
  EXPECT_EQ(std::ranges::count(some, "trees", &StrategyRow::name), 0);
  EXPECT_EQ(some.size() + 2, all.size());
}

TEST(Strategy, RefusesAnUnknownNameAndListsAll) {
  const World world({}, {});
  try {
    (void)Planner(world, Vehicle{}, {.leave_out = {"tree"}});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("leave out \"tree\""), std::string::npos) << text;
    for (const StrategyRow& row : kStrategy)
      EXPECT_NE(text.find("\"" + std::string(row.name) + "\""), std::string::npos) << row.name;
    for (const MoveRow& row : kMoves)
      EXPECT_NE(text.find("\"" + std::string(row.name) + "\""), std::string::npos) << row.name;
    for (const GearMoveRow& row : kGearMoves)
      EXPECT_NE(text.find("\"" + std::string(row.name) + "\""), std::string::npos) << row.name;
  }
}

TEST(Strategy, MovesThatAreLeftOutAreNotTried) {
  const World world({}, {});
  for (const MoveRow& row : kMoves) {
    const Planner planner(world, Vehicle{}, {.leave_out = {std::string(row.name)}});
    EXPECT_EQ(planner.options().refinement.moves, ~move_bit(row.name)) << row.name;
  }
  for (const GearMoveRow& row : kGearMoves) {
    const Planner planner(world, Vehicle{}, {.leave_out = {std::string(row.name)}});
    EXPECT_EQ(planner.options().refinement.moves, ~move_bit(row.name)) << row.name;
    for (const MoveRow& other : kMoves) EXPECT_NE(move_bit(row.name), move_bit(other.name)) << row.name;
  }
  EXPECT_EQ(move_bit("slide"), 0u);
}

TEST(Strategy, EveryRowHasAText) {
  for (const StrategyRow& row : kStrategy) {
    EXPECT_FALSE(row.name.empty());
    EXPECT_FALSE(text_of(row.when).empty()) << row.name;
    EXPECT_FALSE(text_of(row.step).empty()) << row.name;
  }
  EXPECT_EQ(text_of(When{.known = Known::kPath, .care = Care::kQuick, .gap = 0.07}),
            "a path, several radii or unrefined, gap > 7 %");
  EXPECT_EQ(text_of(When{.known = Known::kPath, .most_tree_poses = 4000}), "a path, up to 4000 poses of trees so far");
  EXPECT_EQ(text_of(When{.most_vertices = 2000}), "a map of up to 2000 vertices");
  EXPECT_EQ(text_of(When{.driving = Driving::kBothGears, .gap = 0.3, .best_gap = 0.3}),
            "both gears, gap > 30 %, best gap > 30 %");
}

// Where no path is known, a row that needs one cannot be taken: it would look at what is not there.
TEST(Strategy, RowsOnTheRoadmapInUseNeedAPath) {
  for (const StrategyRow& row : kStrategy) {
    const bool in_use = std::holds_alternative<TryManeuvers>(row.step) ||
                        std::holds_alternative<TryNarrowPlaces>(row.step) ||
                        std::holds_alternative<TryOtherTurns>(row.step);
    if (!in_use) continue;
    EXPECT_TRUE(row.when.known == Known::kForwardPath || row.when.known == Known::kByManeuvers) << row.name;
  }
}

// Right behind the start, where a path forwards has to go all around.
TEST(Strategy, DearForwardPathsAreNotImproved) {
  const World world({}, test::box(-20.0, -20.0, 20.0, 20.0).outer);
  const PlanRequest behind{.start = {0.0, 0.0, 0.0}, .goal = {-3.0, 0.0, 0.0}, .reverse = true};
  const Planner planner(world, Vehicle{}), without(world, Vehicle{}, {.leave_out = {"48 maneuvers at both ends"}});
  for (const bool reverse : {false, true}) {
    PlanRequest request = behind;
    request.reverse = reverse;
    const PlanResult plan = planner.plan(request);
    ASSERT_TRUE(plan.solved());
    EXPECT_EQ(plan.statistics.maneuver_poses > without.plan(request).statistics.maneuver_poses, !reverse);
  }
}

// Other radii and turns are no help far from the lower bound: rows for them make no difference there.
TEST(Strategy, TriesOtherTurnsNearTheBoundOnly) {
  const std::vector<std::string> rows{"3 radii, 4 x lateral acceleration", "2 radii, 16 x lateral acceleration",
                                      "faster turns", "slower turns"};
  const auto tries_them = [&](const char* name) {
    const auto driven = catalog_driven_world(name);
    const World world = to_world(driven->map, name);
    const PlanRequest request{.start = *driven->map.start, .goal = *driven->map.goal};
    const auto expanded = [&](const std::vector<std::string>& left_out) {
      const Planner planner(world, Vehicle(driven->robot), {.graph_mode = GraphMode::kLazy, .leave_out = left_out});
      return planner.plan(request).statistics.nodes_expanded;
    };
    return expanded({}) > expanded(rows);
  };
  EXPECT_TRUE(tries_them("driven/rooms/r4/g1/c50/s2019"));    // several radii, a gap of 8 %
  EXPECT_FALSE(tries_them("driven/rooms/r5/g1/c50/s2011"));   // 119 %
  EXPECT_TRUE(tries_them("driven/hugging/r2/g1/c50/s2017"));  // one radius, 4 %
  EXPECT_FALSE(tries_them("driven/rooms/r1/g1/c50/s2007"));   // 27 %
}

// A plan of a driven world without rows of a name.
struct Without {
  const char* world;
  std::vector<std::string> left_out;
  bool reverse;
  std::size_t added = 0;  // obstacles outside of the bounds
};
PlanStatistics statistics_without(const Without& query) {
  auto driven = catalog_driven_world(query.world);
  for (std::size_t i = 0; i < query.added; ++i) {
    const double x = driven->map.bounds->front().x() - 10.0 - static_cast<double>(i);
    driven->map.obstacles.push_back({{{x, 0.0}, {x + 0.5, 0.0}, {x, 0.5}}, {}});
  }
  const Planner planner(to_world(driven->map, query.world), Vehicle(driven->robot),
                        {.graph_mode = GraphMode::kLazy, .leave_out = query.left_out});
  return planner.plan({.start = *driven->map.start, .goal = *driven->map.goal, .reverse = query.reverse}).statistics;
}

// Plans far from the bound whose first path took trees of many poses.
TEST(Strategy, LooksForNoOtherWaysBehindManyTreePoses) {
  const auto looks_for_them = [](const char* name) {
    return statistics_without({name, {}, false}).tree_poses >
           statistics_without({name, {"other ways by trees"}, false}).tree_poses;
  };
  EXPECT_TRUE(looks_for_them("driven/scattered/r1/g1/c50/s17108"));  // none
  EXPECT_FALSE(looks_for_them("driven/hugging/r9/g1/c50/s32197"));   // 5,056
}

// Where trees of slim bodies have found no path, they find no other ways either.
TEST(Strategy, LooksForNoOtherWaysInTheNarrowestPlaces) {
  const auto looks_for_them = [](const char* name) {
    return statistics_without({name, {}, true}).turns_checked !=
           statistics_without({name, {"other ways by trees in both gears"}, true}).turns_checked;
  };
  EXPECT_TRUE(looks_for_them("driven/scattered/r1/g2/c50/s16252"));
  EXPECT_FALSE(looks_for_them("driven/hugging/r2/g2/c50/s32325"));
}

// What the rows take grows with the map, even where all that is added to it lies outside of the bounds.
TEST(Strategy, LooksForFasterPathsByTreesOnSmallMapsOnly) {
  const auto looks_for_them = [](const char* name, const char* row, std::size_t added) {
    return statistics_without({name, {}, false, added}).turns_checked !=
           statistics_without({name, {row}, false, added}).turns_checked;
  };
  constexpr std::size_t kFew = 10, kMany = 700;
  const auto expect_on_small_maps_only = [&](const char* name, const char* row) {
    EXPECT_TRUE(looks_for_them(name, row, kFew)) << row;
    EXPECT_FALSE(looks_for_them(name, row, kMany)) << row;
  };
  expect_on_small_maps_only("driven/scattered/r1/g1/c50/s17108", "other ways by trees");
  expect_on_small_maps_only("driven/hugging/r6/g1/c50/s32293", "plan of a slim body");
}

TEST(Strategy, TriesFewerPlacesToTurnOnLargeMaps) {
  const auto places = [](std::size_t added) {
    return statistics_without({"driven/scattered/r6/g2/c50/s31176", {}, true, added}).maneuver_poses;
  };
  EXPECT_GT(places(10), places(700));
}

// The path that is driven forwards is near the bound, and the one with changes of gear far above it.
TEST(Strategy, LooksForNoChangesOfGearBesideAGoodPathForwards) {
  for (const char* row : {"changes of gear near the ends", "changes of gear further away"}) {
    const char* world = "driven/rooms/r8/g2/c50/s31223";  // 19 %
    EXPECT_EQ(statistics_without({world, {}, true}).maneuver_poses,
              statistics_without({world, {row}, true}).maneuver_poses)
        << row;
  }
}

// Maneuvers are tried forwards only if changes of gear near the ends lead nowhere.
TEST(Strategy, ChangesOfGearComeBeforeManeuvers) {
  const auto row = [](std::string_view name) { return std::ranges::find(kStrategy, name, &StrategyRow::name); };
  EXPECT_LT(row("changes of gear near the ends"), row("maneuvers"));
  // Where no path is known, trees find one sooner.
  const auto last_near = std::find_if(row("trees in both gears"), std::end(kStrategy),
                                      [](const StrategyRow& r) { return r.name == "changes of gear near the ends"; });
  ASSERT_NE(last_near, std::end(kStrategy));
  EXPECT_LT(last_near, row("maneuvers"));
  EXPECT_EQ(row("changes of gear near the ends")->when.known, Known::kPath);
  EXPECT_GT(row("changes of gear near the ends")->when.gap, 0.0);  // a path near its bound needs none
  EXPECT_LT(row("proof of an enclosure"), row("trees in both gears"));
  const auto later = std::find_if(row("trees in both gears"), std::end(kStrategy),
                                  [](const StrategyRow& r) { return r.name == "proof of an enclosure"; });
  ASSERT_NE(later, std::end(kStrategy));
  EXPECT_GT(later, row("narrow trees of slim bodies in both gears"));
  EXPECT_GT(std::get<ProveEnclosure>(later->step).boxes,
            std::get<ProveEnclosure>(row("proof of an enclosure")->step).boxes);
  EXPECT_LT(row("trees in both gears"), row("maneuvers"));
  EXPECT_EQ(row("maneuvers")->when.known, Known::kNoPath);
}

// Each row alone left out: what is found is free, and the bound holds.
TEST(Strategy, PlansAreFreeWithoutAnyOneRow) {
  const World world = random_world({.kind = ClutterKind::kStar, .obstacles = 6, .vertices = 5, .fill = 0.3, .seed = 2});
  const Vehicle vehicle({.turn_speed = LateralAccelerationLimit{4.0}, .max_acceleration = 2.0});
  const QuerySet queries = make_reference_queries(world);
  const Planner planner(world, vehicle);
  const std::vector<PlanRequest> requests = random_queries(world, queries, vehicle, {.count = 2, .seed = 3});
  const PlanLimits few{.tree_poses = 100};
  std::vector<std::uint64_t> expanded;
  expanded.reserve(requests.size());
  for (const PlanRequest& request : requests) expanded.push_back(planner.plan(request, few).statistics.nodes_expanded);
  std::string last;
  std::size_t solved = 0, other_plans = 0;
  for (const StrategyRow& row : kStrategy) {
    if (row.name == last) continue;
    last = row.name;
    PlannerOptions options;
    options.leave_out = {last};
    options.refinement.max_trials = 50;
    const Planner without(world, vehicle, backend_of(world, queries, planner.visibility_graph()), options);
    for (std::size_t i = 0; i < requests.size(); ++i) {
      PlanRequest request = requests[i];
      request.reverse = row.when.driving == Driving::kBothGears;
      const PlanResult plan = without.plan(request, few);
      if (!plan.solved()) continue;
      ++solved;
      test::expect_valid(without, plan, request.reverse);
      other_plans += plan.statistics.nodes_expanded != expanded[i];
    }
  }
  EXPECT_GT(solved, 0u);
  EXPECT_GT(other_plans, 0u);
}

}  // namespace
}  // namespace arcway::internal
