#include "bench/suites/run_policy.h"

#include <gtest/gtest.h>

#include <string>

namespace arcway::internal::bench {
namespace {

TEST(RunPolicy, GivesUnitsToTimesThatHaveNone) {
  EXPECT_EQ(with_unit("--benchmark_filter=n1"), "--benchmark_filter=n1");
  EXPECT_EQ(with_unit("--benchmark_min_time=2x"), "--benchmark_min_time=2x");
  EXPECT_EQ(with_unit("--benchmark_min_time=0.5s"), "--benchmark_min_time=0.5s");
  const std::string least = with_unit("--benchmark_min_time=0.5");
  EXPECT_TRUE(least == "--benchmark_min_time=0.5" || least == "--benchmark_min_time=0.5s") << least;
  EXPECT_EQ(with_unit(least), least);
}

}  // namespace
}  // namespace arcway::internal::bench
