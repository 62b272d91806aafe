#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report/plot.h"
#include "bench/report/results.h"

namespace arcway::internal::report {

/// The measurements of one plot: a stage over one key, a series for each variant.
struct Study {
  struct Line {
    std::string series, variant, law;
    std::vector<const Measurement*> measurements;  ///< by ascending size
    Curve curve;
    std::optional<PowerFit> with_log;  ///< the fit beside a factor log(size), where all sizes are > 1
  };
  std::string stage, key;
  std::vector<Line> lines;
};

/// Series of at least two sizes, by stage and key. Fits need kLeastFitSizes sizes that are not noisy, times above 0,
/// and another key than "threads".
/// @param results  must outlive the studies.
std::vector<Study> studies_of(const Results& results);

/// The line of a series over a key; null if there is none.
const Study::Line* find_line(const std::vector<Study>& studies, std::string_view series, std::string_view key);
/// The median time at a size [s].
std::optional<double> time_at(const Study::Line& line, double size);
/// The median time at a size as a text, marked if it is noisy; "–" if there is none.
std::string marked_time_at(const Study::Line& line, double size);

/// What one study shows: how each series grows, and how the others compare with the best at the largest size.
std::vector<std::string> sentences_of(const Study& study);

/// "1.07 (1.05 – 1.09)"; "–" without a fit.
std::string interval_text(const std::optional<PowerFit>& fit);
/// "n^1.07 (1.05 – 1.09)"; "–" without a fit. Pages raise what follows the caret.
std::string power_text(const std::string& base, const std::optional<PowerFit>& fit);

/// Two runs of one benchmark.
struct Change {
  std::string name;
  double before = 0.0, after = 0.0;  ///< medians [s]
  double p = 1.0;                    ///< Mann-Whitney
  bool noisy_before = false, noisy_after = false;
  [[nodiscard]] double ratio() const { return after / before; }
  [[nodiscard]] bool significant() const { return p < 0.05; }
};
/// Benchmarks that both runs have with times above 0: first significant regressions, then significant gains, then the
/// rest, each by ratio.
std::vector<Change> changes_between(const Results& before, const Results& after);

}  // namespace arcway::internal::report
