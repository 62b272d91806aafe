#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "arcway/visibility_graph.h"
#include "arcway/world.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal::test {

using EdgeSet = std::set<std::pair<VertexId, VertexId>>;

inline EdgeSet edges_of(const VisibilityGraph& graph) {
  EdgeSet edges;
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) edges.insert({u, v});
  return edges;
}

/// Both visibility graphs in whole numbers and fractions of them. A region is a set of points: what lies strictly
/// inside an odd number of its rings, or outside of the bounds. A line is cut at all its contacts with edges, and it is
/// blocked if the middle of a piece lies strictly inside. The wedge of a vertex is found in the same way, from one
/// direction in which edges leave to the next one. Nothing is shared with the library but vertices, rings and their
/// order: neither `next` nor any rule about cones.
///
/// Takes worlds of whole coordinates with extents up to 2^20: the fractions then fit into 128 bits.
class VisibilityOracle {
 public:
  explicit VisibilityOracle(const World& world) {
    const std::span<const Vec2> vertices = world.vertices();
    for (const Vec2& p : vertices) {
      at_.push_back({static_cast<std::int64_t>(p.x()) - origin(vertices).x,
                     static_cast<std::int64_t>(p.y()) - origin(vertices).y});
      if (p != p.array().round().matrix()) throw std::invalid_argument("oracle: a coordinate is no whole number");
    }
    for (ObstacleId o = 0; o < world.region_count(); ++o) add_region(world, o);
    for (VertexId v = 0; v < at_.size(); ++v) is_free_.push_back(!is_inside_any(at_[v].x, at_[v].y, 1));
    for (VertexId v = 0; v < at_.size(); ++v) wedges_.push_back(wedge_of(v));
  }

  [[nodiscard]] bool is_convex(VertexId v) const { return wedges_[v].is_convex; }

  [[nodiscard]] EdgeSet full() const {
    EdgeSet edges;
    for (VertexId u = 0; u < at_.size(); ++u)
      for (VertexId v = u + 1; v < at_.size(); ++v)
        if (is_free_[u] && is_free_[v] && at_[u] != at_[v] && sees(at_[u], at_[v])) edges.insert({u, v});
    return edges;
  }

  [[nodiscard]] EdgeSet reduced() const {
    std::vector<VertexId> nodes;
    for (VertexId v = 0; v < at_.size(); ++v)
      if (is_free_[v] && is_convex(v)) nodes.push_back(v);
    EdgeSet edges;
    for (const VertexId u : nodes)
      for (const VertexId v : nodes) {
        if (u >= v || at_[u] == at_[v] || !is_tangent(u, at_[v]) || !is_tangent(v, at_[u])) continue;
        if (std::ranges::any_of(nodes, [&](VertexId w) { return is_between(at_[w], at_[u], at_[v]); })) continue;
        if (sees(at_[u], at_[v])) edges.insert({u, v});
      }
    return edges;
  }

 private:
  using Int = __int128;
  struct Point {
    std::int64_t x, y;
    friend bool operator==(const Point&, const Point&) = default;
  };
  struct Edge {
    Point a, b;
  };
  struct Region {
    std::vector<Edge> edges;
    bool is_bounds;
  };
  struct Fraction {  // of the way along a line
    Int n, d;
    bool operator<(const Fraction& o) const { return n * o.d < o.n * d; }
    bool operator==(const Fraction& o) const { return n * o.d == o.n * d; }
  };
  struct Wedge {
    Point first, last;  // on its two edges
    bool is_convex;
  };

