#pragma once

#include <span>
#include <string_view>

namespace arcway::internal::test {

/// A reader fed with any bytes. It returns, or throws what its header says; both are fine. Everything else that comes
/// out of it, be it another exception, is a bug.
struct FuzzTarget {
  std::string_view name;
  void (*read)(std::string_view bytes);
};

/// One for each reader.
std::span<const FuzzTarget> fuzz_targets();

/// Feeds the bytes to the target and swallows what it may throw.
void run_fuzz_target(const FuzzTarget& target, std::string_view bytes);

}  // namespace arcway::internal::test
