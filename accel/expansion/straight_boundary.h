#pragma once

#include <cstdint>

#include "accel/expansion/free_space_triangulation.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

/// A sense in which boundary edges are followed. To the right is from the lower point of an edge to its higher one.
enum class Sense : std::uint8_t { kRight, kLeft };

/// The point from which an edge leads in a sense.
template <Sense kSense>
[[nodiscard]] std::uint32_t begin_of(const PlanarMap::Edge& edge) {
  return kSense == Sense::kRight ? edge.low : edge.high;
}

/// The point to which an edge leads in a sense.
template <Sense kSense>
[[nodiscard]] std::uint32_t end_of(const PlanarMap::Edge& edge) {
  return kSense == Sense::kRight ? edge.high : edge.low;
}

/// Calls visit(edge) with the boundary edges that leave a point in a sense.
/// @param triangulation  must have listed its left edges if the sense is to the left.
template <Sense kSense, class Visit>
void visit_boundary(const FreeSpaceTriangulation& triangulation, std::uint32_t point, const Visit& visit) {
  if constexpr (kSense == Sense::kRight) {
    for (const PlanarMap::Edge& edge : triangulation.edges_from(point)) visit(edge);
  } else {
    for (const std::uint32_t edge : triangulation.edges_to(point)) visit(triangulation.edge(edge));
  }
}

/// The boundary edge that goes straight on where another one ends; null if there is none.
template <Sense kSense>
[[nodiscard]] const PlanarMap::Edge* straight_on(const FreeSpaceTriangulation& triangulation,
                                                 const PlanarMap::Edge& edge) {
  const auto at = [&](std::uint32_t point) -> const Vec2& { return triangulation.points()[point]; };
  const std::uint32_t end = end_of<kSense>(edge);
  const PlanarMap::Edge* straight = nullptr;
  visit_boundary<kSense>(triangulation, end, [&](const PlanarMap::Edge& next) {
    if (orientation(at(begin_of<kSense>(edge)), at(end), at(end_of<kSense>(next))) == 0) straight = &next;
  });
  return straight;
}

/// Follows a straight boundary from an edge on, to the first point with a node.
/// @param may_follow  (edge) -> whether the boundary counts there.
/// @return the edge that leads to that point; null if the boundary turns, ends or does not count before it.
template <Sense kSense, class MayFollow>
[[nodiscard]] const PlanarMap::Edge* edge_to_node(const FreeSpaceTriangulation& triangulation,
                                                  const PlanarMap::Edge& first, const MayFollow& may_follow) {
  for (const PlanarMap::Edge* edge = &first; edge && may_follow(*edge);
       edge = straight_on<kSense>(triangulation, *edge))
    if (triangulation.first_node_at(end_of<kSense>(*edge)) != kNone) return edge;
  return nullptr;
}

}  // namespace arcway::internal
