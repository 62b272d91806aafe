#include "bench/suites/work.h"

#include "bench/event_counter.h"
#include "bench/suites/allocations.h"

namespace arcway::internal::bench {
namespace {

/// Of the whole program: made by the first thread before others are there.
const EventCounter instructions(PERF_TYPE_HARDWARE, PERF_COUNT_HW_INSTRUCTIONS);

}  // namespace

LoopWork::LoopWork() : allocations_(heap_use().allocations), instructions_(instructions.value()) {}

void LoopWork::count(benchmark::State& state, const std::string& unit, std::size_t units) const {
  const std::uint64_t allocated = heap_use().allocations - allocations_;
  const std::optional<std::uint64_t> now = instructions.value();
  const auto rounds = static_cast<double>(state.iterations()) * static_cast<double>(units);
  state.counters["allocations_per_" + unit] = static_cast<double>(allocated) / rounds;
  if (now && instructions_)
    state.counters["instructions_per_" + unit] = static_cast<double>(*now - *instructions_) / rounds;
}

}  // namespace arcway::internal::bench
