#include "core/base/paged_array.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace arcway::internal {
namespace {

struct Element {
  std::uint64_t value = 7;
  friend bool operator==(const Element&, const Element&) = default;
};

TEST(PagedArray, TakesMemoryWhereItIsWritten) {
  PagedArray<Element> array;
  array.make_room(100'000);
  EXPECT_EQ(array.find(0), nullptr);
  array[99'999].value = 1;
  array[5000].value = 2;
  EXPECT_EQ(array.find(0), nullptr);
  ASSERT_NE(array.find(99'999), nullptr);
  EXPECT_EQ(array.find(99'999)->value, 1u);
  EXPECT_EQ(array.find(5000)->value, 2u);
  ASSERT_NE(array.find(5001), nullptr);
  EXPECT_EQ(*array.find(5001), Element());
}

TEST(PagedArray, KeepsWhatIsThereAndClearsAll) {
  PagedArray<Element> array;
  array.make_room(10);
  array[9].value = 3;
  array.make_room(2000);
  array.make_room(10);
  EXPECT_EQ(array.find(9)->value, 3u);
  array.warm_up(5000);
  EXPECT_EQ(array.find(9)->value, 3u);
  for (std::size_t i = 10; i < 5000; ++i) ASSERT_EQ(*array.find(i), Element());
  array[4999].value = 4;
  array.clear();
  for (std::size_t i = 0; i < 5000; ++i) ASSERT_EQ(*array.find(i), Element());
}

}  // namespace
}  // namespace arcway::internal
