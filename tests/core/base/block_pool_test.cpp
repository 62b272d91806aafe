#include "core/base/block_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace arcway::internal {
namespace {

std::vector<void*> released;
void release(void* memory, std::size_t /*bytes*/) noexcept { released.push_back(memory); }

TEST(BlockPool, GivesTheLatestBlockOfALength) {
  released.clear();
  std::array<int, 4> blocks{};
  BlockPool pool(release);
  EXPECT_EQ(pool.take(100), nullptr);
  pool.add_used(1000);
  for (int& block : blocks) pool.add_used(&block == &blocks[3] ? 50 : 100);
  for (int& block : blocks) pool.give(&block, &block == &blocks[3] ? 50 : 100);
  EXPECT_TRUE(released.empty());
  EXPECT_EQ(pool.take(100), &blocks[2]);
  EXPECT_EQ(pool.take(50), &blocks[3]);
  EXPECT_EQ(pool.take(50), nullptr);
  EXPECT_EQ(pool.take(100), &blocks[1]);
  EXPECT_EQ(pool.take(100), &blocks[0]);
  EXPECT_EQ(pool.take(100), nullptr);
}

TEST(BlockPool, KeepsNoMoreThanIsInUse) {
  released.clear();
  std::array<int, 5> blocks{};
  BlockPool pool(release);
  pool.add_used(500);
  pool.give(&blocks[0], 100);
  pool.give(&blocks[1], 100);
  EXPECT_TRUE(released.empty()) << "200 are kept, 300 in use";
  pool.give(&blocks[2], 100);
  EXPECT_EQ(released, std::vector<void*>{&blocks[0]}) << "200 are in use";
  pool.give(&blocks[3], 100);
  EXPECT_EQ(released.size(), 3u) << "100 are in use";
  pool.give(&blocks[4], 100);
  EXPECT_EQ(released.size(), 5u) << "none is in use";
  EXPECT_EQ(released.back(), &blocks[4]);
}

TEST(BlockPool, KeepsNothingOfAnArrayThatGrows) {
  released.clear();
  std::array<int, 4> blocks{};
  BlockPool pool(release);
  pool.add_used(1000);
  EXPECT_EQ(pool.take(200), nullptr);
  pool.give(&blocks[0], 100);
  EXPECT_EQ(released, std::vector<void*>{&blocks[0]});
  pool.give(&blocks[1], 100);
  EXPECT_EQ(pool.take(301), nullptr);
  pool.give(&blocks[2], 100);
  EXPECT_EQ(pool.take(100), &blocks[2]);
  pool.give(&blocks[3], 100);
  EXPECT_EQ(released.size(), 1u);
}

TEST(BlockPool, KeepsSoManyBlocks) {
  released.clear();
  std::array<int, 1000> blocks{};
  BlockPool pool(release);
  pool.add_used(1'000'000);
  for (int& block : blocks) pool.give(&block, 1);
  ASSERT_EQ(released.size(), 1000u - 256u);
  for (std::size_t i = 0; i < released.size(); ++i) EXPECT_EQ(released[i], &blocks[i]) << "the oldest go first";
}

}  // namespace
}  // namespace arcway::internal
