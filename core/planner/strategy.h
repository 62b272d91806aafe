#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "core/attach/search_options.h"
#include "core/planner/strategy_row.h"
#include "core/refine/moves.h"
#include "core/search/effort.h"

/// What a query tries, in which order, from which gap on, and with how much effort. PlanRun goes through `kStrategy`
/// from the first row to the last, and takes each whose condition holds. `arcway report --tables` writes it as a table.

namespace arcway::internal {

// The paths of several roadmaps are refined as far as tells which is the best, and that one then at length.
inline constexpr Trials kUntilCompared{.several = 0.75};

// Gap of the best plan from which on paths of other routes are worth looking for.
inline constexpr double kWorthOtherRoutes = 0.01;
// Lateral accelerations of other vehicles, whose fastest path may be the faster one once refined: many turns become
// wider or are left out, others stay what they are.
inline constexpr double kFasterTurns = 2.0, kSlowerTurns = 0.5;

// Passes of trees of forward motions. A finer one with as many poses solves one more of 560 driven worlds.
inline constexpr std::array<TreePass, 2> kTreePasses{{{1.0 / 64.0, 4, 0.2, false}, {1.0 / 128.0, 4, 0.2, true}}};
// Passes if one end lies in a dead end. They find the ways out that are found at all: those of some 480 driven worlds
// with 2 mm of room of which that is so and that passes in the open solve.
inline constexpr std::array<TreePass, 2> kDeadEndPasses{{{1.0 / 128.0, 4, 0.1, true}, {1.0 / 512.0, 8, 0.1, true}}};
inline constexpr TreeEffort kTreeEffort{
    .field_cells = 100'000,
    .ratios = {1.0, 0.4, 2.5},
    .near = 1.0,
    .nearest = 3,
    .first_roadmap = 64,
    .roadmap_factor = 4,
    .edges = 3000,
    .after_dry = 4,
    .attachments = 200,
    .most_refused = 6,
    .refused_poses = 32,
};
inline constexpr SurroundingsEffort kSurroundingsEffort{
    .coarse = kTreePasses[0], .poses = 1600, .small = 300, .fine = {1.0 / 512.0, 8, 0.2, true}, .more = 1.25};

// Shares of the width by which slim bodies are narrower; they are shorter by half the share. A path of the second one
// is made free more often, but found more seldom. Measured on 46 driven worlds with 2 mm of room that trees of the real
// body do not solve: 35 are solved with these shares, 32 with 0.06 and 0.02, 30 with 0.15 and 0.05. Where an end of the
// real body is closed in, the second one alone is tried: the first one slips through many gaps that are too narrow.
inline constexpr std::array kSlimBodies{0.1, 0.03};
// Share of the width by which the body of PlanSlimBody is narrower; it is shorter by half the share. Of 14 driven
// worlds where plans were slower than the drive, 6 no longer are. With 0.1, 0.15, 0.25 and 0.3 these are 3, 3, 3 and 0,
// with 0.1, 0.2 and 0.4 one after the other 6.
inline constexpr double kSlimPlan = 0.2;
// Largest number of vertices of a map where such a body is planned for, and where trees look for faster paths that are
// driven forwards. What these rows take grows with the map. Among 1,000 obstacles, they took 46 % of the time of 168
// plans of three robots, and made three of them faster, all of one query. Among 300, such a body took a quarter of the
// time of 126 plans, and made one faster.
inline constexpr std::size_t kSmallMap = 2'000;
// Largest number of vertices of a map where circles in gaps are looked at for a faster path. On one of 40,000, they
// took a third of the time of six plans, and made none faster.
inline constexpr std::size_t kMediumMap = 20'000;
// The pass of trees of the first one of kSlimBodies. It solves 32 of these 46 worlds, a quarter of its poses 25.
inline constexpr std::array<TreePass, 1> kSlimPasses{{{1.0 / 64.0, 4, 0.8, false}}};
// A fiftieth of that, where a path is known. Of 40 queries beside walls in both gears, a sixteenth makes 6 faster, by
// up to 6 %, for a fifth more time.
inline constexpr std::array<TreePass, 1> kMoreSlimPasses{{{1.0 / 64.0, 4, 0.016, false}}};

// The pass of trees that keep off the paths so far. Of 72 driven worlds, more become faster with a share of 0.1 than
// with 0.05.
inline constexpr std::array<TreePass, 1> kOtherWaysPasses{{{1.0 / 64.0, 4, 0.1, false}}};

// The narrow part of the strategy, in one gear. It is looked at before a way in both gears if the vehicle may not
// reverse, else behind it: most ways out of narrow places are found sooner in both gears.
inline constexpr GrowTrees kCoarseTrees{
    .share = 1.0, .passes = std::span(kTreePasses).first<1>(), .explores_surroundings = true};
inline constexpr GrowTrees kFewCoarseTrees{
    .share = 0.25, .passes = std::span(kTreePasses).first<1>(), .explores_surroundings = true};
inline constexpr GrowTrees kFinerTrees{
    .share = 1.0, .passes = std::span(kTreePasses).subspan<1, 1>(), .only_in_the_open = true};
// A path of fewer motions is made free more often, and is faster then.
inline constexpr GrowSlimTrees kSlimTrees{.passes = kSlimPasses};
inline constexpr GrowSlimTrees kShortSlimTrees{.passes = kMoreSlimPasses};
// A path that may be faster is mostly found by few poses, or by none.
inline constexpr std::array<TreePass, 1> kFewSlimPasses{{{1.0 / 64.0, 4, 0.005, false}}};
inline constexpr GrowSlimTrees kFewSlimTrees{.passes = kFewSlimPasses, .shortenings = 3, .slower = 0.5};
inline constexpr GrowSlimTrees kLessSlimTrees{
    .body = 1, .passes = std::span(kTreePasses).first<1>(), .when = WhenSlim::kClosedOrRefused};
inline constexpr When kNarrowForwards{.known = Known::kNoPath, .driving = Driving::kForwards, .grows_trees = true};
inline constexpr When kWholeNarrowForwards{
    .known = Known::kNoPath, .driving = Driving::kForwards, .whole = true, .grows_trees = true};
inline constexpr When kInsteadOfGearChanges{
    .known = Known::kGearChanges, .driving = Driving::kBothGears, .grows_trees = true, .gap = 0.5, .best_gap = 0.5};
inline constexpr TryOtherWays kOtherWays{.passes = kOtherWaysPasses, .rounds = 3, .shortenings = 3, .slower = 0.5};
// The best path is still far above the lower bound.
constexpr When far_from_bound(Known known, Driving driving, double best_gap, bool grows_trees = true) {
  return {.known = known,
          .driving = driving,
          .whole = true,
          .refines = true,
          .grows_trees = grows_trees,
          .best_gap = best_gap};
}
// The cheapest path of the rows in both gears is.
constexpr When gears_far_from_bound(double gap) {
  When when = far_from_bound(Known::kPath, Driving::kBothGears, 0.0);
  when.gap = gap;
  return when;
}
// Trees of forward motions have had no more poses than that so far.
constexpr When before_tree_poses(When when, std::uint64_t most) {
  when.most_tree_poses = most;
  return when;
}
// The map has at most so many vertices.
constexpr When on_map_of(std::size_t most_vertices, When when) {
  when.most_vertices = most_vertices;
  return when;
}
// Trees that keep off the paths so far are worth it.
constexpr When worth_other_ways(Radii radii, double best_gap, std::uint64_t most_tree_poses) {
  When when = far_from_bound(Known::kForwardPath, Driving::kForwards, best_gap);
  when.radii = radii;
  return on_map_of(kSmallMap, before_tree_poses(when, most_tree_poses));
}
inline constexpr When kNarrowAfterGears{
    .known = Known::kNoPath, .driving = Driving::kBothGears, .whole = true, .grows_trees = true};

// A path of other radii that is slower by this share is not worth refining. On 309 plans of three robots, 0.04 in place
// of 0.2 saves 4 % of the time, and one plan takes 6 % longer.
inline constexpr double kRefinedFaster = 0.2;
// Largest gap at which other radii are tried: what they gain is less. With 0.3, 1 of 183 plans among 100 obstacles is
// slower, by 2 %, with 0.1 there are 5. With 0.1, 1 of 120 plans in driven worlds is slower, by 0.3 %. Of 600 plans of
// three robots, 50 are slower than those that trials find without a limit, 52 with 0.4, for 5 % less time.
inline constexpr double kTooFarForRadii = 0.4;
constexpr When other_radii(double most_gap) {
  return {.known = Known::kForwardPath,
          .radii = Radii::kSeveral,
          .refines = true,
          .best_gap = kWorthOtherRoutes,
          .most_gap = most_gap};
}
inline constexpr When kOtherRadii = other_radii(kTooFarForRadii);
// As that, for tight turns driven fast. Of 87 plans among obstacles with a gap of 0.4 to 0.8, they make 15 faster, by
// up to 10 %, for 3 % of the time of all 954.
inline constexpr When kFewOtherRadii = other_radii(0.8);
// Largest gap at which turns of another vehicle are tried, where there is one radius. Of 240 driven worlds with a
// larger one, they make 1 faster, by 0.1 %.
inline constexpr double kTooFarForTurns = 0.2;
inline constexpr When kOtherTurns{.known = Known::kForwardPath,
                                  .radii = Radii::kTightest,
                                  .refines = true,
                                  .best_gap = kWorthOtherRoutes,
                                  .most_gap = kTooFarForTurns};

// Largest gap at which a path that joins or leaves the roadmap elsewhere is tried. Of 240 driven worlds with a larger
// one, they make 3 faster, by up to 0.7 %.
inline constexpr double kTooFarForEnds = 0.3;
// A path that joins or leaves the roadmap elsewhere may also be the faster one where zones are slow.
inline constexpr When kOtherEnds{.known = Known::kForwardPath,
                                 .care = Care::kThorough,
                                 .refines = true,
                                 .gap = 0.04,
                                 .best_gap = kWorthOtherRoutes,
                                 .most_gap = kTooFarForEnds,
                                 .gap_counts_zones = true};

// Number of radii of the circles of start and goal, where a path is there or easy to find. The vehicle is slow there,
// and refinement makes these turns wider. Measured on 306 paths of three robots: all five take a quarter longer, and
// the paths are as fast in the mean.
inline constexpr std::size_t kEndRadii = 2;

// Factors by which zones count as slower on routes through them. Slowing down at a border takes time that routes do not
// know, so that a way around may be the faster one.
inline constexpr std::array kSlowerZones{1.0, 3.0};

// Share by which the second best path may cost more and may become the best one at length. Of 600 plans of three
// robots, 46 are slower than those that trials find without it, 42 with 0.01 and 39 with 0.03, for 12 and 24 % more
// time, all with six searches for other sides.
inline constexpr double kCloseSecond = 0.01;

// Most paths of several radii end as dozens of arcs, which the optimizer hardly moves. Of 620 plans of three robots,
// 28 are slower by 0.05 % than those of trials without a drive in fewer arcs, and 21 with it and `fewer arcs` below,
// for 13 % more time. Of 1,599 driven worlds, 4 are slower than the drive without both, and 2 with them.
inline constexpr RefineBest kRefineAtLength{.close = kCloseSecond, .fewer_arcs_gap = 0.05};

// Parts of a path that are planned again: halves, then smaller ones, which are planned sooner.
inline constexpr std::array<PathPart, 5> kParts{{{0.0, 0.5}, {0.25, 0.75}, {0.5, 1.0}, {0.125, 0.5}, {0.5, 0.875}}};

// Parts that are planned again quickly: most gain by three quarters of a path.
inline constexpr std::array<PathPart, 11> kQuickParts{{{0.0, 0.75},
                                                       {0.25, 1.0},
                                                       {0.125, 0.875},
                                                       {0.0, 0.5},
                                                       {0.25, 0.75},
                                                       {0.5, 1.0},
                                                       {0.0, 0.3},
                                                       {0.2, 0.5},
                                                       {0.35, 0.65},
                                                       {0.5, 0.8},
                                                       {0.7, 1.0}}};

inline constexpr PlanPartsQuickly kForwardPartsQuickly{.parts = kQuickParts, .gap = 0.05, .most_failed = 2};

// Suboptimality of the search for a first path.
inline constexpr double kHaste = 1.0;
// Suboptimality of the search as if there were no zones: it needs to tell percents.
inline constexpr double kHasteWithoutZones = 0.01;

inline constexpr StrategyRow kStrategy[] = {
    // A first path, driven forwards.
    {"first path", {.radii = Radii::kSeveral, .slim_body = true}, FindSoon{kEndRadii, kHaste}},
    {"single arcs",
     {.quick_parts = true, .slim_body = true},
     JoinBySingleArcs{On::kAllRadii, kEndRadii},
     kUntilCompared},
    {"single arcs of all radii",
     {.known = Known::kNoPath, .radii = Radii::kSeveral, .slim_body = true},
     JoinBySingleArcs{On::kAllRadii, kEveryRadius},
     kUntilCompared},
    {"proof of a bottleneck", {.known = Known::kNoPath, .whole = true}, ProveBottleneck{}},
    // A quick proof: before maneuvers are tried.
    {"proof of a dead end",
     {.known = Known::kNoPath, .driving = Driving::kForwards, .whole = true},
     ProveDeadEnd{{.halvings = 1, .max_checks = 8500}}},
    {"circles in gaps",
     {.known = Known::kNoPath, .slim_body = true},
     JoinByNarrowPlaces{On::kAllRadii},
     kUntilCompared},
    // The graph has no circles around zones.
    {"routes through one-way zones",
     {.known = Known::kNoPath, .has_one_way = true},
     FollowOneWayRoutes{.most = 8, .shortenings = 1},
     kUntilCompared},
    // Most ways out of narrow places are found sooner in both gears than by maneuvers. Where a path in both gears is
    // much cheaper, nothing looks for faster ones that are driven forwards.
    {"lower bound around obstacles", {.known = Known::kPath, .driving = Driving::kBothGears}, RaiseLowerBound{}},
    {"roadmap backwards", {.driving = Driving::kBothGears, .quick_parts = true, .slim_body = true}, JoinBackwards{}},
    // The way out of a narrow place. Of 143 driven worlds it makes 3 faster whose gap is below 0.3, by up to 3.6 %.
    // More poses make no plan faster. Where no path is known, trees find one sooner in two of three driven worlds.
    // Beside a path that is driven forwards with a gap below 0.3, it makes none of 34 faster.
    {"changes of gear near the ends",
     {.known = Known::kPath, .driving = Driving::kBothGears, .slim_body = true, .gap = 0.3, .best_gap = 0.3},
     JoinBetweenGears{{.cells = 8.0, .most = 12, .most_expansions = 100}}},
    // Some milliseconds, less than looking further for a way out.
    {"proof of an enclosure",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .whole = true},
     ProveEnclosure{3'000}},
    {"trees in both gears, beside a path",
     {.known = Known::kPath, .driving = Driving::kBothGears, .slim_body = true, .gap = 0.2},
     GrowGearTrees{700}},
    {"trees in both gears",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .slim_body = true},
     GrowGearTrees{1500}},
    {"changes of gear near the ends",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .slim_body = true},
     JoinBetweenGears{{.cells = 8.0, .most = 12, .most_expansions = 100}}},
    // Where the way is narrow, trees of slim bodies find a path sooner than those of the body, with fewer changes of
    // gear. Of 15 driven worlds that need either, they find one in 13.
    {"narrow trees of slim bodies in both gears",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .slim_body = true, .grows_trees = true},
     GrowSlimGearTrees{.poses = 4000, .slower = 0.5}},
    // It takes as long as the trees of slim bodies, which find a path in 3 of 4 driven worlds that get here.
    {"proof of an enclosure",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .whole = true},
     ProveEnclosure{15'000}},
    {"maneuvers to circles in gaps",
     {.known = Known::kNoPath, .slim_body = true},
     JoinByManeuversAndNarrowPlaces{On::kAllRadii, 100},
     kUntilCompared},
    // It takes 2 to 30 ms, the trees that it saves 150 to 1,000. It proves 8 of the 21 queries without a path of the
    // kept worlds that reach it; with 30,000 checks it proves 6, with a third halving 9 in 170 ms.
    {"thorough proof of a dead end", kWholeNarrowForwards, ProveDeadEnd{{.halvings = 2, .max_checks = 75'000}}},
    {"trees",
     {.known = Known::kNoPath, .driving = Driving::kForwards, .slim_body = true, .grows_trees = true},
     kCoarseTrees,
     kUntilCompared},
    {"trees of a slim body", kNarrowForwards, kSlimTrees, kUntilCompared},
    {"trees of a less slim body", kWholeNarrowForwards, kLessSlimTrees, kUntilCompared},
    {"finer trees", kWholeNarrowForwards, kFinerTrees, kUntilCompared},
    // More poses. Of 90 driven worlds, the rows above find a path in all in which these would. Tried before trees, they
    // take a sixth of all the time.
    {"maneuvers",
     {.known = Known::kNoPath, .whole = true},
     JoinByManeuvers{On::kAllRadii, {.first = 100, .sparse_factor = 4}},
     kUntilCompared},

    // Faster paths, driven forwards.
    {"lower bound around obstacles", {.known = Known::kPath}, RaiseLowerBound{}},
    // The graph has no circles around zones.
    {"routes through zones",
     {.known = Known::kForwardPath, .has_speed_limits = true, .best_gap = kWorthOtherRoutes, .gap_counts_zones = true},
     FollowZoneRoutes{.slower = kSlowerZones, .least_gain = 0.005, .unrefined = 0.1},
     kUntilCompared},
    // Beside a wall, tight arcs may be blocked where wide ones lead out, and a path by tight ones may go a long way
    // round.
    {"single arcs of all radii",
     {.known = Known::kForwardPath, .radii = Radii::kSeveral, .gap = 0.1, .tight_end = kPi / 2.0},
     JoinBySingleArcs{On::kAllRadii, kEveryRadius},
     kUntilCompared},
    {"tightest radii alone",
     {.known = Known::kForwardPath, .radii = Radii::kSeveral, .best_gap = kAtBound},
     JoinBySingleArcs{On::kTightest, kEndRadii}},
    {"tightest radii alone",
     {.known = Known::kPathElsewhere, .radii = Radii::kSeveral, .best_gap = kAtBound},
     JoinByNarrowPlaces{On::kTightest}},
    // In parts of a path as well, it makes 5 of 800 driven worlds faster, by up to 2 %, and 1 slower, for up to 0.3 s.
    {"tightest radii alone",
     {.known = Known::kPathElsewhere, .radii = Radii::kSeveral, .whole = true, .best_gap = kAtBound},
     JoinByManeuvers{On::kTightest, {.first = 100, .sparse_factor = 4}}},
    {"tightest radii alone",
     {.known = Known::kPathElsewhere, .radii = Radii::kSeveral, .best_gap = kAtBound},
     JoinByManeuversAndNarrowPlaces{On::kTightest, 100}},
    {"6 maneuvers at both ends",
     {.known = Known::kForwardPath, .care = Care::kQuick, .gap = 0.07},
     TryManeuvers{.poses = 6, .least_gain = 0.001}},
    {"48 maneuvers at both ends",
     {.known = Known::kForwardPath, .care = Care::kThorough, .gap = 0.04},
     TryManeuvers{.poses = 48, .least_gain = 0.001}},
    // With several radii, maneuvers bring next to nothing where both ends have room.
    {"120 maneuvers at both ends",
     {.known = Known::kForwardPath, .care = Care::kQuick, .gap = 0.1, .best_gap = 0.1, .tight_end = kPi},
     TryManeuvers{.poses = 120, .least_gain = 0.001}},
    // Of 23 driven worlds, they make 3 faster, by up to 1.3 %, none of a gap above 0.4. With that limit, and circles in
    // gaps from a gap of 0.7 on, 5 of 424 plans among 100 obstacles are slower, by up to 16 %.
    {"200 maneuvers at both ends",
     {.known = Known::kForwardPath, .care = Care::kThorough, .gap = 0.2},
     TryManeuvers{.poses = 200, .least_gain = 0.001}},
    // Of 313 driven worlds, they make 8 faster, none by more than 1 %. Of 204 plans of the paper's robot among 100
    // obstacles, 3 are slower by more than 0.05 % than those of an old state by trials, before 8 with a gap of 0.2, for
    // 4 % more time.
    {"circles in gaps, for speed",
     {.known = Known::kForwardPath,
      .care = Care::kThorough,
      .slim_body = true,
      .gap = 0.08,
      .most_vertices = kMediumMap},
     TryNarrowPlaces{.least_gain = 0.001}},
    // Of 43 driven worlds and 52 plans among obstacles with a gap between 0.2 and 0.3, they make none faster.
    {"circles in gaps, for speed",
     {.known = Known::kForwardPath,
      .care = Care::kQuick,
      .slim_body = true,
      .gap = 0.3,
      .best_gap = 0.3,
      .most_vertices = kMediumMap},
     TryNarrowPlaces{.least_gain = 0.001}},
    // Slower paths at first, they may be faster once refined.
    {"another last circle", kOtherEnds, TryOtherLastCircle{.slower = 0.03}},
    {"another first circle", kOtherEnds, TryOtherFirstCircle{.slower = 0.03}},
    {"faster turns", kOtherTurns, TryOtherTurns{kFasterTurns}},
    {"slower turns", kOtherTurns, TryOtherTurns{kSlowerTurns}},
    // Searches on roadmaps of other radii use no maneuvers. Of 1,281 plans of three robots, it makes 2 faster, by 9
    // and 15 %, and none slower, for 13 ms each time that it is tried. Of 60 driven worlds, it makes 1 slower, by 1 %.
    {"slower turns behind maneuvers",
     {.known = Known::kByManeuvers,
      .radii = Radii::kSeveral,
      .refines = true,
      .best_gap = 0.1,
      .most_gap = kTooFarForRadii},
     TryOtherTurns{kSlowerTurns},
     kUntilCompared},
    // Circles around vertices have few radii, and what refinement makes of a turn is not known before. Where a plan is
    // slower than the one that trials find, mostly no row has proposed the way. Measured on 309 plans of three robots,
    // the last three rows, with kRefinedFaster at 0.2 instead of 0.04, take a seventh of all the time. They make
    // 20 plans faster by 0.3 % or more, 5 of them by 5 % or more, and 6 slower by 0.3 % or more. What such a path costs
    // before its turns are optimized tells little of what it costs then. If turns of paths that are a fifth dearer by
    // then than the best one are left as they are, 9 of 102 plans among 300 obstacles are slower, by up to 8 %.
    {"3 radii, 4 x lateral acceleration", kFewOtherRadii,
     TryOtherRadii{.radii = 3, .factor = 4.0, .slower = kRefinedFaster}, kUntilCompared},
    {"2 radii, 16 x lateral acceleration", kFewOtherRadii,
     TryOtherRadii{.radii = 2, .factor = 16.0, .slower = kRefinedFaster}, kUntilCompared},
    {"5 radii, 2 x lateral acceleration", kOtherRadii,
     TryOtherRadii{.radii = 5, .factor = 2.0, .slower = kRefinedFaster}, kUntilCompared},
    {"1 radius, 16 x lateral acceleration", kOtherRadii,
     TryOtherRadii{.radii = 1, .factor = 16.0, .slower = kRefinedFaster}, kUntilCompared},
    // The way of the best path may pass an obstacle on the slower side. Of 1,215 plans of three robots, 84 are slower
    // than those that trials find without the row, 74 with six searches, which take 12 % of all the time. A fifth of
    // that is saved with four, and one more plan is slower.
    {"other sides of obstacles", kOtherRadii,
     TryOtherSides{.radii = 3, .factor = 4.0, .slower = kRefinedFaster, .most = 4}, kUntilCompared},
    {"refinement at length",
     {.known = Known::kForwardPath, .radii = Radii::kSeveral, .quick_parts = true},
     kRefineAtLength,
     {.several = 24.0}},

    // Cheaper paths, or a first one, in both gears, where the rows above are not enough.
    {"narrow trees in both gears",
     {.known = Known::kNoPath, .driving = Driving::kBothGears},
     GrowNarrowGearTrees{16'000}},
    // Of 12 driven worlds of 2,000 that had no path, they find one in 3. Before the trees of the body, they find some
    // slower ways.
    {"narrow trees of slim bodies in both gears",
     {.known = Known::kNoPath, .driving = Driving::kBothGears, .grows_trees = true},
     GrowSlimGearTrees{.poses = 8000, .slower = 0.5, .again = true, .rest_weight = 1.5}},
    // A cheaper path is there in 6 of 44 driven worlds. Fewer poses miss the one of a parking case that is 15 % faster.
    {"trees in both gears, behind narrow ones",
     {.known = Known::kNarrowPath, .driving = Driving::kBothGears},
     GrowGearTrees{16'000}},
    // Of 136 driven worlds, it makes 25 faster, one by 42 %, and all three that were slower than the drive, by up to
    // 24 %, no longer are. With a gap of 0.5 as many again become faster, for a third more of all the time. With one of
    // 0.7, 5 of 180 plans are faster, by up to 16 %, for a tenth more of the median time.
    {"narrow trees of slim bodies in both gears", gears_far_from_bound(0.85),
     GrowSlimGearTrees{.poses = 4000, .slower = 0.5}},
    // Few poses, where the row above is not taken. Of 794 driven worlds, they make 50 faster by more than 0.1 %, 28 of
    // them by more than 1 %, and 10 slower, for a tenth more of the median time. From a gap of 0.2 on, 74 are faster,
    // for twice that.
    {"narrow trees of slim bodies in both gears", gears_far_from_bound(0.4),
     GrowSlimGearTrees{.poses = 300, .slower = 0.5}},
    // Places to turn further away. Tried in full in 226 driven worlds, they made 16 faster, none of a gap below 0.37,
    // and the catalog's car park from 0.36 on. Few of them find about as much where trees have looked before. With half
    // as many, 6 of 794 are slower, by up to 7 %, and 5 faster, by up to 1 %. Beside a path that is driven forwards
    // with a gap below 0.34, they make none of 23 faster. Among 1,000 obstacles, few of them take a third of the time
    // of all, and of 40 plans of a car two are faster, by 2 %.
    {"changes of gear further away",
     {.driving = Driving::kBothGears, .slim_body = true, .gap = 0.34, .best_gap = 0.34},
     JoinBetweenGears{.attachments = {.cells = 2.0, .most = 99, .most_expansions = 1000},
                      .few = FewGearAttachments{{.cells = 2.0, .most = 24, .most_expansions = 240}, kSmallMap}}},
    {"refinement in both gears", {.driving = Driving::kBothGears}, RefineBothGears{}},
    // What is found first may turn in the wrong place, and refinement leaves it there. Trees of a smaller weight go
    // another way. Of 400 driven worlds, few of them from a gap of 0.6 on make 1 faster, by 14 %, which was slower than
    // the drive, for 2 % more of the median time. Of 40 where narrow trees of the body found the first path, none is.
    {"narrow trees of slim bodies in both gears", far_from_bound(Known::kEasierPath, Driving::kBothGears, 0.6),
     GrowSlimGearTrees{.poses = 2'000, .slower = 0.0, .again = true, .rest_weight = 1.5}},
    {"refinement in both gears", {.driving = Driving::kBothGears}, RefineBothGears{}},
    // Of 237 driven worlds with a gap of 0.9, 10 are faster than with 4,000 poses, by up to 20 %, 3 of which are slower
    // than the drive then. Where the way is not narrow, the row took over a second each time, and few plans gained. Up
    // to a gap of 1.1, 1 of 32 does, by 4 %, for a quarter of the row's time.
    {"narrow trees of slim bodies in both gears", far_from_bound(Known::kPath, Driving::kBothGears, 1.1),
     GrowSlimGearTrees{.poses = 10'000, .slower = 0.0, .again = true}},
    {"refinement in both gears", {.driving = Driving::kBothGears}, RefineBothGears{}},
    // With the next rows, of 794 driven worlds in both gears 27 become faster by more than 1 %, 6 by more than 5 %, for
    // a tenth more of the median time. With a gap of 0.4, 60 do, and the median time grows by half. Of 39 where narrow
    // trees of the body found the first path, 1 does, by 2 %.
    {"other ways by trees in both gears", far_from_bound(Known::kEasierPath, Driving::kBothGears, 0.7),
     TryOtherWaysInBothGears{.poses = 1000, .rounds = 3, .slower = 0.8}, kUntilCompared},
    // A path that is driven forwards is often cheaper beside a wall, and more so the more a change of gear costs.
    {"trees of a slim body, instead of changes of gear", kInsteadOfGearChanges, kShortSlimTrees, kUntilCompared},
    // Of 2,000 driven worlds, they find a path in none. With as many poses as forwards, they take up to 3 s.
    {"trees", kNarrowAfterGears, kFewCoarseTrees, kUntilCompared},
    {"trees of a slim body", kNarrowAfterGears, kShortSlimTrees, kUntilCompared},

    // Of 400 driven worlds in both gears, from a gap of 0.5 on, 18 to 22 become faster by more than 0.1 %, from 0.6 on
    // 8 to 18, and the median time grows by 10 to 16 instead of 3 to 9 %. Of 40 where narrow trees of the body found
    // the first path, 4 do, by up to 6 %. With several radii, the first trees of all make 3 of 63 driven worlds
    // faster, none by more than 1 %. They have a tenth of the poses, beside the roadmap. With that, and with the gaps
    // of the trees below, 210 plans among 100 obstacles of fill 0.45 take 28 % less time in all; two are slower by
    // more than 0.05 %, one by 4 %.
    {"plan of a slim body",
     on_map_of(kSmallMap,
               before_tree_poses(far_from_bound(Known::kForwardPath, Driving::kForwards, 0.35, false), 8000)),
     PlanSlimBody{.slower = 0.2, .first_tree_share = 0.1}, kUntilCompared},
    {"plan of a slim body", on_map_of(kSmallMap, far_from_bound(Known::kEasierPath, Driving::kBothGears, 0.6, false)),
     PlanSlimBody{.slower = 0.2}, kUntilCompared},
    // In both gears, it makes 8 of 59 driven worlds with 5 cm of room faster, by up to 11 %, and 6 of 46 with 2 mm, by
    // up to 25 %, for 1.4 times the time in all. Of 800 driven worlds with 5 cm, those far from the bound make
    // 19 faster forwards, by up to 16 %, and 21 in both gears, by up to 4 %, none slower, for some 5 % more time. With
    // a gap of 0.5 in both gears, and where the way is easy to find, as many again gain by less, for a third more time.
    // With all parts forwards, 28 of 1,100 are faster by more than 0.05 %, 3 of them by more than 1 %, for 4 % more in
    // all, and up to 5.2 s instead of 4.9 s.
    {"parts planned again",
     {.known = Known::kPath, .whole = true, .refines = true, .grows_trees = true},
     PlanParts{.parts = kParts,
               .forward_parts = 3,
               .gap = 0.25,
               .forwards_gap = 0.5,
               .both_gears_gap = 1.0,
               .tree_share = 0.25,
               .most_failed = 3}},
    // Of 800 driven worlds, these rows make some 190 faster forwards, 40 of them by more than 1 %, one by 8 %, and
    // 120 in both gears, for 5 and 2 % more of the median time. Three of 13 that were slower than the drive no longer
    // are. Of 609 plans of three robots among 100 obstacles, they make 86 faster, 41 by more than 0.3 %, and none
    // slower, for 3 % more time in the median.
    {"parts planned again quickly",
     {.known = Known::kForwardPath, .radii = Radii::kSeveral, .whole = true, .refines = true, .best_gap = 0.08},
     kForwardPartsQuickly,
     kUntilCompared},
    // From a gap of 0.08 on, 4 of 800 driven worlds are faster, by up to 1.2 %, and 204 plans of the paper's robot
    // among 100 obstacles by 0.01 % in the mean, for 7 % more of the median time.
    {"parts planned again quickly",
     {.known = Known::kForwardPath, .radii = Radii::kTightest, .whole = true, .refines = true, .best_gap = 0.15},
     kForwardPartsQuickly,
     kUntilCompared},
    {"parts planned again quickly",
     {.known = Known::kPath, .whole = true, .refines = true, .best_gap = 0.4},
     PlanPartsQuickly{.parts = kQuickParts, .gap = 0.3, .most_failed = kQuickParts.size()},
     kUntilCompared},
    // Refinement leaves a path on its way. Trees that keep off the paths so far show others. Of 10 driven worlds where
    // plans were slower than the drive, 8 no longer are, one by 37 %. Of 800 driven worlds, with `fewer arcs`, these
    // rows make 43 faster by more than 1 %, and 22 slower by more than 0.05 %, by up to 2 %. Of 599, trees
    // of the less slim body make 7 faster, by up to 3 %, and 3 slower, for 9 % more time in all. A third round makes
    // none of these faster, for 2 % more, and another one by 5 %.
    // Of 44 driven worlds whose trees had more than 4,000 poses by then, they make none faster by more than 0.1 %. Of
    // 179 with several radii whose trees had any, they make 5 faster, one by 2 %, for a tenth of all the time.
    {"other ways by trees", worth_other_ways(Radii::kTightest, 0.35, 4000), kOtherWays, kUntilCompared},
    {"other ways by trees", worth_other_ways(Radii::kSeveral, 0.5, 0), kOtherWays, kUntilCompared},
    // Paths around vertices take the long way where wide turns between obstacles are free. Few poses, some
    // milliseconds, mend that where the rows above are not taken. Of 162 driven worlds with such a gap, they make
    // 13 faster by up to 7 %, of 385 with a larger one 5.
    {"trees of a slim body, for a faster path",
     {.known = Known::kForwardPath,
      .whole = true,
      .refines = true,
      .grows_trees = true,
      .best_gap = 0.28,
      .most_gap = 0.35,
      .most_vertices = kSmallMap},
     kFewSlimTrees,
     kUntilCompared},
    {"refinement at length",
     {.known = Known::kForwardPath, .radii = Radii::kSeveral},
     kRefineAtLength,
     {.several = 24.0}},
    // The paper's robot: of 204 plans, 4 are slower by more than 0.05 % than by trials alone. With a barrier of 1e-3,
    // 3 are from a gap of 0.1 on, 6 from one of 0.3 on, for a tenth less time, and 3 from one of 0.05 on, for a
    // quarter more.
    {"refinement at length",
     {.known = Known::kForwardPath, .radii = Radii::kTightest, .whole = true, .refines = true, .best_gap = 0.08},
     RefineBest{kCloseSecond},
     {.tightest = 24.0}},
    // Once more, for what the rows behind refinement at length have found. Of 800 driven worlds, a gap of 0.2 makes 14
    // more faster by more than 1 % than one of 0.5. A second round, for 4 % more time, makes 6 more faster.
    {"fewer arcs",
     {.known = Known::kForwardPath, .whole = true, .refines = true, .best_gap = 0.2},
     JoinArcs{},
     {.tightest = 24.0, .several = 24.0}},
};

/// Largest share by which a path that is driven forwards may cost more than one in both gears if it is to be improved.
/// Of 90 driven worlds, no path gains more than 8 % by any one of the rows that improve it.
inline constexpr double kWorthForwards = 0.1;
/// A path of the rows in both gears is not refined if it costs more than the best one, before refinement, by more than
/// this share. With 0.1, plans of 40 queries among 100 obstacles take 1.4 % longer in all; the time is the same on
/// driven worlds.
inline constexpr double kWorthBothGears = 0.25;
/// The path that trees of slim bodies are to improve is refined as well, unless theirs is cheaper by this share before
/// refinement.
inline constexpr double kMuchCheaper = 0.1;
/// Trials of refinement for the cheapest path of the rows in both gears, as a multiple of RefineOptions::max_trials: it
/// has taken longer to find.
inline constexpr double kBothGearsTrials = 5.0;
/// Where turns are optimized, paths of one way mostly end at the same place: one that is not faster before refinement
/// by this share than another one was is not refined.
inline constexpr double kMuchFaster = 0.05;
/// Paths of trees whose costs differ by at most this share count as one way: see TryOtherWays.
inline constexpr double kSameWay = 1e-3;
/// Paths whose costs differ by at most this share count as one: refinement leads several paths to one place.
inline constexpr double kSameCost = 1e-6;
/// Expansions of a search for another path, beside a quarter of those of the first search: where turns cost next to
/// nothing, thousands of paths are as good as each other.
inline constexpr std::uint64_t kMoreExpanded = 1000;

/// The rows but for those of the given names.
std::vector<StrategyRow> strategy_without(std::span<const std::string> names);

}  // namespace arcway::internal
