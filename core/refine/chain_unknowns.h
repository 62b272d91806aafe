#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/refine/banded_ldlt.h"
#include "core/refine/chain_terms.h"

namespace arcway::internal {

inline constexpr int kGiven = -1;  ///< the number of what is no unknown

/// The numbers of the unknowns of one arc or one line, by LocalNumber.
using Numbers = std::array<int, kLocalNumbers>;

/// A chain's unknowns, numbered along the path, so that what depends on each other has numbers that differ by at most
/// BandedLdlt::kBand.
/// Beside the numbers of all arcs and lines there are two *tensions* for each line, the multipliers of its equation
///   behind - before - along ahead - offset left = 0.
/// They are the force that pulls at the circles on either side.
class ChainUnknowns {
 public:
  /// Numbers the unknowns of a chain. A tied line has no length, and one speed.
  /// @param tightest  radius of turns [m]: the scale of lengths.
  void number(const ArcChain& chain, double tightest);

  [[nodiscard]] std::size_t size() const { return inverse_squares_.size(); }
  [[nodiscard]] std::size_t equations() const { return 2 * lines_.size(); }
  [[nodiscard]] const Numbers& of_arc(std::size_t i) const { return arcs_[i]; }
  [[nodiscard]] const Numbers& of_line(std::size_t i) const { return lines_[i]; }
  [[nodiscard]] bool is_tension(std::size_t number) const { return inverse_squares_[number] == 0.0; }
  [[nodiscard]] Vec2 tension(std::size_t line, std::span<const double> values) const {
    const auto& [x, y] = tensions_[line];
    return {values[static_cast<std::size_t>(x)], values[static_cast<std::size_t>(y)]};
  }
  void set_tension(std::size_t line, const Vec2& tension, std::span<double> values) const {
    const auto& [x, y] = tensions_[line];
    values[static_cast<std::size_t>(x)] = tension.x();
    values[static_cast<std::size_t>(y)] = tension.y();
  }
  /// 1 / s^2 for each unknown of scale s, 0 for tensions.
  [[nodiscard]] std::span<const double> inverse_squares() const { return inverse_squares_; }

  /// Adds all equations of the chain to a matrix, with the second derivatives by these tensions.
  /// @param stiffness  weight of the equations' squares, which vanish but make the matrix well-conditioned.
  void add_equations(const ArcChain& chain, std::span<const Vec2> tensions, double stiffness, BandedLdlt& matrix) const;

 private:
  std::vector<Numbers> arcs_, lines_;
  std::vector<std::array<int, 2>> tensions_;
  std::vector<double> inverse_squares_;
};

/// Adds the second derivatives of a term to a matrix, times a weight.
void add(const Numbers& numbers, const Term::Hessian& hessian, double weight, BandedLdlt& matrix);
/// Adds a gradient times itself to a matrix, times a weight.
void add_square(const Numbers& numbers, const Term::Gradient& gradient, double weight, BandedLdlt& matrix);
/// Adds a gradient to a vector of all unknowns, times a weight.
void add(const Numbers& numbers, const Term::Gradient& gradient, double weight, std::span<double> to);
/// The change of a term along a step of all unknowns.
double along(const Numbers& numbers, const Term::Gradient& gradient, std::span<const double> step);
/// The part of a step that belongs to an unknown, 0 for what is given.
inline double part_of(std::span<const double> step, int number) {
  return number == kGiven ? 0.0 : step[static_cast<std::size_t>(number)];
}

}  // namespace arcway::internal
