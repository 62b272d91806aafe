#include "bench/report/map_sections.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "bench/quantiles.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"

namespace arcway::internal::report {
namespace {

constexpr const char* kNoValue = "–";
constexpr std::string_view kOn = " on ";

/// A robot on a map, and the benchmark of its plans there.
struct Case {
  std::string robot, map;
  const Measurement* plans;
  [[nodiscard]] std::string name() const { return robot + "/" + map; }
};

std::vector<Case> cases_of(const Results& results) {
  constexpr std::string_view kEnd = "/prepared";
  std::vector<Case> cases;
  for (const Measurement* m : of_stage(results, "RealMap")) {
    std::string name = place_of(m->name).variant;
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos || !name.ends_with(kEnd)) continue;
    name.resize(name.size() - kEnd.size());
    cases.push_back({name.substr(0, slash), name.substr(slash + 1), m});
  }
  return cases;
}

const Measurement* measured(const Results& results, const std::string& name) {
  const auto found = std::ranges::find(results.measurements, name, &Measurement::name);
  return found == results.measurements.end() || found->cpu_seconds.empty() ? nullptr : &*found;
}

std::optional<double> counter_of(const Measurement* m, const std::string& name) {
  if (m == nullptr) return std::nullopt;
  const auto found = m->counters.find(name);
  return found == m->counters.end() ? std::nullopt : std::optional(found->second);
}

std::string value_text(const Measurement* m, const std::string& counter, const char* format) {
  const std::optional<double> value = counter_of(m, counter);
  return value ? number_text(format, *value) : kNoValue;
}

std::string amount_of(const Measurement* m, const std::string& counter) {
  const std::optional<double> value = counter_of(m, counter);
  return value ? count_text(*value) : kNoValue;
}

std::string seconds_of(const Measurement* m, const std::string& counter) {
  const std::optional<double> value = counter_of(m, counter);
  return value ? marked(time_text(*value), !noise_of(*m).empty()) : kNoValue;
}

std::string processor_time(const Measurement* m) {
  return m == nullptr ? kNoValue : marked(time_text(bench::median(m->cpu_seconds)), !noise_of(*m).empty());
}

std::string gap_text(const Measurement* m, const char* counter) {
  const std::optional<double> ratio = counter_of(m, counter);
  return ratio ? number_text("%.1f", 100.0 * (*ratio - 1.0)) + " %" : kNoValue;
}

std::string solved_text(const Measurement* m) {
  const double queries = counter_of(m, "queries").value_or(0.0);
  return count_text(queries * counter_of(m, "solved_share").value_or(0.0)) + " of " + count_text(queries);
}

}  // namespace

bool is_of_own_maps(const Results& results) {
  return std::ranges::find(results.context, std::pair<std::string, std::string>("study", "maps")) !=
         results.context.end();
}

std::string own_setting(const std::string& robot, const std::string& map) { return robot + std::string(kOn) + map; }

bool is_own_setting(const std::string& setting) { return setting.find(kOn) != std::string::npos; }

std::vector<std::string> own_map_findings(const Results& results) {
  std::vector<std::string> sentences;
  for (const Case& c : cases_of(results)) {
    const bool any_solved = counter_of(c.plans, "solved_share").value_or(0.0) > 0.0;
    std::string text = own_setting(c.robot, c.map) + ": " + solved_text(c.plans) + " queries are solved" +
                       (any_solved ? ", and the validator takes every path" : "") +
                       ". On the prepared map a plan takes " + seconds_of(c.plans, "plan_seconds_median") +
                       " in the median";
    if (const Measurement* first = measured(results, "PlanFirst/" + c.name()))
      text += ", from the bare map " + processor_time(first) + " in the mean";
    if (any_solved)
      text += ". Travel times are " + gap_text(c.plans, "time_over_bound_median") +
              " above a lower bound that no path can beat, in the median";
    sentences.push_back(text + ".");
  }
  return sentences;
}

