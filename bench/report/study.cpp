#include "bench/report/study.h"

#include <algorithm>
#include <cmath>

#include "bench/quantiles.h"
#include "bench/report/markup.h"
#include "bench/report/noise.h"
#include "bench/report/words.h"

namespace arcway::internal::report {
namespace {

void finish(Study::Line& line, const std::string& key) {
  std::ranges::stable_sort(line.measurements, {}, [](const Measurement* m) { return place_of(m->name).size; });
  for (const Measurement* m : line.measurements) {
    const std::vector<double>& times = times_of(*m);
    const auto [low, high] = std::ranges::minmax(times);
    line.curve.points.push_back({place_of(m->name).size, bench::median(times), low, high, noise_of(*m)});
    if (line.law.empty()) line.law = m->label;
  }
  line.curve.name = line.variant.empty() ? line.series : line.variant;
  const std::vector<SizePoint> points = fitted_points(line.curve);
  const bool timed = std::ranges::all_of(points, [](const SizePoint& p) { return p.seconds > 0.0; });
  if (points.size() < kLeastFitSizes || !timed || key == "threads") return;
  line.curve.fit = fit_power(points);
  if (points.front().size > 1.0) line.with_log = fit_power_log(points);
}

void compare_variants(const Study& study, std::vector<std::string>& sentences) {
  const Study::Line* best = nullptr;
  double best_size = 0.0;
  for (const Study::Line& line : study.lines) {
    const Curve::Point& last = line.curve.points.back();
    const bool better =
        best == nullptr || last.x > best_size || (last.x == best_size && last.y < best->curve.points.back().y);
    if (better) best = &line, best_size = last.x;
  }
  for (const Study::Line& line : study.lines) {
    if (&line == best) continue;
    const Curve::Point& mine = line.curve.points.back();
    const auto same = std::ranges::find(best->curve.points, mine.x, &Curve::Point::x);
    if (same == best->curve.points.end()) continue;
    const std::string at = " at " + count_text(mine.x) + " (" + key_words(study.key) + ")";
    std::string sentence = stage_words(study.stage) + at + ": " + best->curve.name + " takes " + time_text(same->y) +
                           ", " + line.curve.name + " " + time_text(mine.y);
    if (const double ratio = mine.y / same->y; !(mine.y > 0.0 && same->y > 0.0)) {
      sentence += ".";  // too short for the clock
    } else if (ratio >= 1.0) {
      sentence += ", " + ratio_text(ratio) + " times as long.";
    } else {
      sentence += ", which wins by " + ratio_text(1.0 / ratio) + " times.";
    }
    sentences.push_back(std::move(sentence));
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

const Study::Line* find_line(const std::vector<Study>& studies, std::string_view series, std::string_view key) {
  for (const Study& study : studies) {
    if (study.key != key) continue;
    const auto line = std::ranges::find(study.lines, series, &Study::Line::series);
    if (line != study.lines.end()) return &*line;
  }
  return nullptr;
}

std::optional<double> time_at(const Study::Line& line, double size) {
  const auto point = std::ranges::find(line.curve.points, size, &Curve::Point::x);
  return point == line.curve.points.end() ? std::nullopt : std::optional(point->y);
}

std::string marked_time_at(const Study::Line& line, double size) {
  const auto point = std::ranges::find(line.curve.points, size, &Curve::Point::x);
  return point == line.curve.points.end() ? "–" : marked(time_text(point->y), !point->noise.empty());
}

std::vector<std::string> sentences_of(const Study& study) {
  std::vector<std::string> sentences;
  for (const Study::Line& line : study.lines) {
    if (!line.curve.fit) continue;
    const std::vector<SizePoint> points = fitted_points(line.curve);
    sentences.push_back(line.series + ": the time grows like " + power_text("n", line.curve.fit) + " from " +
                        count_text(points.front().size) + " to " + count_text(points.back().size) + " (" +
                        key_words(study.key) + "), where it is " + time_text(points.back().seconds) + ".");
  }
  compare_variants(study, sentences);
  return sentences;
}

std::string interval_text(const std::optional<PowerFit>& fit) {
  if (!fit) return "–";
  return number_text("%.2f", fit->exponent) + " (" + number_text("%.2f", fit->low) + " – " +
         number_text("%.2f", fit->high) + ")";
}

std::string power_text(const std::string& base, const std::optional<PowerFit>& fit) {
  return fit ? base + "^" + interval_text(fit) : interval_text(fit);
}

std::vector<Change> changes_between(const Results& before, const Results& after) {
  std::vector<Change> changes;
  for (const Measurement& b : before.measurements) {
    const auto a = std::ranges::find(after.measurements, b.name, &Measurement::name);
    if (a == after.measurements.end() || b.cpu_seconds.empty() || a->cpu_seconds.empty()) continue;
    const std::vector<double>&old_times = times_of(b), &new_times = times_of(*a);
    const Change change{b.name,
                        bench::median(old_times),
                        bench::median(new_times),
                        mann_whitney_p(old_times, new_times),
                        !noise_of(b).empty(),
                        !noise_of(*a).empty()};
    if (change.before > 0.0 && change.after > 0.0) changes.push_back(change);
  }
  const auto rank = [](const Change& c) { return !c.significant() ? 2 : c.ratio() > 1.0 ? 0 : 1; };
  std::ranges::stable_sort(changes, [&](const Change& x, const Change& y) {
    if (rank(x) != rank(y)) return rank(x) < rank(y);
    return std::abs(std::log(x.ratio())) > std::abs(std::log(y.ratio()));
  });
  return changes;
}

}  // namespace arcway::internal::report
