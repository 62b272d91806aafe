#pragma once

#include "arcway/world.h"

namespace arcway::internal {

/// Whether an obstacle edge, or its first vertex, proves that some point of the open segment lies strictly inside that
/// edge's obstacle: a proper crossing, an end of the segment on the edge with the other end on the obstacle's side, or
/// the edge's first vertex on the segment with the segment leading into the obstacle there. Exact.
///
/// The obstacle is judged as a set of points. Where a vertex of the obstacle lies inside the edge, the edge alone
/// proves nothing; the vertex does if the segment leads both into its wedge and to the edge's left
/// (World::self_contacts).
///
/// A segment whose ends differ meets the interior of an obstacle if and only if one of the obstacle's edges blocks it
/// or its first end lies strictly inside: where a piece of the segment enters the interior, it does so in one of the
/// ways above.
bool blocks(const World& world, VertexId edge, const LineSegment& segment);

}  // namespace arcway::internal
