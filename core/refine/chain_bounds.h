#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/refine/chain_terms.h"

namespace arcway::internal {

/// What must not be negative at one arc or line, whatever the obstacles: all are lengths [m] but for turns [rad].
enum class Limit : std::uint8_t {
  kTurn,         ///< of an arc
  kTightest,     ///< its radius, above the smallest
  kWidest,       ///< its radius, below that of full speed; or above it, for an arc that began there
  kEntry,        ///< the radius that its speed at the beginning needs
  kExit,         ///< and at its end
  kSpeedUp,      ///< its length, beyond that for its change of speed
  kBrake,        ///< likewise
  kLineLength,   ///< of a line
  kLineSpeedUp,  ///< its length, beyond that for its change of speed
  kLineBrake     ///< likewise
};
struct Bound {
  Limit limit;
  std::uint32_t index;  ///< of the arc or line
  bool is_slow;         ///< an arc where turns are slower than lines
  [[nodiscard]] bool is_of_line() const { return limit >= Limit::kLineLength; }
};

/// All bounds of a chain.
void find_bounds(const ArcChain& chain, const ChainSpeeds& speeds, std::vector<Bound>& bounds);

/// The value and the gradient of a bound. It has no second derivatives but those of the length of an arc, see
/// length_curvature.
struct BoundValue {
  double value;
  Term::Gradient gradient;
};
BoundValue value_of(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds, double tightest);

/// The second derivatives of the length of an arc.
Term::Hessian length_curvature(const ArcChain& chain, std::size_t arc);

}  // namespace arcway::internal
