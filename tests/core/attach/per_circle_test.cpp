#include "core/attach/per_circle.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(PerCircle, KnowsWhatWasSetLast) {
  test::RandomInputs random(5);
  PerCircle indices;
  for (const std::size_t circles : {1u, 512u, 513u, 40u, 5000u}) {
    for (int round = 0; round < 3; ++round) {
      if (round == 1) {
        indices.warm_up(circles);
      } else {
        indices.reset(circles);
      }
      std::map<std::uint32_t, std::uint32_t> expected;
      for (std::uint32_t i = 0; i < 300; ++i) {
        const auto circle = static_cast<std::uint32_t>(random.uniform(0.0, static_cast<double>(circles)));
        indices.prefetch(circle);
        indices.set(circle, i);
        expected[circle] = i;
      }
      for (std::uint32_t c = 0; c < circles; ++c)
        ASSERT_EQ(indices.get(c), expected.contains(c) ? expected[c] : kNone) << c << " of " << circles;
    }
  }
}

}  // namespace
}  // namespace arcway::internal
