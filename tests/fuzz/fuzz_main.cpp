// The entry of libFuzzer. ARCWAY_FUZZ_TARGET names one of the targets.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const arcway::internal::test::FuzzTarget target = [] {
    for (const arcway::internal::test::FuzzTarget& candidate : arcway::internal::test::fuzz_targets())
      if (candidate.name == ARCWAY_FUZZ_TARGET) return candidate;
    __builtin_trap();
  }();
  arcway::internal::test::run_fuzz_target(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
