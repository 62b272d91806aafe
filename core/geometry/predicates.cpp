#include "core/geometry/predicates.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/expansion.h"
#include "core/geometry/ray_parity.h"

namespace arcway::internal {
namespace {

// Order along any line, exact: the order of x, that of y on vertical lines.
bool precedes(const Vec2& p, const Vec2& q) { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); }

SegmentRelation relate_point(const Vec2& p, const LineSegment& s) {
  if (p == s.a || p == s.b) return SegmentRelation::kTouchingEnds;
  return on_segment(p, s) ? SegmentRelation::kTouchingInterior : SegmentRelation::kDisjoint;
}

SegmentRelation relate_collinear(const LineSegment& s, const LineSegment& t) {
  const auto [s_low, s_high] = std::minmax(s.a, s.b, precedes);
  const auto [t_low, t_high] = std::minmax(t.a, t.b, precedes);
  const Vec2& low = std::max(s_low, t_low, precedes);
  const Vec2& high = std::min(s_high, t_high, precedes);
  if (precedes(high, low)) return SegmentRelation::kDisjoint;
  return low == high ? SegmentRelation::kTouchingEnds : SegmentRelation::kOverlapping;
}

// The determinant of the given coordinates rather than of differences: six products, no case split.
FixedExpansion<12> exact_determinant(const Vec2& a, const Vec2& b, const Vec2& c) {
  FixedExpansion<12> determinant;
  determinant.add_product(a.x(), b.y());
  determinant.add_product(-a.y(), b.x());
  determinant.add_product(b.x(), c.y());
  determinant.add_product(-b.y(), c.x());
  determinant.add_product(c.x(), a.y());
  determinant.add_product(-c.y(), a.x());
  return determinant;
}

}  // namespace

int detail::exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  // Most often asked where two of the points are one, or all lie on a line along an axis.
  if ((a.x() == c.x() || b.y() == c.y()) && (a.y() == c.y() || b.x() == c.x())) return 0;
  return exact_determinant(a, b, c).sign();
}

double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) { return exact_determinant(a, b, c).value(); }

SegmentRelation relate(const LineSegment& s, const LineSegment& t) {
  if (!box_of(s).overlaps(box_of(t))) return SegmentRelation::kDisjoint;
  if (s.a == s.b) return relate_point(s.a, t);
  if (t.a == t.b) return relate_point(t.a, s);

  const int ta = orientation(s.a, s.b, t.a);
  const int tb = orientation(s.a, s.b, t.b);
  if (ta == 0 && tb == 0) return relate_collinear(s, t);
  if (ta * tb > 0) return SegmentRelation::kDisjoint;
  const int sa = orientation(t.a, t.b, s.a);
  const int sb = orientation(t.a, t.b, s.b);
  if (sa * sb > 0) return SegmentRelation::kDisjoint;
  if (ta != 0 && tb != 0 && sa != 0 && sb != 0) return SegmentRelation::kCrossing;
  const bool share_end = s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
  return share_end ? SegmentRelation::kTouchingEnds : SegmentRelation::kTouchingInterior;
}

bool on_segment(const Vec2& p, const LineSegment& s) { return box_of(s).contains(p) && orientation(s.a, s.b, p) == 0; }

bool on_open_segment(const Vec2& p, const LineSegment& s) { return p != s.a && p != s.b && on_segment(p, s); }

PointLocation locate(const Vec2& p, std::span<const Vec2> ring) {
  RayParity parity(p);
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) parity.add(ring[last], ring[i]);
  return parity.location();
}

bool in_open_cone(const Vec2& prev, const Vec2& v, const Vec2& next, const Vec2& p) {
  const int turn = orientation(prev, v, next);
  const int from_next = orientation(v, next, p);
  if (turn > 0) return from_next > 0 && orientation(prev, v, p) > 0;
  if (turn < 0) return from_next > 0 || orientation(prev, v, p) > 0;
  const bool straight = precedes(prev, v) == precedes(v, next);
  if (straight) return from_next > 0;
  // Folded back: everything but the ray itself.
  return from_next != 0 || precedes(v, p) != precedes(v, next);
}

bool intersects(const LineSegment& s, std::span<const Vec2, 4> quad) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2& a = quad[i];
    const Vec2& b = quad[(i + 1) % 4];
    if (orientation(a, b, s.a) < 0 && orientation(a, b, s.b) < 0) return false;
  }
  const int side = orientation(s.a, s.b, quad[0]);
  const auto is_beside = [&](const Vec2& corner) { return orientation(s.a, s.b, corner) == side; };
  if (side != 0 && std::all_of(quad.begin() + 1, quad.end(), is_beside)) return false;
  // No line of one without area separates it from what lies further along that line.
  Box box;
  for (const Vec2& corner : quad) box.extend(corner);
  return box_of(s).overlaps(box);
}

}  // namespace arcway::internal
