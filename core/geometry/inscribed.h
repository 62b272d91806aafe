#pragma once

#include <span>

#include "arcway/vec2.h"

namespace arcway::internal {

struct InscribedDisc {
  Vec2 center;
  double radius;  ///< [m]
};
/// The largest disc in a simple ring, to a thousandth of its radius: boxes are halved, the most promising first
/// [Agafonkin 2016, polylabel]. In rings thinner than a ten thousandth of their length a smaller one may be found.
/// Rounded down: the disc lies inside. O(n) a box.
/// @param ring  counter-clockwise, of >= 3 vertices.
/// @param inside  a point in the ring.
InscribedDisc largest_disc_in(std::span<const Vec2> ring, const Vec2& inside);

/// An axis-parallel box in a simple ring: the largest of those whose lower and upper sides lie at a vertex's height, or
/// at one of some heights between the lowest and the highest. Rounded down: the box lies inside. Empty if rounding
/// leaves none. O(n^3).
/// @param ring  counter-clockwise, of >= 3 vertices.
Box large_box_in(std::span<const Vec2> ring);

}  // namespace arcway::internal
