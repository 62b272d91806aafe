#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <vector>

#include "bench/suites/suite.h"

namespace arcway::internal::bench {

/// Longest single iteration of one size of a series, with its world and its check, processor time [s].
double size_budget(Study study);

/// Google Benchmark's arguments for a study: repetitions, and how long each is to take.
std::vector<std::string> benchmark_arguments(Study study);

/// An argument of Google Benchmark as the version at hand wants it: from 1.8 on, `--benchmark_min_time=0.02` has a
/// unit.
std::string with_unit(std::string argument);

/// Marks a benchmark as left out, which is no error.
void leave_out(benchmark::State& state, std::string_view reason);
/// Marks a benchmark as left out because it would take too long.
void skip_for_budget(benchmark::State& state, double expected_seconds, double budget_seconds);

/// Ends a repetition at a stop request: its run is in no results.
void interrupt(benchmark::State& state);
/// Whether an error message is that of interrupt.
bool is_interrupted(std::string_view message);

/// Whether an error message is that of leave_out.
bool is_left_out(std::string_view message);

}  // namespace arcway::internal::bench
