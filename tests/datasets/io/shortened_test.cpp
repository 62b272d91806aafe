#include "datasets/io/shortened.h"

#include <gtest/gtest.h>

#include <string>

namespace arcway::internal {
namespace {

TEST(Shortened, CutsLongTextsOnly) {
  EXPECT_EQ(shortened(""), "");
  EXPECT_EQ(shortened(std::string(kMostRepeated, 'x')), std::string(kMostRepeated, 'x'));
  EXPECT_EQ(shortened(std::string(kMostRepeated + 1, 'x')), std::string(kMostRepeated, 'x') + "...");
  EXPECT_EQ(shortened("abcdef", 2), "ab...");
}

TEST(Shortened, CutsNoCharacterInTwo) {
  EXPECT_EQ(shortened("a\u00E9\u00E9", 2), "a...");
  EXPECT_EQ(shortened("a\u00E9\u00E9", 3), "a\u00E9...");
  EXPECT_EQ(shortened("\x80\x80\x80", 2), "...");
}

}  // namespace
}  // namespace arcway::internal
