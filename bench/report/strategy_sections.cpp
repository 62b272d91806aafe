#include "bench/report/strategy_sections.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bench/report/markup.h"
#include "bench/report/results.h"
#include "core/planner/strategy.h"
#include "core/planner/strategy_text.h"
#include "core/refine/moves.h"

namespace arcway::internal::report {
namespace {

constexpr const char* kCases[] = {"one radius", "several radii", "both gears"};

const Measurement* find(const Results& results, const std::string& name) {
  const auto found = std::ranges::find(results.measurements, "Strategy/" + name, &Measurement::name);
  return found == results.measurements.end() || !found->error.empty() ? nullptr : &*found;
}

// "-2 solved, +3.10 %": queries that are no longer solved, and how much longer plans of the others take.
std::string without(const Results& results, const char* name_of_case, std::string_view row) {
  constexpr double kShown = 0.005;  // percent, the least that is not "same"
  const Measurement* whole = find(results, std::string(name_of_case) + "/everything");
  const Measurement* part = find(results, std::string(name_of_case) + "/" + std::string(row));
  if (!whole || !part) return "";
  const double lost = part->counters.at("solved") - whole->counters.at("solved");
  const double slower = part->counters.at("slower_percent");
  return (lost == 0.0 ? "" : number_text("%+.0f", lost) + " solved, ") +
         (std::abs(slower) < kShown ? "same" : number_text("%+.2f %%", slower));
}

void add_cases(const Results& results, std::string_view name, std::vector<std::string>& cells) {
  for (const char* name_of_case : kCases) cells.push_back(without(results, name_of_case, name));
}

struct MoveText {
  std::string operator()(const DropTurns&) const { return "leave turns out, many at once first"; }
  std::string operator()(const RejoinEnds&) const { return "join start or goal to a later circle"; }
  std::string operator()(const MergeTurns& move) const {
    return std::string("make ") + (move.all ? "all" : "several") + " turns one, tangent to the lines beside them";
  }
  std::string operator()(const WidenTurns&) const { return "make parts of a turn wider, and the ends tighter"; }
  std::string operator()(const InsertWords& move) const {
    return "join places on two lines by Dubins words: lines in " + std::to_string(move.parts) + " parts" +
           (move.near_ends.empty() ? "" : ", and places near their ends");
  }
  std::string operator()(const SlideCircles& move) const {
    return "slide centers and radii in " + std::to_string(move.steps.size()) + " directions, by steps that are halved";
  }
  std::string operator()(const OptimizeTurns& move) const {
    return "drive each turn in " + std::to_string(move.effort.parts) + " arcs and optimize all at once, by at most " +
           std::to_string(move.effort.iterations) + " Newton steps; where turns are the faster the wider they are";
  }
};

struct GearMoveText {
  std::string operator()(const InsertGearWords& move) const {
    return "join places by words of Reeds and Shepp of " + std::to_string(move.radii.size()) +
           " radii, Dubins words and biarcs";
  }
  std::string operator()(const RefineRuns&) const { return "refine what lies between as if it were driven forwards"; }
  std::string operator()(const OptimizeTurns&) const {
    return "optimize all turns at once, and with them the poses where the gear changes";
  }
  std::string operator()(const SlideCusps&) const { return "move and turn the pose of each, by steps that are halved"; }
  std::string operator()(const DropGearChanges& move) const {
    return "leave out what lies between two, and push " + std::to_string(move.runs_beside) +
           " parts on either side free and to the goal by least squares";
  }
};

std::string gear_text_of(Stage stage) {
  switch (stage) {
    case Stage::kFinish:
      return "once, last";
    case Stage::kEscape:
      return "at the end, and on the path before refinement; if it helps, from the first move on";
    default:
      return "each once, in rounds";
  }
}

std::string text_of(Stage stage) {
  switch (stage) {
    case Stage::kSimplify:
      return "as long as one helps";
    case Stage::kSlide:
    case Stage::kImprove:
      return "each once; if one helps, from the first move on";
    case Stage::kOptimize:
      return "after " + std::to_string(kTrialsBefore) + " trials of the moves above; if it helps, this is the end";
    case Stage::kOptimizeAtLength:
      return "for the best path, in " + std::to_string(kMostRounds) + " rounds";
    case Stage::kSettle:
      return "once, then it is a local optimum";
    case Stage::kEscape:
      return "if it helps, from the first move on";
    case Stage::kFinish:
      return "once, last";
  }
  return "";
}

}  // namespace

Section strategy_section(const Results& results) {
  Section section{
      .title = "What a query tries, and what each row brings",
      .paragraphs = {},
      .figures = {},
      .table = {{"row", "taken when", "what it does", "without it: one radius", "several radii", "both gears"}, {}, 3}};
  for (const StrategyRow& row : kStrategy) {
    std::vector<std::string> cells = {std::string(row.name), internal::text_of(row.when), internal::text_of(row.step)};
    add_cases(results, row.name, cells);
    section.table.rows.push_back(std::move(cells));
  }
  return section;
}

Section moves_section(const Results& results) {
  Section section{
      .title = "How refinement changes a path, and what each move brings",
      .paragraphs = {},
      .figures = {},
      .table = {{"move", "taken", "what it does", "without it: one radius", "several radii", "both gears"}, {}, 3}};
  for (const MoveRow& row : kMoves) {
    std::vector<std::string> cells = {std::string(row.name), text_of(row.stage), std::visit(MoveText{}, row.move)};
    add_cases(results, row.name, cells);
    section.table.rows.push_back(std::move(cells));
  }
  return section;
}

Section gear_moves_section(const Results& results) {
  Section section{.title = "How refinement changes a path in both gears, and what each move brings",
                  .paragraphs = {},
                  .figures = {},
                  .table = {{"move", "taken", "what it does", "without it: both gears"}, {}, 3}};
  for (const GearMoveRow& row : kGearMoves)
    section.table.rows.push_back({std::string(row.name), gear_text_of(row.stage), std::visit(GearMoveText{}, row.move),
                                  without(results, "both gears", row.name)});
  return section;
}

}  // namespace arcway::internal::report
