#pragma once

#include "arcway/world.h"

namespace arcway::internal {

/// Whether an obstacle edge, or its first vertex, proves that a point of the open segment lies strictly inside the
/// edge's obstacle. Exact. There are three proofs:
/// - a proper crossing;
/// - an end of the segment on the edge, with the other end on the obstacle's side;
/// - the edge's first vertex on the segment, with the segment leading into the obstacle there.
///
/// If a vertex of the same obstacle lies inside the edge, the edge alone proves nothing. The vertex does if the segment
/// leads both into its wedge and to the edge's left (World::self_contacts).
///
/// A segment with distinct ends meets the interior of an obstacle if and only if one of the obstacle's edges blocks it,
/// or its first end lies strictly inside.
bool blocks(const World& world, VertexId edge, const LineSegment& segment);

}  // namespace arcway::internal
