#include "accel/base/shared_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

std::vector<std::uint32_t> numbers_of(const SharedTable& table, std::uint32_t key) {
  std::vector<std::uint32_t> numbers;
  for (const SharedTable::Item& item : table.of(key)) numbers.push_back(item.number);
  return numbers;
}

TEST(MarkedNumbers, AreASetOfThoseMarked) {
  test::RandomInputs random(3);
  MarkedNumbers marked;
  std::set<std::uint32_t> expected;
  for (int i = 0; i < 500; ++i) {
    const auto n = static_cast<std::uint32_t>(random.integer(0, 30000));
    marked.mark(n);
    expected.insert(n);
  }
  EXPECT_EQ(marked.all(), std::vector<std::uint32_t>(expected.begin(), expected.end()));
  for (std::uint32_t n = 0; n < 40000; ++n) ASSERT_EQ(marked.has(n), expected.contains(n)) << n;
}

TEST(MarkedNumbers, OfACopyAreItsOwn) {
  MarkedNumbers first;
  first.mark(5);
  first.mark(9000);
  MarkedNumbers second = first;
  second.mark(6);
  first.mark(7);
  EXPECT_EQ(first.all(), (std::vector<std::uint32_t>{5, 7, 9000}));
  EXPECT_EQ(second.all(), (std::vector<std::uint32_t>{5, 6, 9000}));
}

TEST(MarkedNumbers, TakeThoseOfAnotherSet) {
  MarkedNumbers first, second;
  first.mark(1);
  first.mark(20000);
  second.mark(2);
  second.mark(70000);
  first.mark_all_of(second);
  EXPECT_EQ(first.all(), (std::vector<std::uint32_t>{1, 2, 20000, 70000}));
  first.mark(70001);  // on a page that both have
  EXPECT_EQ(second.all(), (std::vector<std::uint32_t>{2, 70000}));
}

TEST(SharedTable, HasTheNumbersThatWereAddedAndNotRemoved) {
  test::RandomInputs random(4);
  SharedTable table;
  std::map<std::uint32_t, std::set<std::uint32_t>> expected;
  for (int i = 0; i < 2000; ++i) {
    const auto key = static_cast<std::uint32_t>(random.integer(0, 40) * 700);
    const auto number = static_cast<std::uint32_t>(random.integer(0, 5));
    if (expected[key].insert(number).second) {
      table.add(key, number);
    } else {
      table.remove(key, number);
      expected[key].erase(number);
    }
  }
  for (const auto& [key, numbers] : expected)
    EXPECT_EQ(numbers_of(table, key), std::vector<std::uint32_t>(numbers.begin(), numbers.end())) << key;
  EXPECT_TRUE(table.of(1).empty());
  EXPECT_TRUE(table.of(4'000'000'000u).empty());
}

TEST(SharedTable, OfACopyIsItsOwn) {
  SharedTable first;
  first.add(3, 1);
  SharedTable second = first;
  second.remove(3, 1);
  second.add(3, 2);
  EXPECT_EQ(numbers_of(first, 3), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(numbers_of(second, 3), (std::vector<std::uint32_t>{2}));
}

}  // namespace
}  // namespace arcway::internal
