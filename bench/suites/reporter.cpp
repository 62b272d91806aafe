#include "bench/suites/reporter.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/context/context.h"
#include "bench/suites/run_policy.h"

namespace arcway::internal::bench {
namespace {

// Whether and why a benchmark ended itself: Google Benchmark 1.8 renamed both members.
template <class Run>
bool was_skipped(const Run& run) {
  if constexpr (requires { run.error_occurred; }) {
    return run.error_occurred;
  } else {
    return run.skipped != decltype(run.skipped){};
  }
}

template <class Run>
const std::string& skip_message(const Run& run) {
  if constexpr (requires { run.error_message; }) {
    return run.error_message;
  } else {
    return run.skip_message;
  }
}

}  // namespace

Reporter::Reporter(bool shows) : shows_(shows), console_(benchmark::ConsoleReporter::OO_None) {
  json_.SetOutputStream(&text_);
}

bool Reporter::ReportContext(const Context& context) {
  if (shows_) console_.ReportContext(context);
  return json_.ReportContext(context);
}

void Reporter::ReportRuns(const std::vector<Run>& all) {
  // No aggregates: the report makes its own, and those of a counter that is zero are not numbers.
  if (all.front().run_type == Run::RT_Aggregate) return;
  std::vector<Run> runs = all;
  // Repetitions that ended before an interruption are kept.
  std::erase_if(runs, [](const Run& run) { return is_interrupted(skip_message(run)); });
  if (runs.empty()) return;
  // What is left out, or failed in any repetition, says so once and has no times.
  const auto skipped = std::ranges::find_if(runs, was_skipped<Run>);
  const bool ended_early = skipped != runs.end();
  if (ended_early) runs = {*skipped};
  if (!is_left_out(skip_message(runs.front()))) ++(ended_early ? failures_ : successes_);
  if (shows_) console_.ReportRuns(runs);
  json_.ReportRuns(runs);
}

void Reporter::Finalize() {
  if (shows_) console_.Finalize();
  json_.Finalize();
}

std::string Reporter::json() const {
  auto document = nlohmann::ordered_json::parse(text_.str());
  for (const char* key : {"host_name", "executable"}) document["context"].erase(key);
  std::string text = "{\n\"context\": " + document["context"].dump(1) + ",\n\"benchmarks\": [";
  const char* separator = "\n";
  for (auto& run : document["benchmarks"]) {
    for (const char* key : {"family_index", "per_family_instance_index"}) run.erase(key);
    text += separator + run.dump();
    separator = ",\n";
  }
  return text + "\n]\n}\n";
}

void add_context(const std::string& study) {
  for (const auto& [key, value] : machine_and_build()) benchmark::AddCustomContext(key, value);
  benchmark::AddCustomContext("study", study);
  benchmark::AddCustomContext("google_benchmark", ARCWAY_BENCH_GOOGLE);
}

}  // namespace arcway::internal::bench
