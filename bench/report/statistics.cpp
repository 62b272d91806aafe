#include "bench/report/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace arcway::internal::report {
namespace {

/// Two-sided 95 % quantile of Student's t.
double t_quantile(std::size_t freedom) {
  constexpr std::array<double, 30> kTable = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                             2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                             2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  return freedom <= kTable.size() ? kTable[freedom - 1] : 1.96;
}

PowerFit fit_logarithms(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0.0)) throw std::invalid_argument("fit: all sizes are equal");
  PowerFit fit;
  fit.exponent = xy / xx;
  const double offset = mean_y - fit.exponent * mean_x;
  fit.factor = std::exp(offset);
  double residual = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - offset - fit.exponent * x[i];
    residual += off * off;
  }
  const double spread = t_quantile(x.size() - 2) * std::sqrt(residual / (n - 2.0) / xx);
  fit.low = fit.exponent - spread;
  fit.high = fit.exponent + spread;
  return fit;
}

void require_points(std::span<const SizePoint> points, double least_size) {
  if (points.size() < kLeastFitSizes)
    throw std::invalid_argument("fit: " + std::to_string(points.size()) + " sizes, needs " +
                                std::to_string(kLeastFitSizes));
  for (const SizePoint& p : points)
    if (!(p.size > least_size) || !(p.seconds > 0.0))
      throw std::invalid_argument("fit: size " + std::to_string(p.size) + " with time " + std::to_string(p.seconds));
}

}  // namespace

PowerFit fit_power(std::span<const SizePoint> points) {
  require_points(points, 0.0);
  std::vector<double> x, y;
  for (const SizePoint& p : points) {
    x.push_back(std::log(p.size));
    y.push_back(std::log(p.seconds));
  }
  return fit_logarithms(x, y);
}

PowerFit fit_power_log(std::span<const SizePoint> points) {
  require_points(points, 1.0);
  std::vector<double> x, y;
  for (const SizePoint& p : points) {
    x.push_back(std::log(p.size));
    y.push_back(std::log(p.seconds / std::log(p.size)));
  }
  return fit_logarithms(x, y);
}

std::vector<double> neighbor_slopes(std::span<const SizePoint> points) {
  std::vector<double> slopes;
  for (std::size_t i = 1; i < points.size(); ++i)
    slopes.push_back(std::log(points[i].seconds / points[i - 1].seconds) /
                     std::log(points[i].size / points[i - 1].size));
  return slopes;
}

double mann_whitney_p(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return 1.0;
  double u = 0.0;
  for (const double x : a)
    for (const double y : b) u += x > y ? 1.0 : x == y ? 0.5 : 0.0;
  const auto m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double away = std::abs(u - 0.5 * m * n);
  if (a.size() > 20 || b.size() > 20) {
    const double deviation = std::sqrt(m * n * (m + n + 1.0) / 12.0);
    return std::erfc(std::max(0.0, away - 0.5) / deviation / std::sqrt(2.0));
  }
  // counts[i][k]: ways in which i of the first values, with any number of second ones passed, give U = k.
  const std::size_t most = a.size() * b.size();
  std::vector<std::vector<double>> counts(a.size() + 1, std::vector<double>(most + 1, 0.0));
  counts[0][0] = 1.0;
  for (std::size_t below = 0; below <= b.size(); ++below)
    for (std::size_t i = 1; i <= a.size(); ++i)
      for (std::size_t k = below; k <= most; ++k) counts[i][k] += counts[i - 1][k - below];
  double extreme = 0.0, all = 0.0;
  for (std::size_t k = 0; k <= most; ++k) {
    all += counts[a.size()][k];
    if (std::abs(static_cast<double>(k) - 0.5 * m * n) >= away - 1e-9) extreme += counts[a.size()][k];
  }
  return extreme / all;
}

}  // namespace arcway::internal::report
