#include "bench/report/document.h"

#include <algorithm>
#include <set>

#include "bench/report/markup.h"
#include "bench/report/study.h"

namespace arcway::report {
namespace {

std::string interval_text(const std::optional<PowerFit>& fit) {
  if (!fit) return "–";
  return number_text("%.2f", fit->exponent) + " (" + number_text("%.2f", fit->low) + " – " +
         number_text("%.2f", fit->high) + ")";
}

std::string slopes_text(const Curve& curve) {
  std::vector<SizePoint> points;
  for (const Curve::Point& p : curve.points) points.push_back({p.size, p.seconds});
  std::string text;
  for (const double slope : neighbour_slopes(points)) text += (text.empty() ? "" : " ") + number_text("%.2f", slope);
  return text;
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
  Table table{{"benchmark", "wall, median", "min – max", "processor", "runs"}, {}, 1};
  table.header.insert(table.header.end(), counters.begin(), counters.end());
  for (const Measurement* m : measurements) {
    const auto [low, high] = std::ranges::minmax(m->wall_seconds);
    std::vector<std::string> row{m->name, time_text(median(m->wall_seconds)), time_text(low) + " – " + time_text(high),
                                 time_text(median(m->cpu_seconds)), std::to_string(m->wall_seconds.size())};
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
      .title = "Growth",
      .paragraphs = {"Slope of the logarithm of the median time over the logarithm of the size, with its 95 % "
                     "confidence interval; the same beside a factor log(size), near 1 for n log n; and the "
                     "slopes between neighbouring sizes, which show whether there is one law at all."},
      .figure = {},
      .table = {{"series", "over", "theory", "sizes", "slope", "slope beside log", "between neighbours"}, {}, 3}};
  for (const Study& study : studies)
    for (const Study::Line& line : study.lines) {
      if (!line.curve.fit) continue;
      const auto& points = line.curve.points;
      section.table.rows.push_back(
          {line.series, study.key, line.law,
           number_text("%.6g", points.front().size) + " – " + number_text("%.6g", points.back().size),
           interval_text(line.curve.fit), interval_text(line.with_log), slopes_text(line.curve)});
    }
  return section;
}

Section study_section(const Study& study) {
  Section section{.title = study.stage + " over " + study.key, .paragraphs = {}, .figure = {}, .table = {}};
  std::vector<Curve> curves;
  std::vector<const Measurement*> measurements;
  std::string legend = "<ul class=\"legend\">";
  for (std::size_t i = 0; i < study.lines.size(); ++i) {
    const Study::Line& line = study.lines[i];
    curves.push_back(line.curve);
    measurements.insert(measurements.end(), line.measurements.begin(), line.measurements.end());
    legend += "<li>" + legend_key(i) + " " + escaped(line.curve.name) +
              (line.curve.fit ? ": slope " + escaped(interval_text(line.curve.fit)) : "") + "</li>";
  }
  section.figure = "<figure>" + plot_svg(section.title, study.key, curves) + legend + "</ul></figure>";
  section.table = measurement_table(measurements);
  return section;
}

Section changes_section(const Results& before, const Results& after) {
  Section section{
      .title = "Changes",
      .paragraphs = {"From " + before.name + " to " + after.name +
                     ". Significant (p < 0.05, Mann-Whitney on the repetitions) slowdowns first, then "
                     "speedups, then the rest. Among a hundred unchanged benchmarks about five look significant."},
      .figure = {},
      .table = {{"benchmark", "ratio", "before", "after", "p", "verdict"}, {}, 1}};
  for (const Change& c : changes_between(before, after))
    section.table.rows.push_back({c.name, number_text("%.3f", c.ratio()), time_text(c.before), time_text(c.after),
                                  number_text("%.3g", c.p),
                                  !c.significant()  ? "no difference shown"
                                  : c.ratio() > 1.0 ? "slower"
                                                    : "faster"});
  return section;
}

Section context_section(const Results& results) {
  Section section{
      .title = "Machine and build", .paragraphs = {}, .figure = {}, .table = {{"what", results.name}, {}, 2}};
  for (const auto& [key, value] : results.context) section.table.rows.push_back({key, value});
  return section;
}

Section missing_section(const Results& results) {
  Section section{.title = "Without times", .paragraphs = {}, .figure = {}, .table = {{"benchmark", "why"}, {}, 2}};
  for (const Measurement& m : results.measurements)
    if (!m.error.empty()) section.table.rows.push_back({m.name, m.error});
  return section;
}

std::string context_value(const Results& results, const std::string& key) {
  const auto found = std::ranges::find(results.context, key, &std::pair<std::string, std::string>::first);
  return found == results.context.end() ? "unknown" : found->second;
}

}  // namespace

Document make_document(const std::vector<Results>& all) {
  const Results& results = all.back();
  const std::vector<Study> studies = studies_of(results);
  Document document;
  document.title = "arcway on " + context_value(results, "processor") + ", commit " + context_value(results, "commit");
  document.summary = summary_of(results, studies);
  if (all.size() == 2) {
    const Section changes = changes_section(all.front(), results);
    const auto slower =
        std::ranges::count_if(changes.table.rows, [](const auto& row) { return row.back() == "slower"; });
    const auto faster =
        std::ranges::count_if(changes.table.rows, [](const auto& row) { return row.back() == "faster"; });
    document.summary.insert(document.summary.begin(),
                            std::to_string(slower) + " of " + std::to_string(changes.table.rows.size()) +
                                " benchmarks are significantly slower than in " + all.front().name + ", " +
                                std::to_string(faster) + " faster.");
    document.sections.push_back(changes);
  }
  document.sections.push_back(growth_section(studies));
  for (const Study& study : studies) document.sections.push_back(study_section(study));
  const std::vector<const Measurement*> single = single_measurements(results);
  if (!single.empty())
    document.sections.push_back(
        {.title = "Single measurements", .paragraphs = {}, .figure = {}, .table = measurement_table(single)});
  if (const Section missing = missing_section(results); !missing.table.rows.empty())
    document.sections.push_back(missing);
  document.sections.push_back(context_section(results));
  document.sections.push_back(
      {.title = "What these numbers do not show",
       .paragraphs =
           {"Slopes hold for the sizes measured and for generated clutter, not for maps of other kinds. Slopes, "
            "ratios and plots use the processor time of all threads, except those over threads, which use wall time; "
            "both are listed. One machine, one build."},
       .figure = {},
       .table = {}});
  return document;
}

std::string to_csv(const Results& results) {
  std::string csv = "name,repetitions,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,error\n";
  for (const Measurement& m : results.measurements) {
    csv += m.name + "," + std::to_string(m.wall_seconds.size());
    if (m.wall_seconds.empty()) {
      csv += ",,,,,\"" + m.error + "\"\n";
      continue;
    }
    const auto [low, high] = std::ranges::minmax(m.wall_seconds);
    for (const double value : {median(m.wall_seconds), low, high, median(m.cpu_seconds)})
      csv += "," + number_text("%.9g", value);
    csv += ",\n";
  }
  return csv;
}

}  // namespace arcway::report
