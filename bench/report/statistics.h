#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace arcway::internal::report {

/// A size and the median time at it, both > 0.
struct SizePoint {
  double size;
  double seconds;
};

/// Fewer sizes show no law: the 95 % interval of the exponent is 4.3 standard errors to either side by four of them,
/// and 12.7 by three.
inline constexpr std::size_t kLeastFitSizes = 5;

/// seconds = factor * size^exponent, fitted to the logarithms by least squares.
struct PowerFit {
  double exponent = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % confidence interval of the exponent, by Student's t on the residuals
  double factor = 0.0;
};
/// @throws std::invalid_argument for fewer than kLeastFitSizes sizes, equal sizes only, or values that are not > 0.
PowerFit fit_power(std::span<const SizePoint> points);
/// Fit of seconds = factor * log(size) * size^exponent; the exponent is near 1 for n log n. Sizes > 1.
PowerFit fit_power_log(std::span<const SizePoint> points);

/// Slopes between neighboring sizes, in the logarithms: one fewer than there are points.
std::vector<double> neighbor_slopes(std::span<const SizePoint> points);

/// Two-sided Mann-Whitney test: how likely two samples from one distribution differ at least as much. Exact up to 20
/// values each, ties split in halves; by the normal approximation beyond. 1 if a sample is empty.
double mann_whitney_p(std::span<const double> a, std::span<const double> b);

}  // namespace arcway::internal::report