std::vector<std::string> own_map_figures(const Results& results) {
  std::vector<Curve> curves;
  for (const Case& c : cases_of(results)) {
    Curve curve{own_setting(c.robot, c.map), {}, {}};
    for (const auto& [after, ratio] : {std::pair("first_path_seconds_median", "first_over_bound_median"),
                                       {"plan_seconds_median", "time_over_bound_median"}}) {
      const std::optional<double> x = counter_of(c.plans, after), y = counter_of(c.plans, ratio);
      if (x && y && *x > 0.0) curve.points.push_back({*x, *y, *y, *y});
    }
    if (!curve.points.empty()) curves.push_back(std::move(curve));
  }
  if (curves.empty()) return {};
  return {figure_html(
      {.title = "Travel time over the lower bound, over the time to the answer",
       .x_label = "time to the answer, median",
       .y_label = "travel time / lower bound",
       .x_text = time_text,
       .y_text = ratio_text},
      curves,
      "Left is sooner, down is a faster path: from the first path to the plan after refinement. The bound is "
      "that of a point, so that a car cannot reach 1.")};
}

Section own_cost_section(const Results& results) {
  Section section{
      .title = "What planning costs on each map",
      .paragraphs =
          {"Processor time of one thread, medians over the repetitions. Reduced graph: the visibility graph of "
           "the map, the same for all robots. Feasible graph: all bitangents that the robot can drive. Prepared: "
           "both, and what the first query would wait for. First plan: from the bare map, with only what it asks "
           "for; the mean of the first queries. Plan: on the prepared map; the mean of all queries. Search and "
           "refinement are parts of a plan, by the median over the queries that are solved.",
           mark_meaning()},
      .figures = {},
      .table = {{"robot", "map", "vertices", "reduced graph", "edges", "feasible graph", "links", "prepared",
                 "first plan", "plan", "search", "refinement"},
                {},
                2}};
  for (const Case& c : cases_of(results)) {
    const Measurement* reduced = measured(results, "ReducedGraph/" + c.map);
    const Measurement* feasible = measured(results, "FeasibleGraph/" + c.name());
    section.table.rows.push_back(
        {c.robot, c.map, amount_of(c.plans, "vertices"), processor_time(reduced), amount_of(reduced, "edges"),
         processor_time(feasible), amount_of(feasible, "links"), seconds_of(c.plans, "prepare_seconds"),
         processor_time(measured(results, "PlanFirst/" + c.name())), processor_time(c.plans),
         seconds_of(c.plans, "search_seconds_median"), seconds_of(c.plans, "refine_seconds_median")});
  }
  return section;
}

Section own_quality_section(const Results& results) {
  Section section{
      .title = "Quality of the plans on each map",
      .paragraphs =
          {"The validator, which shares no decision with the planner, took every path. Blocked: no motion leads "
           "far from the start or to the goal. Gap: how much longer the travel time is than a lower bound that no "
           "path can beat, in the median over the queries that are solved; of the first path, before refinement, "
           "and of the plan. Times are processor times; median and 99 % are of all queries.",
           mark_meaning()},
      .figures = {},
      .table = {{"robot", "map", "solved", "blocked", "no path", "time limit", "first gap", "after", "gap", "after",
                 "99 %", "clearance", "expansions"},
                {},
                2}};
  for (const Case& c : cases_of(results)) {
    const double blocked =
        counter_of(c.plans, "start_blocked").value_or(0.0) + counter_of(c.plans, "goal_blocked").value_or(0.0);
    const bool has_clearance = counter_of(c.plans, "min_clearance_m").has_value();
    section.table.rows.push_back(
        {c.robot, c.map, solved_text(c.plans), count_text(blocked), amount_of(c.plans, "no_path"),
         amount_of(c.plans, "time_limit"), gap_text(c.plans, "first_over_bound_median"),
         seconds_of(c.plans, "first_path_seconds_median"), gap_text(c.plans, "time_over_bound_median"),
         seconds_of(c.plans, "plan_seconds_median"), seconds_of(c.plans, "plan_seconds_p99"),
         value_text(c.plans, "min_clearance_m", "%.4f") + (has_clearance ? " m" : ""),
         amount_of(c.plans, "expansions_per_query")});
  }
  return section;
}

}  // namespace arcway::internal::report
