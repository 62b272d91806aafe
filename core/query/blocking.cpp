#include "core/query/blocking.h"

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

bool in_cone(const World& world, VertexId v, const Vec2& p) {
  return in_open_cone(world.vertex(world.previous(v)), world.vertex(v), world.vertex(world.next(v)), p);
}

// Whether the way from a vertex towards p leads into the interior of its region. Where rings touch, each of their
// visits has a cone, disjoint ones (two lobes) or nested ones (a hole that touches the outer ring): inside lie the
// directions in one cone more than just outside, to the right of any visit's edge.
bool leads_inside(const World& world, VertexId v, const Vec2& p) {
  if (!world.is_pinched(v)) return in_cone(world, v, p);
  const Vec2& outside = world.vertex(world.next(v));
  int cones = in_cone(world, v, p) ? 1 : 0;
  int cones_outside = 0;
  const auto [first, last] = world.vertices_of(world.obstacle_of(v));
  for (VertexId w = first; w < last; ++w) {
    if (w == v || world.vertex(w) != world.vertex(v)) continue;
    cones += in_cone(world, w, p) ? 1 : 0;
    cones_outside += in_cone(world, w, outside) ? 1 : 0;
  }
  return cones > cones_outside;
}

}  // namespace

bool blocks(const World& world, VertexId edge, const LineSegment& segment) {
  const LineSegment& e = world.edges()[edge];
  const int start_side = orientation(segment.a, segment.b, e.a);
  const int end_side = orientation(segment.a, segment.b, e.b);
  if (start_side * end_side > 0) return false;

  const int a_side = orientation(e.a, e.b, segment.a);
  const int b_side = orientation(e.a, e.b, segment.b);
  if (start_side * end_side < 0) {
    if (a_side * b_side < 0) return true;
    if (a_side == 0 && on_open_segment(segment.a, e)) return b_side > 0;
    if (b_side == 0 && on_open_segment(segment.b, e)) return a_side > 0;
    return false;
  }
  if (start_side != 0 || !on_segment(e.a, segment)) return false;
  return (e.a != segment.b && leads_inside(world, edge, segment.b)) ||
         (e.a != segment.a && leads_inside(world, edge, segment.a));
}

}  // namespace arcway
