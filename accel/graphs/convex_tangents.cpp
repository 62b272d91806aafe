#include "accel/graphs/convex_tangents.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

constexpr int kMostSteps = 16;

// Monotone in the angle of a vector from +x: 0 to 4, without trigonometry.
double pseudo_angle(const Vec2& d) {
  const double t = d.y() / (std::abs(d.x()) + std::abs(d.y()));
  if (d.x() < 0.0) return 2.0 - t;
  return t < 0.0 ? 4.0 + t : t;
}

}  // namespace

ConvexTangents::ConvexTangents(const World& world) : world_(world), convex_(world.region_count(), false) {
  angles_.resize(world_.vertices().size());
  ends_.resize(world_.vertices().size());
  for (ObstacleId o = 0; o < world_.obstacle_count(); ++o) {
    const auto [first, last] = world_.vertices_of(o);
    bool convex = world_.ring_starts(o).size() == 1;
    for (VertexId v = first; v < last; ++v) convex = convex && world_.is_convex(v);
    // A ring that touches itself in a vertex bounds several parts, and `next` leads around one of them.
    VertexId around = 1;
    for (VertexId v = world_.next(first); convex && v != first; v = world_.next(v)) ++around;
    convex = convex && around == last - first;
    convex_[o] = convex;
    if (!convex) continue;
    const auto angle_of = [&](VertexId v) {
      return pseudo_angle(world_.edges()[world_.previous(v)].b - world_.edges()[world_.previous(v)].a);
    };
    VertexId v = first;
    for (VertexId w = first; w < last; ++w)
      if (angle_of(w) < angle_of(v)) v = w;
    for (VertexId i = first; i < last; ++i, v = world_.next(v)) {
      ends_[i] = v;
      angles_[i] = angle_of(v);
    }
  }
}

// In counter-clockwise order, edges up to the angle of the direction's left normal lead towards it, later ones away.
VertexId ConvexTangents::furthest(ObstacleId obstacle, const Vec2& direction) const {
  const auto [first, last] = world_.vertices_of(obstacle);
  const double angle = pseudo_angle(perpendicular(direction));
  const auto begin = angles_.begin() + first;
  const auto end = angles_.begin() + last;
  const auto after = std::upper_bound(begin, end, angle);
  return ends_[after == begin ? last - 1 : static_cast<VertexId>(after - angles_.begin()) - 1];
}

// Side +1: the obstacle lies to the left of the line from a to b, and its vertex on the line is the one furthest right.
std::optional<ConvexTangents::VertexPair> ConvexTangents::tangent(ObstacleId a, ObstacleId b, int side_a,
                                                                  int side_b) const {
  const auto center_of = [this](ObstacleId o) { return Vec2(0.5 * (world_.box_of(o).min + world_.box_of(o).max)); };
  Vec2 along = center_of(b) - center_of(a);
  VertexPair pair{kNone, kNone};
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec2 right = -perpendicular(along);
    const VertexPair next{furthest(a, side_a * right), furthest(b, side_b * right)};
    if (next == pair) break;
    pair = next;
    along = world_.vertex(pair.second) - world_.vertex(pair.first);
  }
  // Rounding may have missed by a vertex. Step to neighbors until the tangent is proven.
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec2& p = world_.vertex(pair.first);
    const Vec2& q = world_.vertex(pair.second);
    VertexId& v = is_touched(pair.first, p, q, side_a) ? pair.second : pair.first;
    const int side = &v == &pair.first ? side_a : side_b;
    if (is_touched(v, p, q, side)) return pair;
    const int ahead = side * orientation(p, q, world_.vertex(world_.next(v)));
    const int back = side * orientation(p, q, world_.vertex(world_.previous(v)));
    if (std::min(ahead, back) == 0) return std::nullopt;  // along an edge
    v = ahead < back ? world_.next(v) : world_.previous(v);
  }
  return std::nullopt;
}

bool ConvexTangents::is_touched(VertexId v, const Vec2& p, const Vec2& q, int side) const {
  return orientation(p, q, world_.vertex(world_.next(v))) == side &&
         orientation(p, q, world_.vertex(world_.previous(v))) == side;
}

std::optional<std::array<ConvexTangents::VertexPair, 4>> ConvexTangents::between(ObstacleId a, ObstacleId b) const {
  if (world_.box_of(a).overlaps(world_.box_of(b))) return std::nullopt;
  std::array<VertexPair, 4> pairs;
  std::size_t count = 0;
  for (const int side_a : {1, -1})
    for (const int side_b : {1, -1}) {
      const std::optional<VertexPair> found = tangent(a, b, side_a, side_b);
      if (!found) return std::nullopt;
      pairs[count++] = *found;
    }
  return pairs;
}

}  // namespace arcway::internal
