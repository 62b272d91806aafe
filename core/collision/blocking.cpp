#include "core/collision/blocking.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// Whether the segment from v towards p starts strictly inside the region of v.
bool leads_inside(const World& world, VertexId v, const Vec2& p) {
  if (!in_open_cone(world.vertex(world.previous(v)), world.vertex(v), world.vertex(world.next(v)), p)) return false;
  const VertexId touched = world.edge_touched_by(v);
  return touched == kNone || orientation(world.edges()[touched].a, world.edges()[touched].b, p) > 0;
}

// Whether a vertex of the edge's own region lies where the edge and a line that crosses it meet.
bool is_touched_on(const World& world, VertexId edge, const LineSegment& line) {
  return std::ranges::any_of(world.self_contacts_on(edge), [&](const SelfContact& contact) {
    return orientation(line.a, line.b, world.vertex(contact.vertex)) == 0;
  });
}

}  // namespace

bool blocks(const World& world, VertexId edge, const LineSegment& segment) {
  const LineSegment& e = world.edges()[edge];
  const int start_side = orientation(segment.a, segment.b, e.a);
  const int end_side = orientation(segment.a, segment.b, e.b);
  if (start_side * end_side > 0) return false;

  if (start_side * end_side < 0) {
    const int a_side = orientation(e.a, e.b, segment.a);
    const int b_side = orientation(e.a, e.b, segment.b);
    // The segment passes from the edge to its left, or ends on the edge.
    const bool meets = a_side * b_side < 0 || (a_side == 0 && b_side > 0) || (b_side == 0 && a_side > 0);
    return meets && !is_touched_on(world, edge, segment);
  }
  if (start_side != 0 || !on_segment(e.a, segment)) return false;
  return (e.a != segment.b && leads_inside(world, edge, segment.b)) ||
         (e.a != segment.a && leads_inside(world, edge, segment.a));
}

}  // namespace arcway::internal
