#include "bench/report/document.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "bench/quantiles.h"
#include "bench/report/findings.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/report/peer_sections.h"
#include "bench/report/study.h"
#include "bench/report/vehicle_sections.h"

namespace arcway::internal::report {
namespace {

std::string slopes_text(const std::vector<SizePoint>& points) {
  std::string text;
  for (const double slope : neighbor_slopes(points)) text += (text.empty() ? "" : " ") + number_text("%.2f", slope);
  return text;
}

/// A field of a CSV file.
std::string in_quotes(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

std::string counter_text(double value) {
  return value >= 1e5 || (value != 0.0 && value < 1e-3) ? number_text("%.3g", value) : number_text("%.5g", value);
}

/// Counters that at least one of the measurements has.
std::vector<std::string> counter_names(const std::vector<const Measurement*>& measurements) {
  std::set<std::string> names;
  for (const Measurement* m : measurements)
    for (const auto& [name, value] : m->counters) names.insert(name);
  return {names.begin(), names.end()};
}

Table measurement_table(const std::vector<const Measurement*>& measurements) {
  const std::vector<std::string> counters = counter_names(measurements);
  Table table{{"benchmark", "time, median", "least – most", "wall clock", "runs"}, {}, 1};
  table.header.insert(table.header.end(), counters.begin(), counters.end());
  for (const Measurement* m : measurements) {
    const auto [low, high] = std::ranges::minmax(times_of(*m));
    const bool is_noisy = !noise_of(*m).empty();
    std::vector<std::string> row{m->name, marked(time_text(bench::median(times_of(*m))), is_noisy),
                                 time_text(low) + " – " + time_text(high), time_text(bench::median(m->wall_seconds)),
                                 std::to_string(m->wall_seconds.size())};
    for (const std::string& name : counters) {
      const auto found = m->counters.find(name);
      row.push_back(found == m->counters.end() ? "" : counter_text(found->second));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Section growth_section(const std::vector<Study>& studies) {
  Section section{
      .title = "Growth of every series",
      .paragraphs = {"Slope of the logarithm of the median time over the logarithm of the size, with its 95 % "
                     "confidence interval; the same beside a factor log(size), near 1 for n log n; and the "
                     "slopes between neighboring sizes, which show whether there is one law at all."},
      .figures = {},
      .table = {{"series", "over", "theory", "sizes", "how many", "slope", "slope beside log", "between neighbors"},
                {},
                3},
      .folded = true};
  for (const Study& study : studies)
    for (const Study::Line& line : study.lines) {
      if (!line.curve.fit) continue;
      const std::vector<SizePoint> points = fitted_points(line.curve);
      section.table.rows.push_back(
          {line.series, study.key, line.law,
           number_text("%.6g", points.front().size) + " – " + number_text("%.6g", points.back().size),
           marked(std::to_string(points.size()) + " of " + std::to_string(line.curve.points.size()),
                  points.size() < line.curve.points.size()),
           interval_text(line.curve.fit), interval_text(line.with_log), slopes_text(points)});
    }
  return section;
}

Section study_section(const Study& study) {
  Section section{.title = study.stage + " over " + study.key,
                  .paragraphs = sentences_of(study),
                  .figures = {},
                  .table = {},
                  .folded = true};
  std::vector<Curve> curves;
  std::vector<const Measurement*> measurements;
  for (const Study::Line& line : study.lines) {
    curves.push_back(line.curve);
    measurements.insert(measurements.end(), line.measurements.begin(), line.measurements.end());
  }
  section.figures.push_back(figure_html({.title = section.title, .x_label = study.key, .y_label = ""}, curves, ""));
  section.table = measurement_table(measurements);
  return section;
}

Section changes_section(const Results& before, const Results& after) {
  Section section{
      .title = "Changes",
      .paragraphs = {"From " + before.name + " to " + after.name +
                     ". Significant (p < 0.05, Mann-Whitney on the repetitions) slowdowns first, then "
                     "speedups, then the rest. Among a hundred unchanged benchmarks about five look significant."},
      .figures = {},
      .table = {{"benchmark", "ratio", "before", "after", "p", "verdict"}, {}, 1}};
  for (const Change& c : changes_between(before, after))
    section.table.rows.push_back({c.name, marked(number_text("%.3f", c.ratio()), c.noisy_before || c.noisy_after),
                                  marked(time_text(c.before), c.noisy_before),
                                  marked(time_text(c.after), c.noisy_after), number_text("%.3g", c.p),
                                  !c.significant()  ? "no difference shown"
                                  : c.ratio() > 1.0 ? "slower"
                                                    : "faster"});
  return section;
}

std::string changes_sentence(const Section& changes, const std::string& before) {
  const auto count = [&](const char* verdict) {
    return std::to_string(std::ranges::count(changes.table.rows, verdict, [](const auto& row) { return row.back(); }));
  };
  return "Changes: " + count("slower") + " of " + std::to_string(changes.table.rows.size()) +
         " benchmarks are significantly slower than in " + before + ", " + count("faster") + " faster.";
}

Section single_section(const Results& results, const std::vector<Study>& studies) {
  std::set<const Measurement*> plotted;
  for (const Study& study : studies)
    for (const Study::Line& line : study.lines) plotted.insert(line.measurements.begin(), line.measurements.end());
  std::vector<const Measurement*> single;
  for (const Measurement& m : results.measurements)
    if (!plotted.contains(&m) && m.error.empty() && !m.wall_seconds.empty()) single.push_back(&m);
  return {.title = "Single measurements",
          .paragraphs = {},
          .figures = {},
          .table = single.empty() ? Table() : measurement_table(single),
          .folded = true};
}

Section context_section(const Inputs& inputs) {
  Section section{.title = "Machine and build",
                  .paragraphs = {},
                  .figures = {},
                  .table = {{"file", "what", "value"}, {}, 3},
                  .folded = true};
  const auto add = [&](const auto& results) {
    for (const auto& [key, value] : results.context) section.table.rows.push_back({results.name, key, value});
  };
  add(inputs.results);
  if (inputs.before) add(*inputs.before);
  if (inputs.peers) add(*inputs.peers);
  return section;
}

Section noise_section(const Results& results) {
  Section section{.title = "Noisy benchmarks",
                  .paragraphs = {mark_meaning()},
                  .figures = {},
                  .table = {{"benchmark", "why"}, {}, 2},
                  .folded = true};
  for (const Measurement& m : results.measurements)
    if (const std::string noise = noise_of(m); !noise.empty()) section.table.rows.push_back({m.name, noise});
  return section;
}

Section missing_section(const Results& results) {
  Section section{.title = "Failed or left out",
                  .paragraphs = {},
                  .figures = {},
                  .table = {{"benchmark", "why"}, {}, 2},
                  .folded = true};
  for (const Measurement& m : results.measurements)
    if (!m.error.empty()) section.table.rows.push_back({m.name, m.error});
  return section;
}

std::string context_value(const Results& results, const std::string& key) {
  const auto found = std::ranges::find(results.context, key, &std::pair<std::string, std::string>::first);
  return found == results.context.end() ? "unknown" : found->second;
}

void append(std::vector<std::string>& sentences, std::vector<std::string> more) {
  std::ranges::move(more, std::back_inserter(sentences));
}

}  // namespace

Document make_document(const Inputs& inputs) {
  const Results& results = inputs.results;
  const std::vector<Study> studies = studies_of(results);
  Document document;
  document.title = "arcway on " + context_value(results, "processor") + ", commit " + context_value(results, "commit");
  const auto add = [&](Section section) {
    if (!section.table.rows.empty()) document.sections.push_back(std::move(section));
  };
  if (inputs.before) {
    Section changes = changes_section(*inputs.before, results);
    document.summary.push_back(changes_sentence(changes, inputs.before->name));
    add(std::move(changes));
  }
  document.summary.push_back(vehicle_finding(results));
  append(document.summary, growth_findings(results, studies));
  if (inputs.peers) append(document.summary, peer_findings(*inputs.peers));
  append(document.summary, run_findings(results));

  document.figures = vehicle_figures(studies);
  if (inputs.peers) append(document.figures, planner_figures(*inputs.peers));
  append(document.figures, growth_figures(studies));
  if (inputs.peers) append(document.figures, duel_figures(*inputs.peers));

  add(vehicles_section(results, studies));
  if (inputs.peers) add(claims_section(*inputs.peers));
  if (inputs.peers) add(losses_section(*inputs.peers));
  if (inputs.peers) add(planners_section(*inputs.peers));
  add(quality_section(results));
  add(cost_section(studies));
  if (inputs.peers) add(duels_section(*inputs.peers));
  add(ablation_section(results));
  add(radii_section(results));
  add(real_maps_section(results));
  if (inputs.peers) add(planners_by_world_section(*inputs.peers));
  add(growth_section(studies));
  for (const Study& study : studies) add(study_section(study));
  add(single_section(results, studies));
  add(noise_section(results));
  add(missing_section(results));
  add(context_section(inputs));
  return document;
}

std::string to_csv(const Results& results) {
  std::string csv = "name,repetitions,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,noise,error\n";
  for (const Measurement& m : results.measurements) {
    csv += m.name + "," + std::to_string(m.wall_seconds.size());
    if (m.wall_seconds.empty()) {
      csv += ",,,,,," + in_quotes(m.error) + "\n";
      continue;
    }
    const auto [low, high] = std::ranges::minmax(m.wall_seconds);
    for (const double value : {bench::median(m.wall_seconds), low, high, bench::median(m.cpu_seconds)})
      csv += "," + number_text("%.9g", value);
    const std::string noise = noise_of(m);
    csv += "," + (noise.empty() ? "" : in_quotes(noise)) + ",\n";
  }
  return csv;
}

}  // namespace arcway::internal::report
