#include "core/refine/banded_ldlt.h"

#include <algorithm>

namespace arcway::internal {

namespace {

using Index = std::size_t;

// Subtracts `factor` times the entries from row kFrom on from a later column, as far as the band reaches. The number of
// entries is known to the compiler, which unrolls the loop.
template <Index kFrom, Index kWidth>
void eliminate(const double* __restrict column, double* __restrict later, double factor) {
  for (Index k = 0; k < kWidth - kFrom; ++k) later[k] -= factor * column[kFrom + k];
}

}  // namespace

void BandedLdlt::reset(std::size_t size) {
  size_ = size;
  // Columns of zeros behind the last one keep loops over whole columns in bounds.
  matrix_.assign((size + kBand) * kWidth, 0.0);
  factors_.resize(matrix_.size());
}

template <std::size_t... kRows>
void BandedLdlt::eliminate_by(double* first, std::index_sequence<kRows...>) {
  const double pivot = first[0];
  const auto row = [&]<Index kRow>() {
    if (first[kRow] != 0.0) eliminate<kRow, kWidth>(first, first + kRow * kWidth, first[kRow] / pivot);
  };
  (row.template operator()<kRows + 1>(), ...);
}

bool BandedLdlt::factorize(std::span<const double> diagonal, double factor, std::size_t negative) {
  std::copy(matrix_.begin(), matrix_.end(), factors_.begin());
  for (Index i = 0; i < size_; ++i) factors_[i * kWidth] += factor * diagonal[i];
  Index found = 0;
  for (Index j = 0; j < size_; ++j) {
    double* const first = &factors_[j * kWidth];
    const double pivot = first[0];
    if (!(pivot > 0.0 || pivot < 0.0)) return false;
    if (pivot < 0.0 && ++found > negative) return false;
    eliminate_by(first, std::make_index_sequence<kBand>());
    const double inverse = 1.0 / pivot;
    for (Index m = 1; m < kWidth; ++m) first[m] *= inverse;
  }
  return found == negative;
}

void BandedLdlt::solve(std::span<double> x) {
  solution_.assign(size_ + kBand, 0.0);
  std::copy(x.begin(), x.end(), solution_.begin());
  double* const y = solution_.data();
  for (Index j = 0; j < size_; ++j) {
    const double* const first = &factors_[j * kWidth];
    for (Index m = 1; m < kWidth; ++m) y[j + m] -= first[m] * y[j];
  }
  std::fill(solution_.begin() + static_cast<std::ptrdiff_t>(size_), solution_.end(), 0.0);
  for (Index j = size_; j-- > 0;) {
    const double* const first = &factors_[j * kWidth];
    // Two sums that do not wait for each other.
    double even = 0.0, odd = 0.0;
    for (Index m = 1; m < kWidth; m += 2) {
      odd += first[m] * y[j + m];
      even += first[m + 1] * y[j + m + 1];
    }
    y[j] = y[j] / first[0] - (odd + even);
  }
  std::copy_n(y, size_, x.begin());
}

}  // namespace arcway::internal
