#pragma once

#include <cstdint>
#include <span>

namespace arcway::internal {

/// A hash of numbers in their order. Each is mixed in by a product, whose high bits are folded into the low ones.
/// O(numbers).
inline std::uint64_t hash_of(std::span<const std::uint64_t> numbers) {
  constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio (Knuth's multiplicative hashing)
  constexpr int kFold = 29;                            // bits
  std::uint64_t hash = 0;
  for (const std::uint64_t number : numbers) {
    hash = (hash ^ number) * kOdd;
    hash ^= hash >> kFold;
  }
  return hash;
}

}  // namespace arcway::internal
