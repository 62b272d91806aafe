#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/report/results.h"

namespace arcway::internal::report {

/// What may rise between two runs.
struct GateLimits {
  /// A count fails above old * (1 + counts). Counts hardly vary between equal programs, so that a small share is
  /// enough.
  double counts = 0.05;
  /// A time fails above old * times, by the fastest repetition of each run, if the difference is significant too. What
  /// else a machine does makes repetitions slower, never faster. Of 134 benchmarks of two equal programs that took
  /// turns on a machine with a load of 8 on two cores none failed above 1.1; without turns, 1 and 10 failed above 1.3.
  double times = 1.3;
};

/// A count or a time that rose beyond its limit.
struct Rise {
  std::string benchmark, what;  ///< "ReducedGraph/embree/obstacles:100", "edges"
  double before = 0.0, after = 0.0;
  double p = 0.0;        ///< Mann-Whitney, of times
  bool is_time = false;  ///< `before` and `after` are of the fastest repetitions [s]
};

/// A benchmark, and why it has no times.
struct Absence {
  std::string benchmark, why;
};

/// What a comparison of two runs found.
struct GateFindings {
  std::vector<Rise> rises;       ///< counts first, each by the factor
  std::vector<Absence> failed;   ///< had times, and fail a check now
  std::vector<Absence> missing;  ///< had times or counts, and are not there or left out now
  std::size_t counts = 0;        ///< compared
  std::size_t times = 0;         ///< compared
  std::size_t too_few = 0;       ///< benchmarks with too few repetitions for any difference to be significant
  bool same_processor = true;    ///< otherwise times and instructions are not compared
  [[nodiscard]] bool passed() const { return rises.empty() && failed.empty(); }
};

/// Compares the counts and times of benchmarks that both runs have. Counts are the counters of edges, links,
/// expansions, trials, steps, poses, allocations and instructions. Times are processor times of all threads, which
/// other programs on the machine hardly change.
GateFindings compare_for_gate(const Results& before, const Results& after, const GateLimits& limits);

/// Files, commits and machines; what was compared, by which limits; a table of what rose, in Markdown.
std::string gate_text(const GateFindings& findings, const Results& before, const Results& after,
                      const GateLimits& limits);

}  // namespace arcway::internal::report
