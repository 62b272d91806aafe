#pragma once

#include <benchmark/benchmark.h>

#include <sstream>
#include <string>
#include <vector>

namespace arcway::internal::bench {

/// Keeps runs as JSON, counts the failures, and shows the runs if asked to.
class Reporter final : public benchmark::BenchmarkReporter {
 public:
  /// @param shows  whether runs are shown on standard output.
  explicit Reporter(bool shows);

  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& all) override;
  void Finalize() override;

  [[nodiscard]] int failures() const { return failures_; }
  [[nodiscard]] int successes() const { return successes_; }
  /// Google Benchmark's file, one line a run, without what names this machine's user (host, path of the program), and
  /// without places in this run, which no longer hold once --update has mixed two. Google's compare.py and Bencher read
  /// it.
  [[nodiscard]] std::string json() const;

 private:
  bool shows_;
  benchmark::ConsoleReporter console_;
  benchmark::JSONReporter json_;
  std::ostringstream text_;
  int failures_ = 0;
  int successes_ = 0;
};

/// Puts machine, build and the name of the study into the context of the results.
void add_context(const std::string& study);

}  // namespace arcway::internal::bench
