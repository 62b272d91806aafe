// The entry of libFuzzer. ARCWAY_FUZZ_TARGET names one of the targets.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const arcway::test::FuzzTarget target = [] {
    for (const arcway::test::FuzzTarget& candidate : arcway::test::fuzz_targets())
      if (candidate.name == ARCWAY_FUZZ_TARGET) return candidate;
    __builtin_trap();
  }();
  arcway::test::run_fuzz_target(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
