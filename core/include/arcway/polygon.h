#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/text.h"
#include "arcway/vec2.h"

namespace arcway {

/// A closed chain of vertices [m]: each is joined to the next, and the last to the first, which is not repeated.
using Ring = std::vector<Vec2>;

/// A region: the inside of an outer ring without its holes. World checks whether it is valid.
struct ARCWAY_API Polygon {
  Ring outer;
  std::vector<Ring> holes = {};

  /// An upright rectangle by two opposite corners [m]. Counter-clockwise from the lower left one.
  static Polygon rectangle(const Vec2& corner, const Vec2& opposite);
  /// An upright rectangle by its sides [m].
  static Polygon rectangle(double min_x, double min_y, double max_x, double max_y);
  /// A rectangle about its middle [m].
  /// @param length, width  along and across the heading [m].
  /// @param heading  [rad], counter-clockwise from +x.
  static Polygon rectangle(const Vec2& middle, double length, double width, double heading = 0.0);
  /// The box as a polygon.
  static Polygon rectangle(const Box& box);
  /// A regular polygon, counter-clockwise, as a disc's place holder. The disc of radius `radius * cos(pi / corners)`
  /// lies inside.
  /// @param radius  of the corners about the middle [m].
  /// @param heading  from the middle to the first corner [rad].
  static Polygon regular(const Vec2& middle, double radius, std::size_t corners, double heading = 0.0);
};
/// "polygon of 4 vertices", "polygon of 4 vertices with 2 holes".
ARCWAY_API std::string to_string(const Polygon& polygon);

/// Where a point lies relative to a region.
enum class PointLocation { kOutside, kBoundary, kInside };

/// Signed area [m^2]: positive if the ring is counter-clockwise. Rounded. O(n).
ARCWAY_API double signed_area(std::span<const Vec2> ring);

/// Orientation by exact arithmetic: +1 counter-clockwise, -1 clockwise, 0 of area zero. The ring must be simple, or
/// weakly simple: it may touch itself but not cross.
ARCWAY_API int winding(std::span<const Vec2> ring);

/// Two edges that make a polygon self-intersecting. Edge i of a ring runs from its vertex i to the next one. Ring 0 is
/// the outer ring, ring k > 0 is holes[k - 1].
struct RingConflict {
  enum class Kind { kCrossing, kOverlap, kRepeatedVertex } kind;
  std::size_t ring_a, edge_a;
  std::size_t ring_b, edge_b;
  Vec2 place;  ///< a common point, rounded [m]
};

/// A vertex inside an edge of the same polygon, where a hole touches another ring or a ring touches itself. Rings and
/// edges are numbered as in RingConflict.
struct RingContact {
  std::size_t edge_ring, edge;
  std::size_t vertex_ring, vertex;
};

/// The first conflict of a polygon in the order of edges, or nothing if the polygon is valid. A valid polygon's rings
/// may touch themselves and each other in single points, as long as they do not cross there. Collinear consecutive
/// vertices are valid; an edge folded back on its predecessor is an overlap. Exact. O(n log n) for valid polygons:
/// edges' boxes in a tree or, where too many of them overlap, a sweep. To name a conflict may then take O(n^2).
/// @param contacts  may be null; else all contacts of a valid polygon are appended, each once.
ARCWAY_API std::optional<RingConflict> find_conflict(const Polygon& polygon,
                                                     std::vector<RingContact>* contacts = nullptr);

}  // namespace arcway
