#include "bench/suites/run_policy.h"

#include <cctype>
#include <cstdio>

namespace arcway::internal::bench {
namespace {

constexpr std::string_view kPrefix = "left out: ";
constexpr std::string_view kLeastTime = "--benchmark_min_time=";
constexpr const char* kInterrupted = "interrupted";

bool takes_units() {
  int major = 0, minor = 0;
  return std::sscanf(ARCWAY_BENCH_GOOGLE, "%d.%d", &major, &minor) == 2 && (major > 1 || minor >= 8);
}

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
      return {with_unit("--benchmark_min_time=0")};
    case Study::kQuick:
      return {with_unit("--benchmark_min_time=0.02"), "--benchmark_repetitions=3"};
    case Study::kFull:
      return {with_unit("--benchmark_min_time=0.1"), "--benchmark_repetitions=5"};
  }
  return {};
}

std::string with_unit(std::string argument) {
  const bool has_none = argument.starts_with(kLeastTime) && std::isdigit(static_cast<unsigned char>(argument.back()));
  return has_none && takes_units() ? argument + "s" : argument;
}

void leave_out(benchmark::State& state, std::string_view reason) {
  state.SkipWithError((std::string(kPrefix) + std::string(reason)).c_str());
}

void skip_for_budget(benchmark::State& state, double expected_seconds, double budget_seconds) {
  char text[128];
  std::snprintf(text, sizeof text, "about %.*f s expected, the budget is %.3g s", expected_seconds < 10.0 ? 1 : 0,
                expected_seconds, budget_seconds);
  leave_out(state, text);
}

void interrupt(benchmark::State& state) { leave_out(state, kInterrupted); }

bool is_interrupted(std::string_view message) { return is_left_out(message) && message.ends_with(kInterrupted); }

bool is_left_out(std::string_view message) { return message.starts_with(kPrefix); }

}  // namespace arcway::internal::bench
