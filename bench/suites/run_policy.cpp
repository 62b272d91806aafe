#include "bench/suites/run_policy.h"

#include <cstdio>

namespace arcway::internal::bench {
namespace {

constexpr std::string_view kPrefix = "left out: ";
constexpr const char* kInterrupted = "interrupted";

}  // namespace

double size_budget(Study study) {
  switch (study) {
    case Study::kCheck:
      return 2.0;
    case Study::kQuick:
      return 2.0;
    case Study::kFull:
      return 20.0;
  }
  return 0.0;
}

std::vector<std::string> benchmark_arguments(Study study) {
  switch (study) {
    case Study::kCheck:
      return {"--benchmark_min_time=0"};
    case Study::kQuick:
      return {"--benchmark_min_time=0.02", "--benchmark_repetitions=3"};
    case Study::kFull:
      return {"--benchmark_min_time=0.1", "--benchmark_repetitions=5"};
  }
  return {};
}

void leave_out(benchmark::State& state, std::string_view reason) {
  state.SkipWithError((std::string(kPrefix) + std::string(reason)).c_str());
}

void skip_for_budget(benchmark::State& state, double expected_seconds, double budget_seconds) {
  char text[128];
  std::snprintf(text, sizeof text, "about %.3g s expected, the budget is %.3g s", expected_seconds, budget_seconds);
  leave_out(state, text);
}

void interrupt(benchmark::State& state) { leave_out(state, kInterrupted); }

bool is_interrupted(std::string_view message) { return is_left_out(message) && message.ends_with(kInterrupted); }

bool is_left_out(std::string_view message) { return message.starts_with(kPrefix); }

}  // namespace arcway::internal::bench
