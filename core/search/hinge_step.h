#pragma once

#include <Eigen/Core>

namespace arcway::internal {

/// Linear residuals of a step: the value of each at the current point, and its gradient.
struct LinearResiduals {
  Eigen::MatrixXd gradients;  ///< one a row
  Eigen::VectorXd values;
  /// Number of residuals, the last ones, that count with either sign; the others count only where positive.
  Eigen::Index equalities = 0;
};

/// Limits of the components of a step: low <= 0 <= high.
struct StepLimits {
  Eigen::VectorXd low, high;
};

/// The step of least cost within limits. The cost is the sum of the squares of the residuals that count after the step,
/// plus `damping` times the step's own square. It is convex and piecewise quadratic; Newton's method with exact line
/// search minimizes it. A component that reaches a limit stays there.
/// @param most_iterations  number of solutions of the normal equations.
Eigen::VectorXd hinge_step(const LinearResiduals& residuals, const StepLimits& limits, double damping,
                           int most_iterations);

}  // namespace arcway::internal
