#include "bench/report/study.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/report/markup.h"

namespace arcway::report {
namespace {

const std::vector<double>& times_of(const Measurement& m, const std::string& key) {
  return key == "threads" ? m.wall_seconds : m.cpu_seconds;
}

void finish(Study::Line& line, const std::string& key) {
  std::ranges::stable_sort(line.measurements, {}, [](const Measurement* m) { return place_of(m->name).size; });
  std::vector<SizePoint> points;
  for (const Measurement* m : line.measurements) {
    const std::vector<double>& times = times_of(*m, key);
    const auto [low, high] = std::ranges::minmax(times);
    const double size = place_of(m->name).size;
    line.curve.points.push_back({size, median(times), low, high});
    points.push_back({size, median(times)});
    if (line.law.empty()) line.law = m->label;
  }
  line.curve.name = line.variant.empty() ? line.series : line.variant;
  if (points.size() < 3 || key == "threads") return;
  line.curve.fit = fit_power(points);
  if (points.front().size > 1.0) line.with_log = fit_power_log(points);
}

std::string exponent_text(const PowerFit& fit) {
  return number_text("%.2f", fit.exponent) + " (" + number_text("%.2f", fit.low) + " to " +
         number_text("%.2f", fit.high) + ")";
}

void compare_variants(const Study& study, std::vector<std::string>& sentences) {
  const Study::Line* best = nullptr;
  double best_size = 0.0;
  for (const Study::Line& line : study.lines) {
    const Curve::Point& last = line.curve.points.back();
    const bool better = best == nullptr || last.size > best_size ||
                        (last.size == best_size && last.seconds < best->curve.points.back().seconds);
    if (better) best = &line, best_size = last.size;
  }
  for (const Study::Line& line : study.lines) {
    if (&line == best) continue;
    const Curve::Point& mine = line.curve.points.back();
    const auto same = std::ranges::find(best->curve.points, mine.size, &Curve::Point::size);
    if (same == best->curve.points.end()) continue;
    const double ratio = mine.seconds / same->seconds;
    const std::string at = " at " + number_text("%.6g", mine.size) + " " + study.key;
    sentences.push_back(study.stage + at + ": " + best->curve.name + " takes " + time_text(same->seconds) + ", " +
                        line.curve.name + " " + time_text(mine.seconds) + ", " +
                        (ratio >= 1.0 ? number_text("%.3g times as long.", ratio)
                                      : "which wins by " + number_text("%.3g times.", 1.0 / ratio)));
  }
}

}  // namespace

std::vector<Study> studies_of(const Results& results) {
  std::vector<Study> studies;
  for (const Measurement& m : results.measurements) {
    const SeriesPlace place = place_of(m.name);
    if (place.key.empty() || !m.error.empty() || m.wall_seconds.empty() || !(place.size > 0.0)) continue;
    // Fixed parameters in the variant, "embree/n:100", make a study of their own.
    auto study =
        std::ranges::find_if(studies, [&](const Study& s) { return s.stage == place.stage && s.key == place.key; });
    if (study == studies.end()) study = studies.insert(studies.end(), Study{place.stage, place.key, {}});
    auto line = std::ranges::find(study->lines, place.series, &Study::Line::series);
    if (line == study->lines.end())
      line = study->lines.insert(study->lines.end(), Study::Line{place.series, place.variant, {}, {}, {}, {}});
    line->measurements.push_back(&m);
  }
  for (Study& study : studies) {
    std::erase_if(study.lines, [](const Study::Line& line) { return line.measurements.size() < 2; });
    for (Study::Line& line : study.lines) finish(line, study.key);
  }
  std::erase_if(studies, [](const Study& study) { return study.lines.empty(); });
  return studies;
}

std::vector<const Measurement*> single_measurements(const Results& results) {
  std::set<const Measurement*> plotted;
  for (const Study& study : studies_of(results))
    for (const Study::Line& line : study.lines) plotted.insert(line.measurements.begin(), line.measurements.end());
  std::vector<const Measurement*> single;
  for (const Measurement& m : results.measurements)
    if (!plotted.contains(&m) && m.error.empty() && !m.wall_seconds.empty()) single.push_back(&m);
  return single;
}

std::vector<std::string> summary_of(const Results& results, const std::vector<Study>& studies) {
  std::vector<std::string> sentences;
  for (const Study& study : studies) {
    for (const Study::Line& line : study.lines) {
      if (!line.curve.fit) continue;
      const auto& points = line.curve.points;
      sentences.push_back(line.series + ": the time grows like " + study.key + "^" + exponent_text(*line.curve.fit) +
                          " from " + number_text("%.6g", points.front().size) + " to " +
                          number_text("%.6g", points.back().size) + ", where it is " +
                          time_text(points.back().seconds) + ".");
    }
    compare_variants(study, sentences);
  }
  std::size_t failed = 0, left_out = 0;
  for (const Measurement& m : results.measurements) {
    failed += !m.error.empty() && !m.left_out();
    left_out += m.left_out();
  }
  sentences.push_back(failed == 0 ? "No benchmark failed: all answers agreed with the reference before they were timed."
                                  : std::to_string(failed) + " benchmarks failed and have no times; see below.");
  if (left_out > 0)
    sentences.push_back(std::to_string(left_out) + " sizes were left out because they would take too long; see below.");
  return sentences;
}

std::vector<Change> changes_between(const Results& before, const Results& after) {
  std::vector<Change> changes;
  for (const Measurement& b : before.measurements) {
    const auto a = std::ranges::find(after.measurements, b.name, &Measurement::name);
    if (a == after.measurements.end() || b.cpu_seconds.empty() || a->cpu_seconds.empty()) continue;
    const std::string key = place_of(b.name).key;
    const std::vector<double>& old_times = times_of(b, key);
    const std::vector<double>& new_times = times_of(*a, key);
    changes.push_back({b.name, median(old_times), median(new_times), mann_whitney_p(old_times, new_times)});
  }
  const auto rank = [](const Change& c) { return !c.significant() ? 2 : c.ratio() > 1.0 ? 0 : 1; };
  std::ranges::stable_sort(changes, [&](const Change& x, const Change& y) {
    if (rank(x) != rank(y)) return rank(x) < rank(y);
    return std::abs(std::log(x.ratio())) > std::abs(std::log(y.ratio()));
  });
  return changes;
}

}  // namespace arcway::report