  static Point origin(std::span<const Vec2> vertices) {
    return {static_cast<std::int64_t>(vertices[0].x()), static_cast<std::int64_t>(vertices[0].y())};
  }
  static int sign(Int value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
  static Int area(const Point& a, const Point& b, const Point& c) {
    return Int(b.x - a.x) * (c.y - a.y) - Int(b.y - a.y) * (c.x - a.x);
  }
  static Int along(const Point& a, const Point& b, const Point& p) {
    return Int(p.x - a.x) * (b.x - a.x) + Int(p.y - a.y) * (b.y - a.y);
  }
  static bool is_between(const Point& w, const Point& a, const Point& b) {
    return area(a, b, w) == 0 && along(a, b, w) > 0 && along(a, b, w) < along(a, b, b);
  }

  void add_region(const World& world, ObstacleId o) {
    Region& region = regions_.emplace_back();
    region.is_bounds = o == world.obstacle_count();
    const auto starts = world.ring_starts(o);
    for (std::size_t r = 0; r < starts.size(); ++r) {
      const VertexId last = r + 1 < starts.size() ? starts[r + 1] : world.vertices_of(o).last;
      for (VertexId v = starts[r]; v < last; ++v) {
        const VertexId next = v + 1 < last ? v + 1 : starts[r];
        const VertexId before = v > starts[r] ? v - 1 : last - 1;
        region.edges.push_back({at_[v], at_[next]});
        region_of_.push_back(o);
        neighbors_.push_back({at_[before], at_[next]});
      }
    }
  }

  // Of the point (x / d, y / d), d > 0.
  static bool is_inside(const Region& region, Int x, Int y, Int d) {
    bool inside = region.is_bounds;
    for (const auto& [a, b] : region.edges) {
      const Int side = Int(b.x - a.x) * (y - a.y * d) - Int(b.y - a.y) * (x - a.x * d);
      const auto within = [](Int v, Int p, Int q) { return std::min(p, q) <= v && v <= std::max(p, q); };
      if (side == 0 && within(x, a.x * d, b.x * d) && within(y, a.y * d, b.y * d)) return false;
      if ((a.y * d > y) != (b.y * d > y) && (side > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
  }
  [[nodiscard]] bool is_inside_any(Int x, Int y, Int d) const {
    return std::ranges::any_of(regions_, [&](const Region& region) { return is_inside(region, x, y, d); });
  }

  // Where a line meets edges of a region, ascending, with its ends.
  static std::vector<Fraction> cuts(const Region& region, const Point& p, const Point& q) {
    std::vector<Fraction> cuts{{0, 1}, {1, 1}};
    for (const auto& [a, b] : region.edges) {
      if (is_between(a, p, q)) cuts.push_back({along(p, q, a), along(p, q, q)});
      const Int n = area(a, b, p), m = area(a, b, q);
      if (sign(area(p, q, a)) * sign(area(p, q, b)) < 0 && sign(n) * sign(m) < 0)
        cuts.push_back(n > 0 ? Fraction{n, n - m} : Fraction{-n, m - n});
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }
  static bool is_inside_between(const Region& region, const Point& p, const Point& q, const Fraction& low,
                                const Fraction& high) {
    const Int n = low.n * high.d + high.n * low.d, d = 2 * low.d * high.d;
    return is_inside(region, Int(p.x) * d + (q.x - p.x) * n, Int(p.y) * d + (q.y - p.y) * n, d);
  }

  [[nodiscard]] bool sees(const Point& p, const Point& q) const {
    for (const Region& region : regions_) {
      const std::vector<Fraction> at = cuts(region, p, q);
      for (std::size_t k = 0; k + 1 < at.size(); ++k)
        if (is_inside_between(region, p, q, at[k], at[k + 1])) return false;
    }
    return true;
  }
  // Whether the way from p to q starts inside a region.
  static bool enters(const Region& region, const Point& p, const Point& q) {
    const std::vector<Fraction> at = cuts(region, p, q);
    return is_inside_between(region, p, q, at[0], at[1]);
  }

  // Whether b lies in the directions from the one to a, without it, half a turn on counter-clockwise.
  static bool follows(const Point& p, const Point& a, const Point& b) {
    const Int side = area(p, a, b);
    return side > 0 || (side == 0 && along(p, a, b) < 0);
  }

  // The wedge of its region between an edge of the vertex and the next one counter-clockwise. A vertex that has none of
  // the kind is not convex: the next edge is more than half a turn on, or passes through the vertex.
  [[nodiscard]] Wedge wedge_of(VertexId v) const {
    const Region& region = regions_[region_of_[v]];
    const Point& p = at_[v];
    for (const Point& first : neighbors_[v]) {
      const Point* last = nullptr;
      bool passes = false;
      const auto offer = [&](const Point& q, bool is_of_edge_through) {
        if (!follows(p, first, q) || (last && !follows(p, q, *last))) return;
        last = &q;
        passes = is_of_edge_through;
      };
      for (const Edge& edge : region.edges) {
        const bool through = is_between(p, edge.a, edge.b);
        if (edge.a == p || through) offer(edge.b, through);
        if (edge.b == p || through) offer(edge.a, through);
      }
      if (!last || passes || area(p, first, *last) <= 0) continue;
      const Point between{first.x + last->x - p.x, first.y + last->y - p.y};
      if (enters(region, p, between)) return {first, *last, true};
    }
    return {neighbors_[v].front(), neighbors_[v].back(), false};
  }

  [[nodiscard]] bool is_tangent(VertexId v, const Point& q) const {
    return sign(area(q, at_[v], wedges_[v].first)) * sign(area(q, at_[v], wedges_[v].last)) >= 0;
  }

  std::vector<Point> at_;
  std::vector<Region> regions_;
  std::vector<ObstacleId> region_of_;
  std::vector<std::array<Point, 2>> neighbors_;
  std::vector<char> is_free_;
  std::vector<Wedge> wedges_;
};

}  // namespace arcway::internal::test
