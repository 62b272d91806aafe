#include "bench/report/document.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "bench/quantiles.h"
#include "bench/report/citation.h"
#include "bench/report/findings.h"
#include "bench/report/first_page.h"
#include "bench/report/least_queries.h"
#include "bench/report/live_section.h"
#include "bench/report/map_sections.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/report/peer_sections.h"
#include "bench/report/study.h"
#include "bench/report/vehicle_sections.h"
#include "bench/report/words.h"

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

/// "12,345,678", "0.25", "2.3·10^-5"; times with their unit.
std::string counter_text(const std::string& name, double value) {
  if (name.find("_seconds") != std::string::npos) return time_text(value);
  if (value >= 1e5) return count_text(value);
  std::string text = number_text(value != 0.0 && value < 1e-3 ? "%.3g" : "%.5g", value);
  if (const std::size_t e = text.find('e'); e != std::string::npos)
    text = text.substr(0, e) + "·10^" + std::to_string(std::stoi(text.substr(e + 1)));
  return text;
}

/// Counters that at least one of the measurements has.
std::vector<std::string> counter_names(const std::vector<const Measurement*>& measurements) {
  std::set<std::string> names;
  for (const Measurement* m : measurements)
    for (const auto& [name, value] : m->counters) names.insert(name);
  return {names.begin(), names.end()};
}

/// Whether a counter is a quantile over fewer queries than a quantile needs.
bool is_of_few(const Measurement& m, const std::string& counter) {
  const bool is_quantile = counter.ends_with("_median") || counter.find("_p9") != std::string::npos;
  return is_quantile && m.counters.contains("queries") && solved_queries(m) < kLeastQueries;
}

Table measurement_table(const std::vector<const Measurement*>& measurements) {
  const std::vector<std::string> counters = counter_names(measurements);
  Table table{{"benchmark", "time, median", "least – most", "wall clock", "runs"}, {}, 1};
  for (const std::string& name : counters) table.header.push_back(counter_words(name));
  for (const Measurement* m : measurements) {
    const auto [low, high] = std::ranges::minmax(times_of(*m));
    const bool is_noisy = !noise_of(*m).empty();
    std::vector<std::string> row{m->name, marked(time_text(bench::median(times_of(*m))), is_noisy),
                                 time_text(low) + " – " + time_text(high), time_text(bench::median(m->wall_seconds)),
                                 std::to_string(m->wall_seconds.size())};
    for (const std::string& name : counters) {
      const auto found = m->counters.find(name);
      row.push_back(found == m->counters.end() || is_of_few(*m, name) ? "" : counter_text(name, found->second));
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
          {line.series, key_words(study.key), line.law,
           count_text(points.front().size) + " – " + count_text(points.back().size),
           marked(std::to_string(points.size()) + " of " + std::to_string(line.curve.points.size()),
                  points.size() < line.curve.points.size()),
           interval_text(line.curve.fit), interval_text(line.with_log), slopes_text(points)});
    }
  return section;
}

