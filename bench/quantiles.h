#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace arcway::internal::bench {

/// Between the two nearest ranks. Precondition: not empty, 0 <= share <= 1.
inline double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace arcway::internal::bench
