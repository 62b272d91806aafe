#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "arcway/vehicle.h"
#include "core/refine/optimize_chain.h"

namespace arcway::internal {

/// The moves of refinement: in which order it changes a path, by which amounts, and when it returns to an earlier move.
/// Lengths are in smallest turning radii, unless said otherwise. PlannerOptions::leave_out names moves to do without.

/// When a move is tried.
enum class Stage {
  kSimplify,          ///< in order, again from the first one on whenever one helps
  kSlide,             ///< each once; refinement returns to kSimplify if one helps
  kOptimize,          ///< once, after kTrialsBefore trials of the stages above; if it helps, refinement ends
  kOptimizeAtLength,  ///< instead of kOptimize for the best path, in kMostRounds rounds after kSimplify
  kImprove,           ///< each once; refinement returns to kSimplify if one helps
  kSettle,            ///< each once, when no stage above helps; the path is a local optimum then
  kEscape,            ///< each once, at a local optimum; refinement returns to kSimplify if one helps
  kFinish             ///< each once, at the end
};

/// Leaves out turns between two circles, many at once first.
struct DropTurns {};
/// Joins start or goal to a later circle by an arc to either side.
struct RejoinEnds {};
/// Makes several turns one turn, tangent to the lines before and behind.
struct MergeTurns {
  std::span<const double> radii;              ///< radii that are tried, the smallest first
  bool all = false;                           ///< all turns of the path; otherwise some, so that two are left
  double least_turn = 1e-3, most_turn = 3.0;  ///< range of the turn that takes the place of several [rad]
};
/// Makes parts of a turn wider, and the ends tighter.
struct WidenTurns {
  std::span<const double> shares;       ///< shares of a turn that become wider
  std::span<const double> factors;      ///< factors of its radius
  std::span<const double> step_shares;  ///< shares of a turn between a tight and a wide one, on a radius between theirs
  std::span<const double> end_turns;    ///< turns at the ends of the path that become as tight as allowed [rad]
  std::span<const double> end_factors;  ///< factors of the radius of the rest of the first or the last turn
  double least_turn = 0.02;             ///< smallest turn that is driven in two parts [rad]
  double least_ratio = 1.5;             ///< smallest ratio of two radii that leaves room for one between them
  double least_beside = 1.5;            ///< smallest radius beside a turn at the end that is as tight as allowed
};
/// Two arcs and a line join places on two lines of the path.
struct InsertWords {
  int parts;                          ///< number of equal parts of each line; words join at the places between them
  std::span<const double> near_ends;  ///< distances of further places from the ends of a line
  double near = 0.25;                 ///< largest such distance, as a share of the line's length
};
/// A step of the circle of a turn that is neither the first nor the last one. Its center moves inwards from the point
/// of the inner swept circle where the share `at` of the turn is done, around that point, and along the heading there.
/// Its radius grows.
struct CircleStep {
  double inwards, around, grow, at, along = 0.0;
};
/// Slides centers and radii by steps that are halved.
struct SlideCircles {
  std::span<const CircleStep> steps;
  double last_step;         ///< smallest step; 0: RefineOptions::smallest_step
  double first_step = 1.0;  ///< largest step
  int most_iterations = 8;  ///< iterations with steps of one length
  double tied_turn = 0.5;   ///< by which circles that touch another one turn around it, for a step of 1 [rad]
  /// Growths of the radii of such circles and of those at the ends, for a step of 1.
  std::array<double, 3> growths{0.0, 1.0, -0.5};
};

/// Drives each turn in several arcs and optimizes all of them at once, see ChainOptimizer. For vehicles that it serves.
struct OptimizeTurns {
  ChainEffort effort;
  double one_speed_barrier;  ///< ChainEffort::first_barrier, for vehicles that drive all turns at one speed
  [[nodiscard]] ChainEffort effort_for(const Vehicle& vehicle) const {
    ChainEffort chosen = effort;
    if (!ChainOptimizer::serves_chains(vehicle)) chosen.first_barrier = one_speed_barrier;
    return chosen;
  }
};

using Move = std::variant<DropTurns, RejoinEnds, MergeTurns, WidenTurns, InsertWords, SlideCircles, OptimizeTurns>;

struct MoveRow {
  std::string_view name;
  Stage stage;
  Move move;
};

inline constexpr double kMergedRadii[] = {1.0, 1.5, 2.25, 3.5, 5.0, 8.0, 12.0, 18.0};
inline constexpr double kWiderShares[] = {0.25, 0.5, 0.75, 0.9};
inline constexpr double kWiderFactors[] = {1.5, 2.5, 5.0, 10.0};
inline constexpr double kStepShares[] = {0.5, 0.75, 0.9};
inline constexpr double kEndTurns[] = {0.1, 0.2, 0.4, 0.8};
inline constexpr double kEndFactors[] = {1.0, 0.5, 2.0};
inline constexpr double kNearEnds[] = {0.5, 1.0, 2.0, 4.0};

inline constexpr std::array<CircleStep, 21> kCircleSteps{
    {{1, 0, 0, 0.5},     {0, 1, 0, 0.5},    {0, -1, 0, 0.5},   {1, 1, 0, 0.5},  {1, -1, 0, 0.5}, {0, 0, 1, 0.5},
     {0, 0, -0.5, 0.5},  {-1, 0, 0, 0.5},   {0, 1, 1, 0.5},    {0, -1, 1, 0.5}, {1, 0, 1, 0.5},  {-1, 0, 1, 0.5},
     {-1, 0, -0.5, 0.5}, {0, 1, 0, 0.0},    {0, -1, 0, 0.0},   {0, 1, 0, 1.0},  {0, -1, 0, 1.0}, {0, 0, 0, 0.0, 1},
     {0, 0, 0, 0.0, -1}, {0, 0, 0, 1.0, 1}, {0, 0, 0, 1.0, -1}}};
// The steps around the middle of the turn. What is in the way often lies where the turn begins or ends, or beside a
// line that stays where it is when the circle moves along it. Steps there lead some paths to a worse optimum if they
// are tried too early.
inline constexpr std::span kMiddleSteps = std::span(kCircleSteps).first<13>();
inline constexpr std::span kEndSteps = std::span(kCircleSteps).first<17>();

inline constexpr MoveRow kMoves[] = {
    {"drop turns", Stage::kSimplify, DropTurns{}},
    {"rejoin ends", Stage::kSimplify, RejoinEnds{}},
    {"merge turns", Stage::kSimplify, MergeTurns{kMergedRadii}},
    {"slide circles roughly", Stage::kSlide, SlideCircles{kMiddleSteps, 0.125}},
    // Vehicles of one turn speed: 204 plans of the paper's robot among 100 obstacles take 0.61 of the time that they
    // take without, and are faster by 0.03 % in the mean. A barrier of 1e-3 takes a fifth more. Of 242 driven worlds,
    // 84 are faster by more than 0.1 %, and 17 slower by more than 0.05 %, by up to 2 %.
    {"optimize turns", Stage::kOptimize,
     OptimizeTurns{{.parts = 3, .least_turn = 0.05, .iterations = 40, .first_barrier = 1e-3}, 1e-4}},
    {"optimize turns at length", Stage::kOptimizeAtLength,
     OptimizeTurns{{.parts = 2, .least_turn = 0.15, .iterations = 60, .first_barrier = 3e-4}, 3e-4}},
    {"widen turns", Stage::kImprove, WidenTurns{kWiderShares, kWiderFactors, kStepShares, kEndTurns, kEndFactors}},
    {"insert words", Stage::kImprove, InsertWords{2, {}}},
    {"slide circles finely", Stage::kSettle, SlideCircles{kEndSteps, 0.0}},
    // Words between more places may lead out of a local optimum.
    {"insert more words", Stage::kEscape, InsertWords{3, kNearEnds}},
    {"merge all turns", Stage::kEscape, MergeTurns{.radii = kMergedRadii, .all = true}},
    {"slide circles along lines", Stage::kFinish, SlideCircles{kCircleSteps, 0.0}},
};

/// Gap, over the lower bound, at which refinement ends: what is left is not worth a trial.
inline constexpr double kAtBound = 3e-4;
/// Number of trials of simpler moves before turns are optimized.
inline constexpr std::uint64_t kTrialsBefore = 1000;
/// Most steps of the optimizer times circles of a chain, and how many steps it may take at any rate. Of 400 driven
/// worlds without such a bound, one took 5.8 s, and 5.1 s with it; the plans are as fast in the mean.
inline constexpr std::size_t kMostCircleSteps = 1500, kLeastSteps = 10;
/// Most rounds of optimizing a best path.
inline constexpr int kMostRounds = 2;
/// Share of the travel time that a round must save, if another one is to follow.
inline constexpr double kWorthRound = 1e-3;
/// Number of trials of kSimplify before each round.
inline constexpr std::uint64_t kTrialsBetween = 200;
/// Ratio of the travel time to its lower bound from which on an optimized path may lead around something in vain.
inline constexpr double kFarFromBound = 1.5;
/// Number of trials of all moves of such a path, or where no round helps.
inline constexpr std::uint64_t kTrialsInVain = 4000;
/// Number of local optima in a row, each faster by kWorthSettling than the one before, at which refinement ends.
inline constexpr int kMostSettled = 4;
inline constexpr double kWorthSettling = 1e-5;  ///< share of the travel time

// The moves of refinement in both gears.

/// Joins two places of the path: by a word of Reeds and Shepp, by a Dubins word in either gear, or by a biarc.
struct InsertGearWords {
  std::span<const double> radii;   ///< radii of words; the first one alone between places without a gear change
  std::span<const double> ratios;  ///< ratios of the tangent lengths of biarcs
  /// All places up to this many apart are joined. Each longer span is longer than the one before by 1 / span_ratio of
  /// it. These are some n log n pairs of n places.
  std::size_t every_span, span_ratio;
};
/// Refines the part between two gear changes as a path that is driven forwards.
struct RefineRuns {};
/// Moves and turns the poses at which the gear changes, by steps that are halved.
struct SlideCusps {
  double first_step;               ///< largest step, in smallest turning radii and in radians
  std::ptrdiff_t segments_beside;  ///< number of segments on either side that may be replaced
  std::size_t links_tried;         ///< number of connections tried on either side
};

/// Leaves out the run between two gear changes. The runs beside it are pushed free, and to where they ended before, by
/// least squares: push_free.
struct DropGearChanges {
  std::size_t runs_beside;  ///< number of runs on either side that change
  double longest;           ///< longest run that is tried, as a multiple of turning radius plus body length
  std::size_t most_failed;  ///< runs are tried, the shortest first, until so many could not be left out
};

using GearMove = std::variant<InsertGearWords, RefineRuns, OptimizeTurns, SlideCusps, DropGearChanges>;

struct GearMoveRow {
  std::string_view name;
  Stage stage;  ///< kImprove: each once, in rounds; kFinish: once, behind them; kEscape: then, and rounds follow again
  GearMove move;
  int last_round = 0;  ///< up to which another round follows if the move helps, counted from 0
};

inline constexpr double kGearWordRadii[] = {1.0, 2.0, 4.0};
inline constexpr double kGearBiarcs[] = {1.0, 0.5, 2.0};
inline constexpr InsertGearWords kInsertGearWords{kGearWordRadii, kGearBiarcs, 16, 8};

/// Most rounds of kImprove in both gears.
inline constexpr int kMostGearRounds = 4;
inline constexpr GearMoveRow kGearMoves[] = {
    {"words between places", Stage::kImprove, kInsertGearWords, kMostGearRounds},
    {"refine between changes of gear", Stage::kImprove, RefineRuns{}},
    {"slide changes of gear", Stage::kImprove, SlideCusps{.first_step = 0.5, .segments_beside = 4, .links_tried = 4},
     kMostGearRounds},
    // Of 398 driven worlds with 5 cm of room, it makes 192 plans faster by more than 0.1 %, 109 by more than 1 %, and
    // 15 slower, for 5 % more time in the median. In the rounds as well, and with turns cut in two, 7 more are faster
    // by more than 1 %, for twice that. Without the slides before it, 4 more are slower by more than 1 %.
    {"optimize turns in both gears", Stage::kFinish,
     OptimizeTurns{{.parts = 1, .least_turn = 0.05, .iterations = 60, .first_barrier = 1e-3}, 1e-3}},
    // Gear changes that moved last make room for words.
    {"words between places", Stage::kFinish, kInsertGearWords},
    // Of 90 driven worlds it makes 6 plans faster, by up to 22 %, and none slower. There 8 failures lead no further
    // than 3.
    {"leave out changes of gear", Stage::kEscape, DropGearChanges{.runs_beside = 2, .longest = 1.0, .most_failed = 3}},
};
/// Share of the trials that these rounds may use; kFinish has the rest.
inline constexpr double kGearRoundsShare = 0.8;
/// Largest number of times that kEscape is tried one after the other.
inline constexpr int kMostGearEscapes = 4;

/// The bit of a move in RefineOptions::moves; 0 for a name that no move has.
constexpr std::uint32_t move_bit(std::string_view name) {
  std::uint32_t bit = 1;
  for (const MoveRow& row : kMoves) {
    if (row.name == name) return bit;
    bit <<= 1;
  }
  for (const GearMoveRow& row : kGearMoves) {
    if (row.name == name) return bit;
    bit <<= 1;
  }
  return 0;
}

}  // namespace arcway::internal