Section study_section(const Study& study) {
  Section section{.title = stage_words(study.stage) + ", by " + key_words(study.key),
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
  section.figures.push_back(
      figure_html({.title = section.title, .x_label = key_words(study.key), .y_label = kTimeLabel}, curves,
                  "Bars: the least and the most of the repetitions."));
  section.table = measurement_table(measurements);
  return section;
}

/// "r.json, commit abc, on AMD EPYC with 2 cores, 2026-11-24"
std::string run_text(const std::string& name, const Context& context) {
  const std::string commit = context_value(context, "commit"), updates = context_value(context, "updated_at");
  const std::string processor = context_value(context, "processor"), cores = context_value(context, "cores");
  const std::string date = context_value(context, "date"), study = context_value(context, "study");
  return name + ", commit " + (commit.empty() ? "unknown" : commit) +
         (updates.empty() ? "" : " with parts of " + updates) + ", on " +
         (processor.empty() ? "an unknown machine" : processor) +
         (cores.empty() ? "" : " with " + cores + (cores == "1" ? " core" : " cores")) +
         (study.empty() ? "" : ", " + study + " study") + (date.empty() ? "" : ", " + date.substr(0, date.find('T')));
}

Section changes_section(const Results& before, const Results& after) {
  Section section{
      .title = "Changes",
      .paragraphs = {"Before: " + run_text(before.name, before.context) + ".",
                     "After: " + run_text(after.name, after.context) + ".",
                     "Significant slowdowns first (p < 0.05, Mann-Whitney on the repetitions), then speedups, then the "
                     "rest. Among a hundred unchanged benchmarks about five look significant. " +
                         mark_meaning()},
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

/// Stages with a section of their own, which has what their measurements count.
constexpr std::string_view kToldStages[] = {"Ablation", "Live", "Quality", "QualityBody", "Radii", "RealMap"};

/// What is no part of a series: a section a stage.
std::vector<Section> single_sections(const Results& results, const std::vector<Study>& studies) {
  std::set<const Measurement*> plotted;
  for (const Study& study : studies)
    for (const Study::Line& line : study.lines) plotted.insert(line.measurements.begin(), line.measurements.end());
  std::map<std::string, std::vector<const Measurement*>> stages;
  for (const Measurement& m : results.measurements) {
    const std::string stage = place_of(m.name).stage;
    if (plotted.contains(&m) || !m.error.empty() || m.wall_seconds.empty()) continue;
    if (std::ranges::find(kToldStages, stage) == std::end(kToldStages)) stages[stage].push_back(&m);
  }
  std::vector<Section> sections;
  for (const auto& [stage, measurements] : stages)
    sections.push_back({.title = stage_words(stage) + ": single measurements",
                        .paragraphs = {},
                        .figures = {},
                        .table = measurement_table(measurements),
                        .folded = true});
  return sections;
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

std::string subtitle_of(const Inputs& inputs) {
  std::string text =
      inputs.before ? "Before: " + run_text(inputs.before->name, inputs.before->context) + ". After: " : "Measured: ";
  text += run_text(inputs.results.name, inputs.results.context) + ".";
  if (inputs.peers) text += " Other planners: " + run_text(inputs.peers->name, inputs.peers->context) + ".";
  return text;
}

void append(std::vector<std::string>& sentences, std::vector<std::string> more) {
  std::ranges::move(more, std::back_inserter(sentences));
}

std::vector<std::string> summary_of(const Inputs& inputs, const std::vector<Study>& studies) {
  std::vector<std::string> summary;
  if (inputs.before)
    summary.push_back(changes_sentence(changes_section(*inputs.before, inputs.results), inputs.before->name));
  if (is_of_own_maps(inputs.results)) {
    append(summary, own_map_findings(inputs.results));
  } else {
    summary.push_back(vehicle_finding(inputs.results));
  }
  append(summary, growth_findings(inputs.results, studies));
  if (inputs.peers) append(summary, peer_findings(*inputs.peers));
  append(summary, run_findings(inputs.results));
  return summary;
}

constexpr std::size_t kPlots = 2;  // on the first page

/// How the stages grow and how planners compare come first.
std::vector<std::string> figures_of(const Inputs& inputs, const std::vector<Study>& studies) {
  std::vector<std::string> growth = growth_figures(studies), figures;
  const bool has_own_maps = is_of_own_maps(inputs.results);
  if (has_own_maps) append(figures, own_map_figures(inputs.results));
  if (!growth.empty()) {
    figures.push_back(std::move(growth.front()));
    growth.erase(growth.begin());
  }
  if (inputs.peers) append(figures, planner_figures(*inputs.peers));
  if (!has_own_maps) append(figures, vehicle_figures(studies));
  append(figures, std::move(growth));
  if (inputs.peers) append(figures, duel_figures(*inputs.peers));
  return figures;
}

Section citation_section(const Results& results) {
  return {.title = "How to cite",
          .paragraphs = {"If arcway helps your work, please cite it, and the paper whose method it builds on."},
          .figures = {},
          .table = {},
          .code = citation(results)};
}

/// A table whose settings and planners are in words; in the READMEs their names are explained beside.
Table in_words(Table table) {
  for (std::size_t column = 0; column < table.header.size(); ++column) {
    const std::string& name = table.header[column];
    if (name != "setting" && name != "planner" && name != "peer") continue;
    for (std::vector<std::string>& row : table.rows)
      row[column] = name == "setting" ? setting_words(row[column]) : planner_words(row[column]);
  }
  return table;
}

/// What is not folded is for everyone, what is folded for who looks for it.
std::vector<Section> sections_of(const Inputs& inputs, const std::vector<Study>& studies) {
  const Results& results = inputs.results;
  std::vector<Section> sections;
  const auto add = [&](Section section, bool folded) {
    section.folded = folded;
    section.table = without_fillers(in_words(std::move(section.table)));
    if (!section.table.rows.empty() || !section.code.empty()) sections.push_back(std::move(section));
  };
  if (inputs.before) add(changes_section(*inputs.before, results), false);
  const bool has_own_maps = is_of_own_maps(results);
  if (has_own_maps) {
    add(own_cost_section(results), false);
    add(own_quality_section(results), false);
  } else {
    add(vehicles_section(results, studies), false);
  }
  add(cost_section(studies), false);
  add(live_section(results), false);
  if (inputs.peers) add(claims_section(*inputs.peers), false);
  add(citation_section(results), false);
  add(quality_section(results), true);
  if (inputs.peers) {
    add(duels_section(*inputs.peers), true);
    add(losses_section(*inputs.peers), true);
    add(planners_section(*inputs.peers), true);
    add(planners_by_world_section(*inputs.peers), true);
  }
  add(ablation_section(results), true);
  add(radii_section(results), true);
  if (!has_own_maps) add(real_maps_section(results), true);
  add(growth_section(studies), true);
  for (const Study& study : studies) add(study_section(study), true);
  for (Section& section : single_sections(results, studies)) add(std::move(section), true);
  add(noise_section(results), true);
  add(missing_section(results), true);
  add(context_section(inputs), true);
  return sections;
}

}  // namespace

Table without_fillers(Table table) {
  const auto is_filler = [&](std::size_t column) {
    return std::ranges::all_of(table.rows, [column](const std::vector<std::string>& row) {
      return column >= row.size() || row[column].empty() || row[column] == "–";
    });
  };
  for (std::size_t column = table.header.size(); column-- > 1;) {
    if (!is_filler(column)) continue;
    const auto erase = [column](std::vector<std::string>& row) {
      if (column < row.size()) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    };
    erase(table.header);
    std::ranges::for_each(table.rows, erase);
    if (column < table.numbers_from) --table.numbers_from;
  }
  return table;
}

Document make_document(const Inputs& inputs) {
  const Results& results = inputs.results;
  const std::vector<Study> studies = studies_of(results);
  Document document{.title = "arcway: the fastest drivable paths among obstacles",
                    .subtitle = subtitle_of(inputs),
                    .lead = lead_paragraph(inputs, studies),
                    .pictures = inputs.pictures,
                    .plots = {},
                    .summary = summary_of(inputs, studies),
                    .figures = figures_of(inputs, studies),
                    .sections = sections_of(inputs, studies)};
  const auto end = document.figures.begin() + static_cast<std::ptrdiff_t>(std::min(kPlots, document.figures.size()));
  document.plots.assign(document.figures.begin(), end);
  document.figures.erase(document.figures.begin(), end);
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
