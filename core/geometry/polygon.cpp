#include "arcway/polygon.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "arcway/angle.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/crossing_point.h"
#include "core/geometry/expansion.h"
#include "core/geometry/predicates.h"
#include "core/geometry/simplicity.h"

namespace arcway {

using namespace internal;
namespace {

// Number of edges up to which testing all pairs is faster than a tree.
constexpr std::size_t kBruteForceEdges = 32;
// Pairs of edges with overlapping boxes, per edge, after which one sweep over all edges decides whether there is a
// conflict.
constexpr std::size_t kPatience = 64;

struct Area {
  double twice;      // twice the signed area, rounded
  double magnitude;  // sum of the absolute terms
};

// Relative to the first vertex, so that maps far from the origin keep their digits.
Area accumulate_area(std::span<const Vec2> ring) {
  Area area{0.0, 0.0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 u = ring[i] - ring[0];
    const Vec2 v = ring[i + 1] - ring[0];
    const double left = u.x() * v.y();
    const double right = u.y() * v.x();
    area.twice += left - right;
    area.magnitude += std::abs(left) + std::abs(right);
  }
  return area;
}

struct Edge {
  LineSegment segment;
  Vec2 before;  // vertex ahead of segment.a
  Vec2 after;   // vertex behind segment.b
  std::size_t ring;
  std::size_t index;
};

void append_edges(std::span<const Vec2> ring, std::size_t ring_index, std::vector<Edge>& edges) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    edges.push_back({{ring[i], ring[(i + 1) % n]}, ring[(i + n - 1) % n], ring[(i + 2) % n], ring_index, i});
  }
}

// What an edge and its neighbor do at a point of the edge.
struct Chain {
  Vec2 from, to;
};
Chain chain_at(const Edge& edge, const Vec2& p) {
  if (p == edge.segment.a) return {edge.before, edge.segment.b};
  if (p == edge.segment.b) return {edge.segment.a, edge.after};
  return {edge.segment.a, edge.segment.b};
}

bool chains_cross(const Edge& e, const Edge& f, const Vec2& p) {
  const Chain a = chain_at(e, p);
  const Chain b = chain_at(f, p);
  // Directions that coincide are overlaps, found by the pair of edges that coincide.
  return in_open_cone(a.from, p, a.to, b.from) != in_open_cone(a.from, p, a.to, b.to) &&
         in_open_cone(b.from, p, b.to, a.from) != in_open_cone(b.from, p, b.to, a.to);
}

Vec2 touching_point(const LineSegment& s, const LineSegment& t) {
  if (on_segment(s.a, t)) return s.a;
  if (on_segment(s.b, t)) return s.b;
  return on_segment(t.a, s) ? t.a : t.b;
}

// A vertex is noted with the edge that starts there, so that each contact is noted once.
void append_contacts(const Edge& e, const Edge& f, std::vector<RingContact>& contacts) {
  if (on_open_segment(f.segment.a, e.segment)) contacts.push_back({e.ring, e.index, f.ring, f.index});
  if (on_open_segment(e.segment.a, f.segment)) contacts.push_back({f.ring, f.index, e.ring, e.index});
}

std::optional<RingConflict> find_conflict_of(const Edge& e, const Edge& f, bool consecutive,
                                             std::vector<RingContact>* contacts) {
  using Kind = RingConflict::Kind;
  const auto conflict = [&](Kind kind, const Vec2& place) {
    return RingConflict{kind, e.ring, e.index, f.ring, f.index, place};
  };
  switch (relate(e.segment, f.segment)) {
    case SegmentRelation::kDisjoint:
      return std::nullopt;
    case SegmentRelation::kCrossing:
      return conflict(Kind::kCrossing, crossing_point(e.segment, f.segment));
    case SegmentRelation::kOverlapping:
      return conflict(Kind::kOverlap, touching_point(e.segment, f.segment));
    case SegmentRelation::kTouchingInterior:
      if (contacts) append_contacts(e, f, *contacts);
      break;
    case SegmentRelation::kTouchingEnds:
      break;
  }
  if (consecutive) return std::nullopt;
  const Vec2 p = touching_point(e.segment, f.segment);
  if (!chains_cross(e, f, p)) return std::nullopt;
  return conflict(Kind::kCrossing, p);
}

}  // namespace

