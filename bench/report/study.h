#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/report/plot.h"
#include "bench/report/results.h"

namespace arcway::report {

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

/// Series of at least two sizes, by stage and key. Times are wall times for the key "threads" and processor times of
/// all threads otherwise, which a busy machine disturbs less. Fits need three sizes.
/// @param results  must outlive the studies.
std::vector<Study> studies_of(const Results& results);

/// Benchmarks that are in no study.
std::vector<const Measurement*> single_measurements(const Results& results);

/// What grows how, what wins by how much, what fails and what was left out, a sentence each.
std::vector<std::string> summary_of(const Results& results, const std::vector<Study>& studies);

/// Two runs of one benchmark.
struct Change {
  std::string name;
  double before = 0.0, after = 0.0;  ///< medians [s]
  double p = 1.0;                    ///< Mann-Whitney
  [[nodiscard]] double ratio() const { return after / before; }
  [[nodiscard]] bool significant() const { return p < 0.05; }
};
/// Benchmarks that both have, significant regressions first, then significant gains, then the rest; by ratio in each.
std::vector<Change> changes_between(const Results& before, const Results& after);

}  // namespace arcway::report
