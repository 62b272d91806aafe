#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/geometry/vec2.h"

namespace [[gnu::visibility("default")]] arcway {

/// How the closed regions of two polygons meet, by exact arithmetic.
enum class RegionRelation {
  kTouching,     ///< common points on their boundaries only
  kOverlapping,  ///< common area, and each has area of its own
  kFirstInside,  ///< the first one is part of the second
  kSecondInside,
  kEqual
};

struct RegionContact {
  std::uint32_t first, second;  ///< indices, first < second
  RegionRelation relation;
  bool boundaries_meet;  ///< whether the boundaries have a common point
  Vec2 place;            ///< a common point of the two regions, rounded where boundaries cross
};

/// All pairs of polygons with a common point, by ascending indices. O(n log n + pairs of edges whose boxes meet) on
/// maps of short edges.
/// @param polygons  each without conflicts (find_conflict) and with area; rings of either orientation, no vertex
///   repeated. Fewer than 2^31 vertices.
std::vector<RegionContact> find_contacts(std::span<const Polygon> polygons);

}  // namespace arcway
