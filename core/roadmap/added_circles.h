#pragma once

#include <vector>

#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// A straight way through a gap, driven in one direction. A path comes onto it by an entry circle and leaves it by an
/// exit circle, which go round no vertex. Each knows one or two convex vertices beside it: straights between it and
/// other circles are looked for where those vertices are seen.
struct GapStraight {
  std::vector<TurnCircle> entries;
  std::vector<TurnCircle> exits;
};

/// Circles beside the base ones, for narrow places.
struct AddedCircles {
  std::vector<TurnCircle> around_vertices;  ///< a vertex each, but not on its bisector, or wider; directed to the left
  std::vector<GapStraight> gap_straights;
};

}  // namespace arcway::internal
