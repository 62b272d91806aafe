#include "core/query/blocking.h"

#include "core/geometry/predicates.h"

namespace arcway {

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
  const Vec2& before = world.vertex(world.previous(edge));
  return (e.a != segment.b && in_open_cone(before, e.a, e.b, segment.b)) ||
         (e.a != segment.a && in_open_cone(before, e.a, e.b, segment.a));
}

}  // namespace arcway