Polygon Polygon::rectangle(const Vec2& corner, const Vec2& opposite) {
  Box box;
  box.extend(corner);
  box.extend(opposite);
  return rectangle(box);
}

Polygon Polygon::rectangle(double min_x, double min_y, double max_x, double max_y) {
  return rectangle(Vec2(min_x, min_y), Vec2(max_x, max_y));
}

Polygon Polygon::rectangle(const Vec2& middle, double length, double width, double heading) {
  const Vec2 ahead = 0.5 * length * direction_of(heading), aside = 0.5 * width * perpendicular(direction_of(heading));
  return {{middle - ahead - aside, middle + ahead - aside, middle + ahead + aside, middle - ahead + aside}, {}};
}

Polygon Polygon::rectangle(const Box& box) {
  const std::array<Vec2, 4> corners = box.corners();
  return {Ring(corners.begin(), corners.end()), {}};
}

Polygon Polygon::regular(const Vec2& middle, double radius, std::size_t corners, double heading) {
  Polygon polygon;
  polygon.outer.reserve(corners);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = heading + kTwoPi * static_cast<double>(i) / static_cast<double>(corners);
    polygon.outer.push_back(middle + radius * direction_of(angle));
  }
  return polygon;
}

std::string to_string(const Polygon& polygon) {
  const std::size_t vertices = polygon.outer.size(), holes = polygon.holes.size();
  const std::string text = "polygon of " + std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices");
  if (holes == 0) return text;
  return text + " with " + std::to_string(holes) + (holes == 1 ? " hole" : " holes");
}

double signed_area(std::span<const Vec2> ring) { return 0.5 * accumulate_area(ring).twice; }

int winding(std::span<const Vec2> ring) {
  // The area's sign rather than a turn at an extreme vertex: pinched rings may visit that vertex more than once.
  // A term has at most 4 roundings of 2^-53 on either product, the sum one per addend.
  const Area area = accumulate_area(ring);
  const double error = (static_cast<double>(ring.size()) + 8.0) * 0x1p-52 * area.magnitude;
  if (area.twice > error) return 1;
  if (area.twice < -error) return -1;
  Expansion exact;
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
    exact.add_product(ring[last].x(), ring[i].y());
    exact.add_product(-ring[last].y(), ring[i].x());
  }
  return exact.sign();
}

std::optional<RingConflict> find_conflict(const Polygon& polygon, std::vector<RingContact>* contacts) {
  std::vector<Edge> edges;
  std::vector<std::size_t> ring_size{polygon.outer.size()};
  append_edges(polygon.outer, 0, edges);
  for (const Ring& hole : polygon.holes) {
    append_edges(hole, ring_size.size(), edges);
    ring_size.push_back(hole.size());
  }
  for (const Edge& e : edges) {
    if (e.segment.a == e.segment.b) {
      return RingConflict{RingConflict::Kind::kRepeatedVertex, e.ring, e.index, e.ring, e.index, e.segment.a};
    }
  }
  const auto check = [&](std::size_t i, std::size_t j) {
    const Edge& e = edges[i];
    const Edge& f = edges[j];
    const std::size_t gap = f.index - e.index;
    const bool consecutive = e.ring == f.ring && (gap == 1 || gap + 1 == ring_size[e.ring]);
    return find_conflict_of(e, f, consecutive, contacts);
  };
  if (edges.size() <= kBruteForceEdges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        if (auto conflict = check(i, j)) return conflict;
      }
    }
    return std::nullopt;
  }

  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const auto& edge : edges) boxes.push_back(box_of(edge.segment));
  const BoxTree tree(boxes);
  const std::size_t known_contacts = contacts ? contacts->size() : 0;
  std::size_t looks_left = kPatience * edges.size();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (looks_left == 0) {
      if (contacts) contacts->resize(known_contacts);
      if (!has_conflict(polygon, contacts)) return std::nullopt;
      looks_left = std::numeric_limits<std::size_t>::max();  // there is one, to be named
    }
    std::size_t first = edges.size();
    std::optional<RingConflict> found;
    tree.visit_overlaps(boxes[i], [&](std::uint32_t j) {
      looks_left -= looks_left > 0 ? 1 : 0;
      if (j <= i || j >= first) return true;
      if (auto conflict = check(i, j)) {
        found = conflict;
        first = j;
      }
      return true;
    });
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace arcway
