#include "core/refine/banded_ldlt.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// A random symmetric matrix and its entries in a band.
struct BandCase {
  Eigen::MatrixXd dense;
  BandedLdlt banded;
};

// A matrix [H A^T; A 0] whose rows are mixed: every fourth row is an equation, with zeros where it meets equations.
void fill_band_case(test::RandomInputs& random, std::size_t size, std::size_t band, BandCase& result) {
  const auto n = static_cast<Eigen::Index>(size);
  result.dense = Eigen::MatrixXd::Zero(n, n);
  result.banded.reset(size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i >= band ? i - band : 0; j <= i; ++j) {
      const bool is_equation = i % 4 == 3 && j % 4 == 3;
      if (is_equation) continue;
      const double value = random.uniform(-1.0, 1.0) + (i == j ? 3.0 * static_cast<double>(band) : 0.0);
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      result.dense(row, column) += value;
      if (row != column) result.dense(column, row) += value;
      // In two parts, from either triangle.
      result.banded.add(i, j, 0.25 * value);
      result.banded.add(j, i, 0.75 * value);
    }
}

std::size_t negative_eigenvalues(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  return static_cast<std::size_t>((values.array() < 0.0).count());
}

TEST(BandedLdlt, SolvesAsADenseSolverAndCountsNegativeEigenvalues) {
  test::RandomInputs random(1);
  BandCase now;  // keeps its memory from one matrix to the next
  std::size_t most_negative = 0;
  for (int i = 0; i < 300; ++i) {
    const auto size = static_cast<std::size_t>(random.integer(1, 40));
    const auto band = static_cast<std::size_t>(random.integer(3, static_cast<int>(BandedLdlt::kBand)));
    fill_band_case(random, size, band, now);
    ASSERT_EQ(now.banded.size(), size);
    // Of several factors, the last one counts: each begins with the matrix as it was added up.
    for (const double factor : {-2.0 * static_cast<double>(band), 0.0, 0.7}) {
      std::vector<double> diagonal(size), x(size);
      Eigen::MatrixXd dense = now.dense;
      Eigen::VectorXd right(dense.rows());
      for (std::size_t k = 0; k < size; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        diagonal[k] = k % 4 == 3 ? 0.0 : random.uniform(0.0, 1.0);
        dense(row, row) += factor * diagonal[k];
        right[row] = x[k] = random.uniform(-1.0, 1.0);
      }
      const std::size_t negative = negative_eigenvalues(dense);
      most_negative = std::max(most_negative, negative);
      EXPECT_FALSE(now.banded.factorize(diagonal, factor, negative + 1));
      if (negative > 0) {
        EXPECT_FALSE(now.banded.factorize(diagonal, factor, negative - 1));
      }
      ASSERT_TRUE(now.banded.factorize(diagonal, factor, negative)) << "matrix " << i;
      now.banded.solve(x);
      const Eigen::VectorXd exact = dense.partialPivLu().solve(right);
      for (std::size_t k = 0; k < size; ++k)
        ASSERT_NEAR(x[k], exact[static_cast<Eigen::Index>(k)], 1e-9 * (1.0 + exact.cwiseAbs().maxCoeff()))
            << "matrix " << i;
    }
  }
  EXPECT_GE(most_negative, 10u);
}

TEST(BandedLdlt, SolvesForSeveralRightSides) {
  test::RandomInputs random(2);
  BandCase now;
  fill_band_case(random, 20, 4, now);
  const std::vector<double> diagonal(20, 0.0);
  ASSERT_TRUE(now.banded.factorize(diagonal, 1.0, 5));
  for (Eigen::Index column = 0; column < 20; ++column) {
    std::vector<double> x(20, 0.0);
    x[static_cast<std::size_t>(column)] = 1.0;
    now.banded.solve(x);
    const Eigen::VectorXd product = now.dense * Eigen::Map<const Eigen::VectorXd>(x.data(), 20);
    EXPECT_NEAR((product - Eigen::VectorXd::Unit(20, column)).cwiseAbs().maxCoeff(), 0.0, 1e-12);
  }
}

TEST(BandedLdlt, ReportsPivotsThatAreZeroOrNoNumbers) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  BandedLdlt matrix;
  const std::vector<double> ones(3, 1.0);
  for (const double wrong : {0.0, kNan})
    for (std::size_t row = 0; row < 3; ++row) {
      matrix.reset(3);
      for (std::size_t i = 0; i < 3; ++i) matrix.add(i, i, i == row ? wrong : 2.0);
      for (const std::size_t negative : {0u, 1u}) EXPECT_FALSE(matrix.factorize(ones, 0.0, negative));
      EXPECT_EQ(matrix.factorize(ones, 1.0, 0), wrong == 0.0);
    }
  // The second pivot vanishes by the first one alone.
  matrix.reset(2);
  for (const auto& [i, j] : {std::pair(0u, 0u), std::pair(0u, 1u), std::pair(1u, 1u)}) matrix.add(i, j, 1.0);
  EXPECT_FALSE(matrix.factorize(std::vector(2, 1.0), 0.0, 0));
  EXPECT_TRUE(matrix.factorize(std::vector(2, 1.0), 1e-3, 0));
}

}  // namespace
}  // namespace arcway::internal
