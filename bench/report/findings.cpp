#include "bench/report/findings.h"

#include <algorithm>
#include <array>
#include <optional>

#include "bench/quantiles.h"
#include "bench/report/least_queries.h"
#include "bench/report/map_sections.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/report/vehicle_sections.h"
#include "bench/robots.h"

namespace arcway::internal::report {
namespace {

/// What planning consists of, by the names of its series over the obstacles.
struct PlanningStage {
  const char* title;
  const char* series;
};
constexpr std::array kPlanningStages = {
    PlanningStage{"Read a map from GeoJSON and check it", "LoadMap/geojson"},
    PlanningStage{"Reduced visibility graph", "ReducedGraph/tangent-cones"},
    PlanningStage{"Feasible graph, all links checked", "FeasibleGraph/embree"},
    PlanningStage{"First plan on a new map, nothing prepared", "Plan/lazy"},
    PlanningStage{"A plan on a prepared map", "Plan/graph_reused"},
    PlanningStage{"Is a line of sight free?", "LinesOfSight/embree"},
    PlanningStage{"Is a swept rectangle free?", "SweptRectangles/embree"},
    PlanningStage{"Free headings on a turn circle", "TurningIntervals/embree"},
};
constexpr double kVerticesEach = 10.0;  // vertices of each obstacle in these series

std::string vertices_text(double obstacles) { return count_text(kVerticesEach * obstacles) + " vertices"; }

/// "0.6 ms at 1,000 vertices and 0.12 s at 100,000 vertices", by the sizes that there are.
std::string times_text(const Study::Line& line) {
  const Curve::Point& last = line.curve.points.back();
  const std::optional<double> first = last.x > 100.0 ? time_at(line, 100.0) : std::nullopt;
  return (first ? time_text(*first) + " at " + vertices_text(100.0) + ", " : "") + time_text(last.y) + " at " +
         vertices_text(last.x);
}

std::string counter_of(const Study::Line& line, const std::string& name, const char* format) {
  const auto& counters = line.measurements.back()->counters;
  const auto found = counters.find(name);
  return found == counters.end() ? "–" : number_text(format, found->second);
}

std::string ends_text(const Study::Line& line) {
  return time_text(line.curve.points.front().y) + " to " + time_text(line.curve.points.back().y);
}

void add_growth_with_obstacles(const std::vector<Study>& studies, std::vector<std::string>& sentences) {
  if (const auto* graph = find_line(studies, "ReducedGraph/tangent-cones", "obstacles"); graph && graph->curve.fit)
    sentences.push_back("Obstacles: to find which corners see each other, the visibility graph, takes a time like " +
                        power_text("n", graph->curve.fit) + " with n obstacles of 10 vertices: " + times_text(*graph) +
                        ".");
  const auto* first = find_line(studies, "Plan/lazy", "obstacles");
  const auto* more = find_line(studies, "Plan/graph_reused", "obstacles");
  if (first && first->curve.fit && more && more->curve.fit)
    sentences.push_back("A plan of the paper's robot: the first on a new map, nothing prepared, takes " +
                        times_text(*first) + ", " + power_text("n", first->curve.fit) + "; each on a prepared map " +
                        times_text(*more) + ", " + power_text("n", more->curve.fit) + ".");
}

void add_growth_with_shape(const std::vector<Study>& studies, std::vector<std::string>& sentences) {
  const auto* cones = find_line(studies, "ReducedGraph/tangent-cones/n:100", "vertices");
  const auto* pairs = find_line(studies, "ReducedGraph/pairwise/n:100", "vertices");
  if (cones && cones->curve.fit) {
    std::string text = "Vertices: with " + number_text("%.0f", cones->curve.points.front().x) + " to " +
                       number_text("%.0f", cones->curve.points.back().x) +
                       " vertices m on each of 100 obstacles the graph's time grows like " +
                       power_text("m", cones->curve.fit) + ", " + ends_text(*cones);
    if (pairs && pairs->curve.fit)
      text += "; by pairs of obstacles, for few of very many vertices, like " + power_text("m", pairs->curve.fit) +
              ", " + ends_text(*pairs);
    sentences.push_back(text + ".");
  }
  const auto* fill = find_line(studies, "ReducedGraph/tangent-cones/n:316", "fill_percent");
  const auto* plan = find_line(studies, "Plan/n:316", "fill_percent");
  if (!fill) return;
  sentences.push_back("Fill: as 316 obstacles cover " + number_text("%.2f", 0.01 * fill->curve.points.front().x) +
                      " to " + number_text("%.2f", 0.01 * fill->curve.points.back().x) +
                      " of the map and hide one another more, the graph takes " + ends_text(*fill) +
                      (plan ? ", a plan " + ends_text(*plan) : "") + ".");
}

/// What the counters say of the largest map.
std::string memory_text(const std::vector<Study>& studies) {
  const auto* graph = find_line(studies, "ReducedGraph/tangent-cones", "obstacles");
  const auto* plan = find_line(studies, "Plan/graph_reused", "obstacles");
  const auto* visible = find_line(studies, "LinesOfSight/embree", "obstacles");
  if (!graph || !plan || !visible) return {};
  return "While the visibility graph is built it takes " + counter_of(*graph, "peak_bytes_per_vertex", "%.0f") +
         " bytes a vertex at the peak. Allocations on the largest map: " +
         counter_of(*plan, "allocations_per_query", "%.0f") + " by a plan on a prepared map, its result included, " +
         counter_of(*visible, "allocations_per_question", "%.3g") + " by a line of sight.";
}

/// The part of a name after the stage.
std::string rest_of(const Measurement& m) { return place_of(m.name).variant; }

/// The measurements of quality, by vehicle: real ones first, the paper's robot last.
std::vector<const Measurement*> quality_of(const Results& results) {
  std::vector<const Measurement*> found = of_stage(results, "Quality");
  std::ranges::stable_sort(found, {}, [](const Measurement* m) { return vehicle_rank(rest_of(*m)); });
  return found;
}

std::string counter_text(const Measurement& m, const std::string& name, const char* format) {
  const auto found = m.counters.find(name);
  return found == m.counters.end() ? "–" : number_text(format, found->second);
}

void add_note(Section& section, const std::string& note) {
  if (!note.empty()) section.paragraphs.push_back(note);
}

std::string seconds_text(const Measurement& m, const std::string& name) {
  const auto found = m.counters.find(name);
  return found == m.counters.end() ? "–" : time_text(found->second);
}

std::string noise_finding(const Results& results) {
  std::size_t timed = 0, noisy = 0, waited = 0;
  for (const Measurement& m : results.measurements) {
    const std::string noise = noise_of(m);
    timed += !m.wall_seconds.empty();
    noisy += !noise.empty();
    waited += noise.starts_with("wall");
  }
  const auto count = [](std::size_t n) { return count_text(static_cast<double>(n)); };
  const std::string limit = number_text("%g", 100.0 * kMostNoise) + " %";
  const std::string text = "Noise: " + (noisy == 0 ? "none" : count(noisy)) + " of " + count(timed) + " benchmarks ";
  if (noisy == 0)
    return text + "differ by more than " + limit + " between repetitions, or between wall and processor time.";
  std::string why;
  if (waited > 0) why = "of " + count(waited) + " the wall time exceeds the processor time by more than " + limit;
  if (noisy > waited)
    why += (why.empty() ? "of " : ", of ") + count(noisy - waited) + " the repetitions differ by more than " + limit;
  return text + "are marked † and left out of fits: " + why + ". \"Noisy benchmarks\" below names them.";
}

}  // namespace

std::vector<std::string> growth_findings(const Results& results, const std::vector<Study>& studies) {
  std::vector<std::string> sentences;
  add_growth_with_obstacles(studies, sentences);
  add_growth_with_shape(studies, sentences);
  double queries = 0.0, solved = 0.0, low = 0.0, high = 0.0;
  for (const Measurement* m : of_stage(results, "Quality")) {
    if (vehicle_rank(rest_of(*m)) < bench::real_vehicles().size()) continue;
    const auto value = [&](const char* name) {
      const auto found = m->counters.find(name);
      return found == m->counters.end() ? 0.0 : found->second;
    };
    queries += value("queries");
    solved += value("queries") * value("solved_share");
    const double gap = value("time_over_bound_median") - 1.0;
    low = low == 0.0 ? gap : std::min(low, gap);
    high = std::max(high, gap);
  }
  if (queries > 0.0)
    sentences.push_back("Quality, the paper's robot: " + count_text(solved) + " of " + count_text(queries) +
                        " random queries are solved, every path valid; by the world, the median travel time is " +
                        range_text(low, high, [](double gap) { return number_text("%.1f", 100.0 * gap); }) +
                        " % above a lower bound that no path can beat.");
  return sentences;
}

std::vector<std::string> run_findings(const Results& results) {
  std::size_t failed = 0, left_out = 0, timed = 0;
  for (const Measurement& m : results.measurements) {
    failed += !m.error.empty() && !m.left_out();
    left_out += m.left_out();
    timed += m.error.empty();
  }
  std::string text =
      failed == 0
          ? "Checks: all " + count_text(static_cast<double>(timed)) + " benchmarks passed theirs, none failed: " +
                (is_of_own_maps(results) ? "the validator takes all paths"
                                         : "answers are the reference's, and the validator takes all paths")
          : "Checks: " + std::to_string(failed) + " benchmarks failed and have no times";
  if (left_out > 0)
    text += "; " + std::to_string(left_out) + " sizes were left out because they take too long, listed below";
  return {text + ".", noise_finding(results)};
}

Section cost_section(const std::vector<Study>& studies) {
  Section section{
      .title = "What it costs",
      .paragraphs =
          {"Maps of n convex obstacles of 10 vertices, which cover 30 % of the map; one thread, medians. Growth: "
           "a power of n, fitted to the medians of all sizes, with its 95 % confidence interval. Graphs and plans "
           "are those of the paper's robot."},
      .figures = {},
      .table = {{"stage", "grows like", "1,000 vertices", "10,000", "100,000", "bytes a vertex"}, {}, 1}};
  for (const PlanningStage& stage : kPlanningStages) {
    const Study::Line* line = find_line(studies, stage.series, "obstacles");
    if (line == nullptr) continue;
    std::vector<std::string> row{stage.title, power_text("n", line->curve.fit)};
    for (const double n : {100.0, 1000.0, 10000.0}) {
      row.push_back(marked_time_at(*line, n));
    }
    row.push_back(counter_of(*line, "bytes_per_vertex", "%.0f"));
    section.table.rows.push_back(std::move(row));
  }
  if (const std::string memory = memory_text(studies); !memory.empty()) section.paragraphs.push_back(memory);
  return section;
}

std::vector<std::string> growth_figures(const std::vector<Study>& studies) {
  std::vector<Curve> stages, builders;
  for (const PlanningStage& stage : kPlanningStages) {
    const Study::Line* line = find_line(studies, stage.series, "obstacles");
    if (line == nullptr || stages.size() == 5) continue;
    stages.push_back(line->curve);
    stages.back().name = stage.title;
  }
  for (const char* builder : {"tangent-cones", "pairwise", "reference"}) {
    const Study::Line* line = find_line(studies, std::string("ReducedGraph/") + builder + "/n:100", "vertices");
    if (line == nullptr) continue;
    builders.push_back(line->curve);
    builders.back().name = builder == std::string("reference") ? "brute force" : builder;
  }
  std::vector<std::string> figures;
  if (!stages.empty())
    figures.push_back(figure_html(
        {.title = "Time of the stages over the number of obstacles",
         .x_label = "number of obstacles, of 10 vertices each",
         .y_label = kTimeLabel},
        stages, "How the time of each stage grows with the map. Bars: the least and the most of the repetitions."));
  if (!builders.empty())
    figures.push_back(figure_html({.title = "Time of the visibility graph over the vertices of each obstacle",
                                   .x_label = "vertices of each of 100 obstacles",
                                   .y_label = kTimeLabel},
                                  builders, "How the three builders of the visibility graph grow with the vertices."));
  return figures;
}

Section quality_section(const Results& results) {
  Section section{
      .title = "Quality of the plans",
      .paragraphs = {"Random queries on maps of 100 obstacles, for the paper's robot unless a vehicle is named. "
                     "Bound: no path takes less. Best known: the graph's best "
                     "path by Dijkstra's search, refined the same way; not searched for real vehicles. First path: "
                     "before refinement. Processor times, median "
                     "over the queries that are solved; the mean over all."},
      .figures = {},
      .table = {{"world", "queries", "solved", "start blocked", "goal blocked", "no path", "first path / bound, median",
                 "after", "refined / bound, median", "after", "time / best known, worst", "smallest clearance",
                 "expansions a query", "time a query, mean"},
                {},
                1}};
  std::size_t hidden = 0;
  for (const Measurement* m : quality_of(results)) {
    if (solved_queries(*m) < kLeastQueries) {
      ++hidden;
      continue;
    }
    section.table.rows.push_back(
        {rest_of(*m), counter_text(*m, "queries", "%.0f"), counter_text(*m, "solved_share", "%.2f"),
         counter_text(*m, "start_blocked", "%.0f"), counter_text(*m, "goal_blocked", "%.0f"),
         counter_text(*m, "no_path", "%.0f"), counter_text(*m, "first_over_bound_median", "%.3f"),
         seconds_text(*m, "first_path_seconds_median"), counter_text(*m, "time_over_bound_median", "%.3f"),
         seconds_text(*m, "plan_seconds_median"), counter_text(*m, "time_over_best_worst", "%.3f"),
         counter_text(*m, "min_clearance_m", "%.4f") + " m", counter_text(*m, "expansions_per_query", "%.0f"),
         marked(time_text(bench::median(times_of(*m))), !noise_of(*m).empty())});
  }
  add_note(section, hidden_rows_text(hidden));
  return section;
}

Section ablation_section(const Results& results) {
  Section section{
      .title = "What each part of the planner brings",
      .paragraphs = {"Median of travel time / lower bound - 1 in percent, over the queries that all variants "
                     "solve; in parentheses how many queries the variant solves. The same queries for all; a "
                     "robot of 2 m/s² sideways and along, for which wider turns are faster ones."},
      .figures = {},
      .table = {{"variant"}, {}, 1}};
  std::vector<std::string>& header = section.table.header;
  std::size_t hidden = 0;
  for (const Measurement* m : of_stage(results, "Ablation")) {
    // All variants of a world are compared over the same queries: its column is shown or not.
    if (const auto compared = m->counters.find("compared");
        compared == m->counters.end() || compared->second < kLeastQueries) {
      ++hidden;
      continue;
    }
    const std::string name = rest_of(*m);
    const std::string world = name.substr(0, name.find('/'));
    const std::string variant = name.substr(std::min(name.size(), name.find('/') + 1));
    auto column = std::ranges::find(header, world);
    if (column == header.end()) column = header.insert(header.end(), world);
    const auto at = static_cast<std::size_t>(column - header.begin());
    auto row = std::ranges::find(section.table.rows, variant, [](const auto& r) { return r.front(); });
    if (row == section.table.rows.end()) row = section.table.rows.insert(row, {variant});
    row->resize(std::max(row->size(), at + 1));
    (*row)[at] = counter_text(*m, "gap_percent_median", "%.2f") + " (" + counter_text(*m, "solved", "%.0f") + ")";
  }
  for (auto& row : section.table.rows) row.resize(header.size());
  if (hidden > 0)
    section.paragraphs.push_back(count_text(static_cast<double>(hidden)) + (hidden == 1 ? " value is" : " values are") +
                                 " not shown: fewer than " + number_text("%.0f", kLeastQueries) +
                                 " queries are solved by all variants there, too few for a median.");
  return section;
}

Section radii_section(const Results& results) {
  Section section{
      .title = "Travel time over the number of radii",
      .paragraphs = {"Robots with limits on their acceleration, sideways and along [m/s²], random queries on maps of "
                     "100 obstacles: travel time over that with circles of the smallest radius only, median and worst. "
                     "Refinement widens turns as well; the last ratio is to a robot that has no use for wide turns, "
                     "graph and refinement both, driven as fast as the first one can."},
      .figures = {},
      .table = {{"robot and world", "radii", "solved", "first path / with one radius", "refined / with one radius",
                 "refined / tightest turns only", "time a query, mean"},
                {},
                1}};
  std::size_t hidden = 0;
  for (const Measurement* m : of_stage(results, "Radii")) {
    if (solved_queries(*m) < kLeastQueries) {
      ++hidden;
      continue;
    }
    const auto ratio = [&](const std::string& name) {
      return counter_text(*m, name + "_median", "%.3f") + " (" + counter_text(*m, name + "_worst", "%.3f") + ")";
    };
    section.table.rows.push_back({rest_of(*m), number_text("%.0f", place_of(m->name).size),
                                  counter_text(*m, "solved", "%.0f"), ratio("first_over_one"),
                                  ratio("refined_over_one"), ratio("refined_over_tightest"),
                                  marked(time_text(bench::median(times_of(*m))), !noise_of(*m).empty())});
  }
  add_note(section, hidden_rows_text(hidden));
  return section;
}

Section real_maps_section(const Results& results) {
  Section section{
      .title = "Real maps",
      .paragraphs =
          {"A grid of random cells, a city and a coast, a vehicle that suits each, random queries that a disc "
           "of the body's width can move between; every path passed the validator. Prepared: all bitangents "
           "checked before; lazy: when a query first asks for them. One thread, processor times of single "
           "runs."},
      .figures = {},
      .table = {{"map", "vertices", "body", "preparing", "queries", "solved", "start or goal blocked", "no path",
                 "time limit", "first query", "median", "99 %"},
                {},
                1}};
  std::size_t hidden = 0;
  for (const Measurement* m : of_stage(results, "RealMap")) {
    if (solved_queries(*m) < kLeastQueries) {
      ++hidden;
      continue;
    }
    const auto count = [&](const std::string& name) {
      const auto found = m->counters.find(name);
      return found == m->counters.end() ? 0.0 : found->second;
    };
    section.table.rows.push_back(
        {rest_of(*m), count_text(count("vertices")), counter_text(*m, "body_length_m", "%.3g") + " m",
         seconds_text(*m, "prepare_seconds"), counter_text(*m, "queries", "%.0f"), counter_text(*m, "solved", "%.0f"),
         number_text("%.0f", count("start_blocked") + count("goal_blocked")), counter_text(*m, "no_path", "%.0f"),
         counter_text(*m, "time_limit", "%.0f"), seconds_text(*m, "first_seconds"),
         seconds_text(*m, "plan_seconds_median"), seconds_text(*m, "plan_seconds_p99")});
  }
  add_note(section, hidden_rows_text(hidden));
  return section;
}

}  // namespace arcway::internal::report
