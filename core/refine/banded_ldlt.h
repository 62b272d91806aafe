#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace arcway::internal {

/// A symmetric band matrix, and its factors L D L^T without pivoting. Keeps its memory. The band has a fixed width, so
/// that loops over it have lengths that the compiler knows.
class BandedLdlt {
 public:
  static constexpr std::size_t kBand = 14;  ///< number of diagonals below the main one

  /// A matrix of zeros.
  void reset(std::size_t size);
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Adds to an entry and to its mirror image. Precondition: |i - j| <= kBand.
  void add(std::size_t i, std::size_t j, double value) {
    matrix_[i < j ? i * kWidth + (j - i) : j * kWidth + (i - j)] += value;
  }

  /// Factors the matrix plus `factor` times a diagonal one. O(n kBand^2).
  /// @param negative  number of negative eigenvalues that the sum should have.
  /// @return whether exactly that many pivots are negative, and none is zero or not a number.
  bool factorize(std::span<const double> diagonal, double factor, std::size_t negative);
  /// Solves in place, with the last factors. O(n kBand).
  void solve(std::span<double> x);

 private:
  static constexpr std::size_t kWidth = kBand + 1;

  // Subtracts what the first column owes to the next kBand ones.
  template <std::size_t... kRows>
  static void eliminate_by(double* first, std::index_sequence<kRows...>);

  std::size_t size_ = 0;
  std::vector<double> matrix_, factors_;  // by columns, from the diagonal on
  std::vector<double> solution_;
};

}  // namespace arcway::internal
