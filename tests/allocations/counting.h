#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bench/suites/allocations.h"
#include "core/base/huge_pages.h"

namespace arcway::internal::test {

/// Whether this program counts its memory; a sanitizer's operator new does not.
inline bool counts_memory() {
  const std::uint64_t before = bench::heap_use().allocations;
  const auto memory = std::make_unique<std::vector<int>>(100);
  const HugeVector<int> large(1'000'000);
  return bench::heap_use().allocations >= before + 3 && memory->size() == 100 && large.back() == 0;
}

}  // namespace arcway::internal::test
