#include "core/search/hinge_step.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/infinity.h"

namespace arcway::internal {
namespace {

double value_of(const LinearResiduals& residuals, double damping, const Eigen::VectorXd& step) {
  const Eigen::VectorXd then = residuals.values + residuals.gradients * step;
  const Eigen::Index free = then.size() - residuals.equalities;
  return then.head(free).cwiseMax(0.0).squaredNorm() + then.tail(residuals.equalities).squaredNorm() +
         damping * step.squaredNorm();
}

StepLimits no_limits(Eigen::Index n) {
  return {Eigen::VectorXd::Constant(n, -kInfinity), Eigen::VectorXd::Constant(n, kInfinity)};
}

TEST(HingeStep, EndsEqualitiesAndPositiveValues) {
  LinearResiduals residuals{Eigen::MatrixXd(3, 2), Eigen::VectorXd(3), 1};
  residuals.gradients << 1.0, 0.0, -1.0, 0.0, 0.0, 1.0;
  residuals.values << 0.5, -2.0, 3.0;  // x <= -0.5, x >= -2, y = -3
  const Eigen::VectorXd step = hinge_step(residuals, no_limits(2), 1e-12, 20);
  EXPECT_NEAR(step(0), -0.5, 1e-9);
  EXPECT_NEAR(step(1), -3.0, 1e-9);
}

TEST(HingeStep, KeepsTheLimits) {
  LinearResiduals residuals{Eigen::MatrixXd(1, 2), Eigen::VectorXd(1), 0};
  residuals.gradients << 1.0, 1.0;
  residuals.values << 2.0;
  StepLimits limits = no_limits(2);
  limits.low(0) = -0.25;
  const Eigen::VectorXd step = hinge_step(residuals, limits, 1e-9, 20);
  EXPECT_DOUBLE_EQ(step(0), -0.25);
  EXPECT_NEAR(step(1), -1.75, 1e-6);
}

// No step near the one found costs less, whichever residuals count there.
TEST(HingeStep, IsTheLeast) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    LinearResiduals residuals{Eigen::MatrixXd(30, 6), Eigen::VectorXd(30), 2};
    for (Eigen::Index r = 0; r < 30; ++r) {
      residuals.values(r) = normal(random);
      for (Eigen::Index i = 0; i < 6; ++i) residuals.gradients(r, i) = normal(random);
    }
    StepLimits limits = no_limits(6);
    for (Eigen::Index i = 0; i < 6; i += 2) limits.low(i) = -0.05, limits.high(i) = 0.05;
    const double damping = 1e-3;
    const Eigen::VectorXd step = hinge_step(residuals, limits, damping, 100);
    const double least = value_of(residuals, damping, step);
    EXPECT_LT(least, value_of(residuals, damping, Eigen::VectorXd::Zero(6)));
    for (Eigen::Index i = 0; i < 6; ++i) {
      EXPECT_GE(step(i), limits.low(i) - 1e-12);
      EXPECT_LE(step(i), limits.high(i) + 1e-12);
      for (const double change : {-1e-3, 1e-3}) {
        Eigen::VectorXd other = step;
        other(i) += change;
        if (limits.high(i) < 1.0) continue;  // a component at its limit stays there
        EXPECT_GE(value_of(residuals, damping, other), least) << trial << " part " << i;
      }
    }
  }
}

}  // namespace
}  // namespace arcway::internal
