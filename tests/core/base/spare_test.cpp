#include "core/base/spare.h"

#include <gtest/gtest.h>

#include <memory>

namespace arcway::internal {
namespace {

TEST(Spare, HasTheTwoGivenLast) {
  Spare<int> spare;
  EXPECT_EQ(spare.take(), nullptr);
  for (const int given : {1, 2, 3}) spare.give(std::make_unique<int>(given));
  EXPECT_EQ(*spare.take(), 3);
  EXPECT_EQ(*spare.take(), 2);
  EXPECT_EQ(spare.take(), nullptr);
}

}  // namespace
}  // namespace arcway::internal
