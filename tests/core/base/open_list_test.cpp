#include "core/base/open_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace arcway::internal {
namespace {

struct Item {
  int key;
};
bool before(const Item& a, const Item& b) { return a.key < b.key; }

TEST(OpenList, GivesTheLeastFirst) {
  std::mt19937 random(7);
  OpenList<Item> open;
  std::vector<int> expected;  // descending
  for (int round = 0; round < 20000; ++round) {
    if (expected.empty() || random() % 5 < 3) {
      const int key = static_cast<int>(random() % 1000);
      open.push({key});
      expected.insert(std::ranges::upper_bound(expected, key, std::greater<>()), key);
    } else {
      ASSERT_EQ(open.top().key, expected.back());
      ASSERT_EQ(open.pop().key, expected.back());
      expected.pop_back();
    }
    ASSERT_EQ(open.size(), expected.size());
  }
  open.keep_if([](const Item& item) { return item.key % 3 == 0; });
  std::erase_if(expected, [](int key) { return key % 3 != 0; });
  for (; !expected.empty(); expected.pop_back()) ASSERT_EQ(open.pop().key, expected.back());
  EXPECT_TRUE(open.empty());
  open.push({1});
  open.clear();
  EXPECT_TRUE(open.empty());
}

}  // namespace
}  // namespace arcway::internal
