#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace arcway::internal {

/// A symmetric band matrix, and its factors L D L^T without pivoting. Keeps its memory.
class BandedLdlt {
 public:
  /// A matrix of zeros with `band` diagonals below the main one.
  void reset(std::size_t size, std::size_t band);
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Adds to an entry and to its mirror image. Precondition: |i - j| <= band.
  void add(std::size_t i, std::size_t j, double value) {
    matrix_[i < j ? i * width_ + (j - i) : j * width_ + (i - j)] += value;
  }

  /// Factors the matrix plus `factor` times a diagonal one. O(n band^2).
  /// @param negative  number of negative eigenvalues that the sum should have.
  /// @return whether exactly that many pivots are negative, and none is zero or not a number.
  bool factorize(std::span<const double> diagonal, double factor, std::size_t negative);
  /// Solves in place, with the last factors. O(n band).
  void solve(std::span<double> x) const;

 private:
  std::size_t size_ = 0, width_ = 0;      // width_ is the band plus 1
  std::vector<double> matrix_, factors_;  // by columns, from the diagonal on
};

}  // namespace arcway::internal
