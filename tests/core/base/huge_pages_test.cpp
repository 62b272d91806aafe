#include "core/base/huge_pages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>

namespace arcway::internal {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

TEST(HugePages, HoldWhatIsPutThere) {
  for (const std::size_t bytes :
       {std::size_t{8}, kHugePage - 8, kHugePage, kHugePage + 8, 3 * kHugePage, 5 * kHugePage + 16}) {
    HugeVector<std::uint64_t> numbers(bytes / sizeof(std::uint64_t));
    EXPECT_EQ(numbers.front() + numbers.back(), 0u);
    std::iota(numbers.begin(), numbers.end(), std::uint64_t{1});
    const HugeVector<std::uint64_t> copy = numbers;
    EXPECT_EQ(copy.back(), bytes / sizeof(std::uint64_t));
    EXPECT_EQ(copy, numbers);
    const std::uintptr_t alignment = bytes >= kHugePage ? kHugePage : 64;
#ifdef __linux__
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % alignment, 0u);
#else
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % 64, 0u) << alignment;
#endif
  }
}

TEST(HugePages, GrowFromSmallOnes) {
  HugeVector<std::uint32_t> numbers;
  constexpr std::uint32_t kCount = 3'000'000;
  for (std::uint32_t i = 0; i < kCount; ++i) numbers.push_back(i);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(numbers[i], i);
  numbers.resize(10);
  numbers.shrink_to_fit();
  EXPECT_EQ(numbers.back(), 9u);
}

TEST(HugePages, AreNotMoreThanThereAre) {
  HugePageAllocator<std::uint64_t> allocator;
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  for (const std::size_t count : {kMost, kMost / 8, kMost / 8 - kHugePage / 8, kMost / 16})
    EXPECT_THROW((void)allocator.allocate(count), std::bad_alloc) << count;
}

}  // namespace
}  // namespace arcway::internal
