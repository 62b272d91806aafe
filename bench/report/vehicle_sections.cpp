#include "bench/report/vehicle_sections.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/report/least_queries.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/robots.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::report {
namespace {

constexpr double kObstacles = 1000.0;  // of 10 vertices each, in the columns of larger maps

/// What one vehicle's benchmarks found, over all of its worlds.
struct VehicleRecord {
  double queries = 0.0, solved = 0.0;
  std::size_t hidden = 0;  // worlds of too few solved queries for medians
  std::vector<double> first_seconds, seconds, late_seconds, first_over_bound, over_bound;
};

void add_counter(const Measurement& m, const std::string& name, std::vector<double>& values) {
  const auto found = m.counters.find(name);
  if (found != m.counters.end() && std::isfinite(found->second)) values.push_back(found->second);
}

/// @param is_of_it  whether the name of a measurement behind its stage is of the vehicle.
template <class IsOfIt>
VehicleRecord record_of(const Results& results, std::string_view stage, const IsOfIt& is_of_it) {
  VehicleRecord record;
  for (const Measurement* m : of_stage(results, stage)) {
    if (!is_of_it(place_of(m->name).variant)) continue;
    std::vector<double> queries, share;
    add_counter(*m, "queries", queries);
    add_counter(*m, "solved_share", share);
    if (queries.empty() || share.empty()) continue;
    record.queries += queries.front();
    record.solved += queries.front() * share.front();
    if (solved_queries(*m) < kLeastQueries) {
      ++record.hidden;
      continue;
    }
    add_counter(*m, "first_path_seconds_median", record.first_seconds);
    add_counter(*m, "plan_seconds_median", record.seconds);
    add_counter(*m, "plan_seconds_p95", record.late_seconds);
    add_counter(*m, "first_over_bound_median", record.first_over_bound);
    add_counter(*m, "time_over_bound_median", record.over_bound);
  }
  return record;
}

/// @param rank  of the vehicle among the real ones; that of the paper's robot is behind them.
VehicleRecord record_of(const Results& results, std::size_t rank) {
  return record_of(results, "Quality", [rank](std::string_view name) { return vehicle_rank(name) == rank; });
}

/// Of a vehicle whose body is no centered rectangle.
VehicleRecord record_of_body(const Results& results, const bench::KeptVehicle& kept) {
  return record_of(results, "QualityBody",
                   [&kept](std::string_view name) { return name.substr(0, name.find('/')) == kept.name; });
}

/// The least and the most of some values.
template <class Text>
std::string range_of(const std::vector<double>& values, const Text& text) {
  if (values.empty()) return "–";
  const auto [low, high] = std::ranges::minmax(values);
  return range_text(low, high, text);
}

std::string over_text(double ratio) { return number_text("%.3f", ratio); }

std::string time_in(const std::vector<Study>& studies, const std::string& series) {
  const Study::Line* line = find_line(studies, series, "obstacles");
  return line == nullptr ? "–" : marked_time_at(*line, kObstacles);
}

/// Series of the plans of a vehicle on prepared maps and on new ones.
struct PlanSeries {
  std::string prepared, first;
};

std::vector<std::string> row_of(const std::string& title, const Vehicle& vehicle, const VehicleRecord& record,
                                const PlanSeries& series, const std::vector<Study>& studies) {
  const VehicleParameters& p = vehicle.parameters();
  const double radius = vehicle.min_turning_radius();
  const double sideways = std::pow(vehicle.turn_speed(radius), 2) / radius;
  return {
      title,
      number_text("%.3g", vehicle.footprint().length()) + " × " + number_text("%.3g", vehicle.footprint().width()) +
          " m",
      number_text("%.3g", radius) + " m",
      number_text("%.3g", p.max_speed) + " m/s",
      number_text("%.2g", p.max_acceleration) + " / " + number_text("%.2g", sideways) + " m/s²",
      number_text("%.3g", bench::world_scale(vehicle)),
      record.queries > 0.0 ? number_text("%.0f", record.solved) + " of " + number_text("%.0f", record.queries) : "–",
      range_of(record.first_seconds, time_text),
      range_of(record.first_over_bound, over_text),
      range_of(record.seconds, time_text),
      range_of(record.late_seconds, time_text),
      range_of(record.over_bound, over_text),
      time_in(studies, series.prepared),
      time_in(studies, series.first)};
}

/// Of all real vehicles; `names` lists those that were measured.
VehicleRecord total_of(const Results& results, std::string& names) {
  VehicleRecord total;
  for (std::size_t rank = 0; rank < bench::real_vehicles().size(); ++rank) {
    const VehicleRecord one = record_of(results, rank);
    if (one.queries > 0.0) names += (names.empty() ? "" : ", ") + std::string(bench::real_vehicles()[rank].what);
    total.queries += one.queries;
    total.solved += one.solved;
    total.first_seconds.insert(total.first_seconds.end(), one.first_seconds.begin(), one.first_seconds.end());
    total.seconds.insert(total.seconds.end(), one.seconds.begin(), one.seconds.end());
    total.over_bound.insert(total.over_bound.end(), one.over_bound.begin(), one.over_bound.end());
  }
  return total;
}

}  // namespace

