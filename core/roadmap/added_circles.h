#pragma once

#include <vector>

#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// A straight motion through a gap in one direction. A path comes onto it by an entry circle and leaves it by an exit
/// circle; neither goes around a vertex. Each circle refers to one or two convex vertices beside it. Bitangents to it
/// are sought from circles that see these vertices.
struct GapStraight {
  std::vector<TurnCircle> entries;
  std::vector<TurnCircle> exits;
};

/// Circles beside the base circles, for narrow gaps.
struct AddedCircles {
  std::vector<TurnCircle> around_vertices;  ///< each around one vertex, off its bisector or wider
  std::vector<GapStraight> gap_straights;
};

}  // namespace arcway::internal
