#include "core/collision/turning_piece.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "arcway/angle.h"

namespace arcway::internal {

namespace {

// A segment, as circles about the origin meet it.
struct Chord {
  Chord(const Vec2& a, const Vec2& b)
      : from(a),
        way(b - a),
        length2(way.squaredNorm()),
        foot(-from.dot(way) / length2),
        least2((from + foot * way).squaredNorm()),
        most2(std::max(a.squaredNorm(), b.squaredNorm())) {}

  Vec2 from, way;
  double length2;
  double foot;    // of the perpendicular from the origin, in lengths
  double least2;  // square of the distance of its line from the origin
  double most2;   // square of the distance of the farther end
};

// Adds the turns about the origin that take a point to a chord; with a sign of -1 those that take the chord to the
// point.
void add_turns(const Vec2& point, const Chord& chord, double sign, std::vector<double>& angles) {
  const double radius2 = point.squaredNorm(), rest = radius2 - chord.least2;
  if (radius2 > chord.most2 * (1.0 + kCriticalSlack) || rest < -kCriticalSlack * radius2) return;
  const double half = std::sqrt(std::max(rest, 0.0) / chord.length2);
  for (const double t : {chord.foot - half, chord.foot + half}) {
    if (t < -kCriticalSlack || t > 1.0 + kCriticalSlack) continue;
    const Vec2 x = chord.from + t * chord.way;
    angles.push_back(wrap_positive(std::atan2(sign * cross(point, x), point.dot(x))));
  }
}

// Whether a segment and a convex polygon touch: no line through the segment or a side separates them.
bool touches(const std::vector<Vec2>& corners, const Vec2& u, const Vec2& v) {
  const Vec2 way = v - u;
  bool has_left = false, has_right = false;
  for (const Vec2& corner : corners) {
    const double side = cross(way, corner - u);
    has_left = has_left || side >= 0.0, has_right = has_right || side <= 0.0;
  }
  if (!has_left || !has_right) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[i + 1 < corners.size() ? i + 1 : 0] - corners[i];
    if (cross(side, u - corners[i]) < 0.0 && cross(side, v - corners[i]) < 0.0) return false;
  }
  return true;
}

struct Memory {
  std::vector<Vec2> corners;  // about the center
  std::vector<double> angles;
};

}  // namespace

void append_blocked_by_piece(const Ring& piece, const Vec2& center, const LineSegment& edge,
                             std::vector<HeadingInterval>& blocked) {
  static thread_local Memory memory;  // single queries are frequent and must not allocate
  std::vector<Vec2>& corners = memory.corners;
  std::vector<double>& angles = memory.angles;
  corners.clear(), angles.clear();
  double reach2 = 0.0;
  for (const Vec2& corner : piece) {
    corners.push_back(corner - center);
    reach2 = std::max(reach2, corners.back().squaredNorm());
  }
  const Chord chord(edge.a, edge.b);
  const Vec2 nearest = chord.from + std::clamp(chord.foot, 0.0, 1.0) * chord.way;
  if (nearest.squaredNorm() > reach2 * (1.0 + kCriticalSlack)) return;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add_turns(corners[i], chord, 1.0, angles);
    const Chord side(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]);
    // Seen from the body, the world turns the other way.
    add_turns(edge.a, side, -1.0, angles);
    add_turns(edge.b, side, -1.0, angles);
  }
  const auto touches_at = [&](double heading) {
    const Vec2 axis = direction_of(heading);
    return touches(corners, {axis.dot(edge.a), cross(axis, edge.a)}, {axis.dot(edge.b), cross(axis, edge.b)});
  };
  if (angles.empty()) {
    if (touches_at(0.0)) blocked.push_back({0.0, kTwoPi});
    return;
  }
  std::sort(angles.begin(), angles.end());
  const std::size_t known = blocked.size();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double low = angles[i], high = i + 1 < angles.size() ? angles[i + 1] : angles[0] + kTwoPi;
    if (low == high || !touches_at(0.5 * (low + high))) continue;
    if (blocked.size() > known && blocked.back().high == low)
      blocked.back().high = high;
    else
      blocked.push_back({low, high});
  }
}

}  // namespace arcway::internal
