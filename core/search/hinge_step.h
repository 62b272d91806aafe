#pragma once

#include <Eigen/Core>

namespace arcway::internal {

/// Linear residuals of a step, each its value now and its gradient.
struct LinearResiduals {
  Eigen::MatrixXd gradients;  ///< one a row
  Eigen::VectorXd values;
  Eigen::Index equalities;  ///< the last so many count whatever their sign; the others only where they are positive
};

/// Between which values the parts of a step may lie; low <= 0 <= high.
struct StepLimits {
  Eigen::VectorXd low, high;
};

/// The step with the least sum of the squares of the residuals that count after it, plus `damping` times its own
/// square, within limits: Newton's method on the quadratic pieces of that convex function, each step as long as is
/// best. A part that has come to a limit stays there. Up to `most_iterations` solutions of the normal equations.
Eigen::VectorXd hinge_step(const LinearResiduals& residuals, const StepLimits& limits, double damping,
                           int most_iterations);

}  // namespace arcway::internal
