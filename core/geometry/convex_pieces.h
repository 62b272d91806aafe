#pragma once

#include <span>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal {

/// Splits a simple ring into convex polygons without new vertices. It cuts along diagonals from reflex vertices: those
/// that leave no reflex angle at both of their ends first, then the shortest. Exact. O(n^4), for rings of some tens of
/// vertices.
/// @param ring  counter-clockwise, of >= 3 vertices; it may not touch itself.
/// @return counter-clockwise, without vertices on the line through their neighbors.
std::vector<Ring> convex_pieces(const Ring& ring);

/// The ring without vertices on the line through their neighbors. Exact.
Ring without_straight_corners(const Ring& ring);

/// Whether two convex polygons, counter-clockwise, have an inner point in common. Exact. O(n m).
bool interiors_meet(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace arcway::internal
