#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace arcway::internal::bench {

/// What a timed loop takes besides time, which a gate compares between two runs on any machine:
///
///     const LoopWork work;
///     for ([[maybe_unused]] auto _ : state) ask();
///     work.count(state, "question", kQuestions);
///
/// What the first round allocates and later ones keep belongs before the loop: its number of rounds varies.
class LoopWork {
 public:
  LoopWork();

  /// Adds the counters allocations_per_UNIT and, where the machine counts them, instructions_per_UNIT.
  /// @param units  in one round of the loop.
  void count(benchmark::State& state, const std::string& unit, std::size_t units = 1) const;

 private:
  std::uint64_t allocations_;
  std::optional<std::uint64_t> instructions_;
};

}  // namespace arcway::internal::bench
