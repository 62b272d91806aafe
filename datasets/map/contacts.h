#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal {

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

/// Pairs of polygons with a common point, by ascending indices: all of them, or the first `most`.
///
/// O((n + pairs) log n) where few edges cross, whether polygons lie side by side or in each other. Where many cross,
/// there are as many further steps as pairs of edges with overlapping boxes.
/// @param polygons  each without conflicts (find_conflict) and with area; rings of either orientation, no vertex
///   repeated. Fewer than 2^31 vertices.
/// @param most      n polygons in each other are n (n - 1) / 2 pairs.
std::vector<RegionContact> find_contacts(std::span<const Polygon> polygons,
                                         std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace arcway::internal
