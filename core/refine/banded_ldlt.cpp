#include "core/refine/banded_ldlt.h"

#include <Eigen/Core>
#include <algorithm>

namespace arcway::internal {

namespace {

using Column = Eigen::Map<Eigen::ArrayXd>;

Column column(double* first, std::size_t size) { return {first, static_cast<Eigen::Index>(size)}; }

}  // namespace

void BandedLdlt::reset(std::size_t size, std::size_t band) {
  size_ = size;
  width_ = band + 1;
  matrix_.assign(size * width_, 0.0);
  factors_.resize(matrix_.size());
}

bool BandedLdlt::factorize(std::span<const double> diagonal, double factor, std::size_t negative) {
  std::copy(matrix_.begin(), matrix_.end(), factors_.begin());
  for (std::size_t i = 0; i < size_; ++i) factors_[i * width_] += factor * diagonal[i];
  std::size_t found = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    double* const first = &factors_[j * width_];
    const double pivot = first[0];
    if (!(pivot > 0.0 || pivot < 0.0)) return false;
    if (pivot < 0.0 && ++found > negative) return false;
    const std::size_t rows = std::min(width_, size_ - j);
    for (std::size_t m = 1; m < rows; ++m) {
      if (first[m] == 0.0) continue;
      column(&factors_[(j + m) * width_], rows - m) -= first[m] / pivot * column(first + m, rows - m);
    }
    if (rows > 1) column(first + 1, rows - 1) /= pivot;
  }
  return found == negative;
}

void BandedLdlt::solve(std::span<double> x) const {
  for (std::size_t j = 0; j < size_; ++j) {
    const double* const first = &factors_[j * width_];
    const std::size_t rows = std::min(width_, size_ - j);
    for (std::size_t m = 1; m < rows; ++m) x[j + m] -= first[m] * x[j];
  }
  for (std::size_t j = size_; j-- > 0;) {
    const double* const first = &factors_[j * width_];
    const std::size_t rows = std::min(width_, size_ - j);
    x[j] /= first[0];
    for (std::size_t m = 1; m < rows; ++m) x[j] -= first[m] * x[j + m];
  }
}

}  // namespace arcway::internal
