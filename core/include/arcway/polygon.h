#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/vec2.h"

namespace arcway {

/// A ring of vertices, each joined to the next and the last to the first; the first vertex is not
/// repeated at the end.
using Ring = std::vector<Vec2>;

/// A region bounded by an outer ring, less its holes. Plain data: World checks it.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// Where a point lies with regard to a region.
enum class PointLocation { kOutside, kBoundary, kInside };

/// Area with sign: positive for a counter-clockwise ring [m^2]. O(n).
ARCWAY_API double signed_area(std::span<const Vec2> ring);

/// Sign of the area by exact arithmetic: +1 counter-clockwise, -1 clockwise, 0 degenerate. Exact for simple and
/// weakly simple rings.
ARCWAY_API int winding(std::span<const Vec2> ring);

/// Two edges of one polygon that may not be there together. Edge i of a ring runs from its vertex
/// i to the next one; ring 0 is the outer one, ring k > 0 is holes[k - 1].
struct RingConflict {
  enum class Kind { kCrossing, kOverlap, kRepeatedVertex } kind;
  std::size_t ring_a, edge_a;
  std::size_t ring_b, edge_b;
  Vec2 place;  ///< a common point, rounded
};

/// A vertex inside an edge of the same polygon: a hole touches another ring there, or a ring touches itself. Rings and
/// edges are counted as in RingConflict.
struct RingContact {
  std::size_t edge_ring, edge;
  std::size_t vertex_ring, vertex;
};

/// The first conflict in edge order, or nothing if the polygon is simple. Rings may touch
/// themselves and each other in single points (pinches) as long as they do not cross there.
/// Collinear consecutive vertices are legal; an edge folded back on its predecessor is an overlap.
/// O(n log n), exact: boxes of edges in a tree, and where too many of them overlap, a sweep. There a conflict may take
/// O(n^2) to be named, its absence does not.
/// @param contacts  if not null, all contacts of a polygon without a conflict are appended, each once.
ARCWAY_API std::optional<RingConflict> find_conflict(const Polygon& polygon,
                                                     std::vector<RingContact>* contacts = nullptr);

}  // namespace arcway
