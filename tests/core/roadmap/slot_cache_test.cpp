#include "core/roadmap/slot_cache.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace arcway::internal {
namespace {

// Values in the first and the last slot of chunks and blocks, and beside them.
TEST(SlotCache, KeepsEachValueInItsSlot) {
  const std::vector<std::size_t> slots{0, 1, 63, 64, 4095, 4096, 4159, 8191, 8192, 9999};
  const SlotCache<std::size_t> cache(10'000);
  for (const std::size_t i : slots) {
    EXPECT_EQ(cache.find(i), nullptr);
    EXPECT_EQ(cache.get(i, [&] { return std::make_unique<const std::size_t>(7 * i); }), 7 * i);
    EXPECT_EQ(cache.get(i, [] { return std::make_unique<const std::size_t>(0); }), 7 * i);
  }
  for (const std::size_t i : slots) EXPECT_EQ(*cache.find(i), 7 * i);
  for (const std::size_t i : {std::size_t{2}, std::size_t{65}, std::size_t{4097}, std::size_t{9998}})
    EXPECT_EQ(cache.find(i), nullptr);
  std::vector<std::size_t> visited;
  cache.visit([&](std::size_t i, std::size_t value) {
    EXPECT_EQ(value, 7 * i);
    visited.push_back(i);
  });
  EXPECT_EQ(visited, slots);
}

}  // namespace
}  // namespace arcway::internal
