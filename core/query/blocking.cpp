#include "core/query/blocking.h"

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

bool in_cone(const World& world, VertexId v, const Vec2& p) {
  return in_open_cone(world.vertex(world.previous(v)), world.vertex(v), world.vertex(world.next(v)), p);
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
  return (e.a != segment.b && in_cone(world, edge, segment.b)) || (e.a != segment.a && in_cone(world, edge, segment.a));
}

}  // namespace arcway
