#include "core/search/hinge_step.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace arcway::internal {

namespace {

constexpr double kNoRoom = 1e-12;  // distance of a component from its limit that counts as none
constexpr double kNoGain = 1e-8;   // expected gain, as a share of the sum of squares, at which the step is the last one
constexpr int kStepHalvings = 30;  // number of halvings of the range of the best step length

class HingeStep {
 public:
  HingeStep(const LinearResiduals& residuals, const StepLimits& limits, double damping)
      : residuals_(residuals),
        limits_(limits),
        damping_(damping),
        step_(Eigen::VectorXd::Zero(residuals.gradients.cols())),
        then_(residuals.values),
        is_fixed_(static_cast<std::size_t>(step_.size()), 0) {}

  Eigen::VectorXd run(int most_iterations) {
    for (int iteration = 0; iteration < most_iterations && improve(); ++iteration) {
    }
    return step_;
  }

 private:
  struct Direction {
    Eigen::VectorXd step;
    double room;           // the share of the step after which a component comes to its limit, at most 1
    Eigen::Index limited;  // that component; -1: none
  };

  [[nodiscard]] bool counts(Eigen::Index row, double value) const {
    return value > 0.0 || row + residuals_.equalities >= then_.size();
  }

  // False if there is nothing to gain.
  bool improve() {
    add_up();
    const Direction to = direction();
    const Eigen::VectorXd by = residuals_.gradients * to.step;
    const double share = best_share(to, by);
    step_ += share * to.step;
    then_ += share * by;
    if (share == to.room && to.limited >= 0) is_fixed_[static_cast<std::size_t>(to.limited)] = 1;
    return std::abs(gradient_.dot(to.step)) > kNoGain * square_;
  }

  // The normal equations of the residuals that count now.
  void add_up() {
    const Eigen::Index n = step_.size();
    counted_.resize(then_.size(), n);
    Eigen::VectorXd values(then_.size());
    Eigen::Index rows = 0;
    for (Eigen::Index r = 0; r < then_.size(); ++r) {
      if (!counts(r, then_(r))) continue;
      counted_.row(rows) = residuals_.gradients.row(r);
      values(rows++) = then_(r);
    }
    const auto counted = counted_.topRows(rows);
    gradient_ = counted.transpose() * values.head(rows) + damping_ * step_;
    hessian_ = counted.transpose() * counted;
    hessian_.diagonal().array() += damping_;
    square_ = values.head(rows).squaredNorm();
  }

  // The Newton step. Components at a limit that it would cross are fixed.
  Direction direction() {
    while (true) {
      Direction to{newton(), 1.0, -1};
      bool any = false;
      for (Eigen::Index i = 0; i < to.step.size(); ++i) {
        if (is_fixed_[static_cast<std::size_t>(i)] || to.step(i) == 0.0) continue;
        const double room = to.step(i) > 0.0 ? limits_.high(i) - step_(i) : step_(i) - limits_.low(i);
        if (room <= kNoRoom) {
          is_fixed_[static_cast<std::size_t>(i)] = 1;
          any = true;
        } else if (room < to.room * std::abs(to.step(i))) {
          to.room = room / std::abs(to.step(i));
          to.limited = i;
        }
      }
      if (!any) return to;
    }
  }

  [[nodiscard]] Eigen::VectorXd newton() const {
    Eigen::MatrixXd hessian = hessian_;
    Eigen::VectorXd gradient = gradient_;
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      if (!is_fixed_[static_cast<std::size_t>(i)]) continue;
      hessian.row(i).setZero();
      hessian.col(i).setZero();
      hessian(i, i) = 1.0;
      gradient(i) = 0.0;
    }
    return -hessian.ldlt().solve(gradient);
  }

  // The share of a direction that costs least. The slope grows along a direction, so that bisection finds it.
  [[nodiscard]] double best_share(const Direction& to, const Eigen::VectorXd& by) const {
    const auto slope = [&](double share) {
      double sum = damping_ * to.step.dot(step_ + share * to.step);
      for (Eigen::Index r = 0; r < then_.size(); ++r) {
        const double value = then_(r) + share * by(r);
        if (counts(r, value)) sum += value * by(r);
      }
      return sum;
    };
    if (slope(to.room) <= 0.0) return to.room;
    double low = 0.0, high = to.room;
    for (int i = 0; i < kStepHalvings; ++i) (slope(0.5 * (low + high)) > 0.0 ? high : low) = 0.5 * (low + high);
    return low;
  }

  const LinearResiduals& residuals_;
  const StepLimits& limits_;
  double damping_;
  Eigen::VectorXd step_;
  Eigen::VectorXd then_;  // values of the residuals after the step
  std::vector<char> is_fixed_;
  Eigen::MatrixXd counted_, hessian_;
  Eigen::VectorXd gradient_;
  double square_ = 0.0;
};

}  // namespace

Eigen::VectorXd hinge_step(const LinearResiduals& residuals, const StepLimits& limits, double damping,
                           int most_iterations) {
  return HingeStep(residuals, limits, damping).run(most_iterations);
}

}  // namespace arcway::internal
