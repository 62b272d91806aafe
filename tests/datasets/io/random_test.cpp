#include "datasets/io/random.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"

namespace arcway::internal {
namespace {

TEST(Random, IsTheSameEverywhere) {
  // splitmix64 and xoshiro256** as published.
  Random random(0);
  EXPECT_EQ(random.next(), 0x99EC5F36CB75F2B4u);
  EXPECT_EQ(random.next(), 0xBF6E1F784956452Au);
  EXPECT_EQ(random.next(), 0x1A5F849D4933E6E0u);
}

TEST(Random, UnitVectorsAgreeWithTheLibrary) {
  for (int i = 0; i <= 1000; ++i) {
    const double turns = i / 1000.0;
    EXPECT_NEAR((unit_vector_at(turns) - direction_of(kTwoPi * turns)).norm(), 0.0, 1e-15) << turns;
  }
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_NEAR(random.unit_vector().norm(), 1.0, 1e-15);
    EXPECT_LT(random.below(7), 7u);
  }
}

}  // namespace
}  // namespace arcway::internal