std::size_t vehicle_rank(std::string_view name) {
  const std::string_view first = name.substr(0, name.find('/'));
  const std::vector<bench::KeptVehicle>& kept = bench::real_vehicles();
  return static_cast<std::size_t>(std::ranges::find(kept, first, &bench::KeptVehicle::name) - kept.begin());
}

std::string vehicle_finding(const Results& results) {
  std::string names;
  const VehicleRecord total = total_of(results, names);
  if (!(total.solved > 0.0))
    return "Real vehicles: not measured in these results. What follows is of the paper's robot, which turns with 5 g.";
  const auto percent = [](double ratio) { return number_text("%.1f", 100.0 * (ratio - 1.0)); };
  return "Real vehicles (" + names + "): " + count_text(total.solved) + " of " + count_text(total.queries) +
         " random queries are solved among 100 obstacles. By vehicle and world, a first path takes " +
         range_of(total.first_seconds, time_text) + " in the median, the plan " + range_of(total.seconds, time_text) +
         "; its travel time is " + range_of(total.over_bound, percent) +
         " % above a lower bound that no path can beat.";
}

std::vector<std::string> vehicle_figures(const std::vector<Study>& studies) {
  struct Figure {
    const char* stage;
    const char* papers;  // the same of the paper's robot
    const char* title;
  };
  constexpr Figure kFigures[] = {
      {"PlanPrepared", "Plan/graph_reused", "A plan on a prepared map, over the number of obstacles"},
      {"PlanFirst", "Plan/lazy", "The first plan on a new map, over the number of obstacles"}};
  std::vector<std::string> figures;
  for (const Figure& figure : kFigures) {
    std::vector<Curve> curves;
    const auto add = [&](const std::string& series, std::string_view name) {
      const Study::Line* line = find_line(studies, series, "obstacles");
      if (line == nullptr) return;
      curves.push_back(line->curve);
      curves.back().name = name;
    };
    for (const bench::KeptVehicle& kept : bench::real_vehicles())
      add(std::string(figure.stage) + "/" + std::string(kept.name), kept.what);
    if (curves.empty()) continue;
    add(figure.papers, "the paper's robot");
    figures.push_back(figure_html(
        {.title = figure.title, .x_label = "number of obstacles, of 10 vertices each", .y_label = kTimeLabel}, curves,
        "Real vehicles in worlds of their size, and the paper's robot where it was measured. Bars: the least and the "
        "most of the repetitions."));
  }
  return figures;
}

Section vehicles_section(const Results& results, const std::vector<Study>& studies) {
  Section section{
      .title = "Real vehicles",
      .paragraphs =
          {"Vehicles of data sheets and standards; `bench/robots.h` names the source of every number. Each drives on "
           "random maps of its own size: those of the paper's robot, scaled by the ratio of the turning circles. "
           "Random "
           "queries among 100 obstacles on a prepared map; of the medians of all maps the least and the most. Bound: "
           "no "
           "path takes less. First path: before it is refined. The last two columns: among 1,000 obstacles of 10 "
           "vertices, which cover 30 % of the map."},
      .figures = {},
      .table = {{"vehicle", "body", "turning radius", "top speed", "acceleration along / sideways", "world ×", "solved",
                 "first path after", "first path / bound", "plan after", "95 % of plans after", "plan / bound",
                 "plan, prepared map of 10,000 vertices", "first plan, new map of 10,000 vertices"},
                {},
                1}};
  const std::vector<bench::KeptVehicle>& kept = bench::real_vehicles();
  std::size_t hidden = 0;
  std::string missing;
  const auto add_row = [&](const std::string& what, const Vehicle& vehicle, const VehicleRecord& record,
                           const PlanSeries& series) {
    hidden += record.hidden;
    std::vector<std::string> row = row_of(what, vehicle, record, series, studies);
    const bool is_measured = record.queries > 0.0 || row.back() != "–" || row[row.size() - 2] != "–";
    if (is_measured) {
      section.table.rows.push_back(std::move(row));
    } else {
      missing += (missing.empty() ? "" : ", ") + what;
    }
  };
  for (std::size_t rank = 0; rank < kept.size(); ++rank) {
    const std::string name(kept[rank].name);
    add_row(std::string(kept[rank].what), kept[rank].vehicle(), record_of(results, rank),
            {"PlanPrepared/" + name, "PlanFirst/" + name});
  }
  for (const bench::KeptVehicle& other : bench::vehicles_of_other_outlines())
    if (const VehicleRecord record = record_of_body(results, other); record.queries > 0.0)
      add_row(std::string(other.what), other.vehicle(), record, {});
  add_row("the paper's robot", Vehicle(), record_of(results, kept.size()), {"Plan/graph_reused", "Plan/lazy"});
  if (!missing.empty()) section.paragraphs.push_back("Not measured in these results: " + missing + ".");
  if (hidden > 0)
    section.paragraphs.push_back(count_text(static_cast<double>(hidden)) + (hidden == 1 ? " world is" : " worlds are") +
                                 " left out of the medians: fewer than " + number_text("%.0f", kLeastQueries) +
                                 " queries are solved there.");
  section.paragraphs.push_back(mark_meaning());
  return section;
}

}  // namespace arcway::internal::report
