#include "core/geometry/closest_pair.h"

#include "core/geometry/crossing_point.h"
#include "core/geometry/distance.h"

namespace arcway::internal {
namespace {

Vec2 meeting_point(const LineSegment& s, const LineSegment& t) {
  for (const Vec2& p : {s.a, s.b})
    if (on_segment(p, t)) return p;
  for (const Vec2& p : {t.a, t.b})
    if (on_segment(p, s)) return p;
  return crossing_point(s, t);
}

}  // namespace

ClosestPair closest_pair(const LineSegment& s, const LineSegment& t) {
  ClosestPair pair;
  pair.distance = distance(s, t);
  if (pair.distance == 0.0) {
    pair.a = pair.b = meeting_point(s, t);
    return pair;
  }
  double least = std::numeric_limits<double>::infinity();  // the pair that gives the distance has an end of one of them
  const auto take = [&](const Vec2& a, const Vec2& b) {
    const double length = (a - b).norm();
    if (length >= least) return;
    least = length;
    pair.a = a;
    pair.b = b;
  };
  take(s.a, closest_point(s.a, t));
  take(s.b, closest_point(s.b, t));
  take(closest_point(t.a, s), t.a);
  take(closest_point(t.b, s), t.b);
  return pair;
}

}  // namespace arcway::internal
