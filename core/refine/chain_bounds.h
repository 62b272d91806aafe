#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/model/side_radii.h"
#include "core/refine/chain_terms.h"

namespace arcway::internal {

/// What must not be negative at one arc or line, whatever the obstacles. All are lengths [m], but for turns [rad].
enum class Limit : std::uint8_t {
  kTurn,         ///< the turn on an arc
  kTightest,     ///< the radius of an arc, less the smallest one
  kWidest,       ///< the radius of full speed, less that of an arc; for an arc that began above it, the reverse
  kEntry,        ///< the radius of an arc, less that which its speed at the beginning needs
  kExit,         ///< the radius of an arc, less that which its speed at the end needs
  kSpeedUp,      ///< the length of an arc, less that in which the vehicle gains speed from beginning to end
  kBrake,        ///< the length of an arc, less that in which the vehicle loses speed from beginning to end
  kLineLength,   ///< the length of a line
  kLineSpeedUp,  ///< the length of a line, less that in which the vehicle gains speed from beginning to end
  kLineBrake     ///< the length of a line, less that in which the vehicle loses speed from beginning to end
};
struct Bound {
  Limit limit;
  std::uint32_t index;  ///< of the arc or line
  bool is_slow;         ///< whether it belongs to an arc on which the vehicle is slower than on lines
  [[nodiscard]] bool is_of_line() const { return limit >= Limit::kLineLength; }
};

/// All bounds of a chain.
void find_bounds(const ArcChain& chain, const GearSpeeds& speeds, std::vector<Bound>& bounds);

/// The value and the gradient of a bound. It has no second derivatives but those of the length of an arc, see
/// length_curvature, and of the speed on it, see speed_curvature.
struct BoundValue {
  double value;
  Term::Gradient gradient;
};
BoundValue value_of(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds, const SideRadii& tightest);

/// The second derivatives of the length of an arc.
Term::Hessian length_curvature(const ArcChain& chain, std::size_t arc);
/// The second derivative of kEntry and kExit of an arc by its radius.
double speed_curvature(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds);

}  // namespace arcway::internal
