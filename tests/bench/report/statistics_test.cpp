#include "bench/report/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "bench/quantiles.h"
#include "bench/report/results.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::report {
namespace {

/// Medians of five repetitions with 10 % noise over four decades.
std::vector<SizePoint> noisy_series(std::uint64_t seed, const std::function<double(double)>& law) {
  test::RandomInputs random(seed);
  std::vector<SizePoint> points;
  for (double size = 10.0; size < 2e5; size *= std::sqrt(10.0)) {
    std::vector<double> repetitions;
    for (int i = 0; i < 5; ++i) repetitions.push_back(law(size) * random.uniform(0.9, 1.1));
    points.push_back({size, bench::median(repetitions)});
  }
  return points;
}

using Fit = PowerFit (*)(std::span<const SizePoint>);

/// An interval of 95 % holds the truth in 95 of 100 experiments: of n independent ones in Binomial(n, 0.95), with mean
/// 950 and standard deviation 6.9 for n = 1000. Four deviations to either side, [922, 978], leave out a right interval
/// once in 16,000 times; the seeds are fixed, so that the test passes always or never. An interval of 88 % or of 99 %
/// is out by more than three deviations of its own.
void expect_coverage(double exponent, const std::function<double(double)>& law, Fit fit) {
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const PowerFit result = fit(noisy_series(seed, law));
    EXPECT_NEAR(result.exponent, exponent, 0.05) << "seed " << seed;
    covered += result.low <= exponent && exponent <= result.high;
  }
  EXPECT_GE(covered, 922) << exponent;
  EXPECT_LE(covered, 978) << exponent;
}

TEST(PowerFit, GivesKnownExponentsBackWithinTheirInterval) {
  for (const double exponent : {1.0, 1.5, 2.0})
    expect_coverage(
        exponent, [=](double n) { return 3e-8 * std::pow(n, exponent); }, fit_power);
}

TEST(PowerFit, TellsNLogNFromItsPower) {
  const auto law = [](double n) { return 2e-8 * n * std::log(n); };
  expect_coverage(1.0, law, fit_power_log);
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_GT(fit_power(noisy_series(seed, law)).low, 1.0) << "the bare power hides the logarithm, seed " << seed;
}

TEST(PowerFit, IsExactWithoutNoise) {
  const std::vector<SizePoint> points{{1, 5}, {10, 500}, {100, 5e4}, {1e3, 5e6}, {1e4, 5e8}};
  const PowerFit fit = fit_power(points);
  EXPECT_NEAR(fit.exponent, 2.0, 1e-12);
  EXPECT_NEAR(fit.factor, 5.0, 1e-9);
  EXPECT_NEAR(fit.high - fit.low, 0.0, 1e-6);
  const std::vector<double> slopes = neighbor_slopes(points);
  ASSERT_EQ(slopes.size(), 4u);
  EXPECT_NEAR(slopes[0], 2.0, 1e-12);
}

TEST(PowerFit, RefusesWhatHasNoSlope) {
  EXPECT_THROW((void)fit_power(std::vector<SizePoint>{{1, 1}, {2, 2}, {3, 3}, {4, 4}}), std::invalid_argument)
      << "four sizes";
  EXPECT_THROW((void)fit_power(std::vector<SizePoint>{{1, 1}, {2, 0}, {3, 1}, {4, 1}, {5, 1}}), std::invalid_argument);
  EXPECT_THROW((void)fit_power(std::vector<SizePoint>{{2, 1}, {2, 1}, {2, 1}, {2, 1}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW((void)fit_power_log(std::vector<SizePoint>{{1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}}),
               std::invalid_argument);
}

TEST(MannWhitney, CountsTheOrdersOfSmallSamples) {
  const std::vector<double> low{1, 2, 3, 4, 5}, high{6, 7, 8, 9, 10}, mixed{1, 4, 5, 8, 9}, others{2, 3, 6, 7, 10};
  EXPECT_NEAR(mann_whitney_p(low, high), 2.0 / 252.0, 1e-12);
  EXPECT_NEAR(mann_whitney_p(high, low), 2.0 / 252.0, 1e-12);
  EXPECT_GT(mann_whitney_p(mixed, others), 0.8);
  EXPECT_NEAR(mann_whitney_p(std::vector<double>{1, 2}, std::vector<double>{3, 4}), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(mann_whitney_p({}, low), 1.0);
  EXPECT_EQ(mann_whitney_p(low, low), 1.0);
}

TEST(MannWhitney, ApproximatesLargeSamples) {
  std::vector<double> a, b;
  for (int i = 0; i < 30; ++i) {
    a.push_back(i);
    b.push_back(i + 0.5);
  }
  EXPECT_GT(mann_whitney_p(a, b), 0.5);
  for (double& x : b) x += 20.0;
  EXPECT_LT(mann_whitney_p(a, b), 1e-4);
}

}  // namespace
}  // namespace arcway::internal::report
