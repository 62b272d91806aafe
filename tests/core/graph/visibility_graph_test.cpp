#include "core/graph/visibility_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

#include "core/query/query_set.h"
#include "datasets/clutter.h"
#include "tests/support/random_inputs.h"

namespace arcway {
namespace {

// The rule of the reduced visibility graph restated over whole numbers: a line of sight is cut at all its contacts with
// obstacle edges, and it is blocked if the middle of some piece lies strictly inside an obstacle. Nothing is shared
// with the library but the input.
class Oracle {
 public:
  using Int = __int128;
  struct Point {
    std::int64_t x, y;
    friend bool operator==(const Point&, const Point&) = default;
  };
  using Polygons = std::vector<std::vector<Point>>;  // simple, counter-clockwise

  explicit Oracle(Polygons polygons) : polygons_(std::move(polygons)) {
    for (std::size_t o = 0; o < polygons_.size(); ++o) {
      Box& box = boxes_.emplace_back(polygons_[o][0], polygons_[o][0]);
      for (std::size_t i = 0; i < polygons_[o].size(); ++i) {
        vertices_.push_back({o, i});
        box.add(polygons_[o][i]);
      }
    }
  }

  std::set<std::pair<VertexId, VertexId>> reduced() const {
    std::set<std::pair<VertexId, VertexId>> edges;
    std::vector<VertexId> graph;
    for (VertexId v = 0; v < vertices_.size(); ++v)
      if (is_node(v)) graph.push_back(v);
    for (const VertexId u : graph)
      for (const VertexId v : graph) {
        if (u >= v || at(u) == at(v) || !tangent(u, at(v)) || !tangent(v, at(u)) || !sees(at(u), at(v))) continue;
        if (std::none_of(graph.begin(), graph.end(), [&](VertexId w) { return between(at(w), at(u), at(v)); }))
          edges.insert({u, v});
      }
    return edges;
  }

 private:
  struct Fraction {  // of the way along a line of sight
    Int n, d;
    bool operator<(const Fraction& o) const { return n * o.d < o.n * d; }
    bool operator==(const Fraction& o) const { return n * o.d == o.n * d; }
  };

  struct Box {
    Box(const Point& a, const Point& b) : low{a}, high{a} { add(b); }
    void add(const Point& p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    bool apart_from(const Box& o) const {
      return high.x < o.low.x || o.high.x < low.x || high.y < o.low.y || o.high.y < low.y;
    }
    Point low, high;
  };

  const Point& at(VertexId v) const { return polygons_[vertices_[v].first][vertices_[v].second]; }
  static int sign(Int value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
  static Int area(const Point& a, const Point& b, const Point& c) {
    return Int(b.x - a.x) * (c.y - a.y) - Int(b.y - a.y) * (c.x - a.x);
  }
  static bool between(const Point& w, const Point& a, const Point& b) {
    if (area(a, b, w) != 0) return false;
    const Int along = Int(w.x - a.x) * (b.x - a.x) + Int(w.y - a.y) * (b.y - a.y);
    const Int whole = Int(b.x - a.x) * (b.x - a.x) + Int(b.y - a.y) * (b.y - a.y);
    return along > 0 && along < whole;
  }
  Point neighbour(VertexId v, bool next) const {
    const auto [o, i] = vertices_[v];
    const std::size_t n = polygons_[o].size();
    return polygons_[o][(i + (next ? 1 : n - 1)) % n];
  }
  bool tangent(VertexId v, const Point& p) const {
    return sign(area(p, at(v), neighbour(v, true))) * sign(area(p, at(v), neighbour(v, false))) >= 0;
  }
  bool is_node(VertexId v) const {
    if (area(neighbour(v, false), at(v), neighbour(v, true)) <= 0) return false;
    for (const auto& polygon : polygons_)
      if (strictly_inside(polygon, at(v).x, at(v).y, 1)) return false;
    return true;
  }
  // Of the point (x / d, y / d), d > 0, by crossing parity with the boundary taken out first.
  static bool strictly_inside(const std::vector<Point>& polygon, Int x, Int y, Int d) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      const Int side = Int(b.x - a.x) * (y - a.y * d) - Int(b.y - a.y) * (x - a.x * d);
      const auto within = [](Int v, Int p, Int q) { return std::min(p, q) <= v && v <= std::max(p, q); };
      if (side == 0 && within(x, a.x * d, b.x * d) && within(y, a.y * d, b.y * d)) return false;
      if ((a.y * d > y) != (b.y * d > y) && (side > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
  }
  bool sees(const Point& p, const Point& q) const {
    for (std::size_t o = 0; o < polygons_.size(); ++o) {
      if (boxes_[o].apart_from(Box(p, q))) continue;
      const auto& polygon = polygons_[o];
      std::vector<Fraction> cuts{{0, 1}, {1, 1}};
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const Int along = Int(a.x - p.x) * (q.x - p.x) + Int(a.y - p.y) * (q.y - p.y);
        const Int whole = Int(q.x - p.x) * (q.x - p.x) + Int(q.y - p.y) * (q.y - p.y);
        if (area(p, q, a) == 0 && along > 0 && along < whole) cuts.push_back({along, whole});
        const Int sa = area(p, q, a), sb = area(p, q, b);
        if (sign(sa) * sign(sb) < 0) {
          const Int n = area(a, b, p), m = area(a, b, q);
          if (sign(n) * sign(m) < 0) cuts.push_back(n > 0 ? Fraction{n, n - m} : Fraction{-n, m - n});
        }
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (cuts[k] == cuts[k + 1]) continue;
        const Int n = cuts[k].n * cuts[k + 1].d + cuts[k + 1].n * cuts[k].d;
        const Int d = 2 * cuts[k].d * cuts[k + 1].d;
        if (strictly_inside(polygon, Int(p.x) * d + (q.x - p.x) * n, Int(p.y) * d + (q.y - p.y) * n, d)) return false;
      }
    }
    return true;
  }

  Polygons polygons_;
  std::vector<Box> boxes_;
  std::vector<std::pair<std::size_t, std::size_t>> vertices_;
};

std::set<std::pair<VertexId, VertexId>> edges_of(const VisibilityGraph& graph) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) edges.insert({u, v});
  return edges;
}

void expect_oracle(const Oracle::Polygons& polygons, double scale = 1.0, Vec2 offset = {0, 0}) {
  std::vector<Polygon> obstacles;
  for (const auto& polygon : polygons) {
    obstacles.emplace_back();
    for (const auto& p : polygon)
      obstacles.back().outer.emplace_back(static_cast<double>(p.x) * scale + offset.x(),
                                          static_cast<double>(p.y) * scale + offset.y());
  }
  const World world(std::move(obstacles));
  const VisibilityGraph graph = build_reduced_visibility_graph(world, *make_reference_queries(world).visibility);
  EXPECT_EQ(edges_of(graph), Oracle(polygons).reduced());
  EXPECT_GT(graph.edge_count(), 0u);
}

std::vector<Oracle::Point> box(std::int64_t x, std::int64_t y, std::int64_t w, std::int64_t h) {
  return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

TEST(ReducedVisibilityGraph, OneBoxHasItsEdges) { expect_oracle({box(0, 0, 4, 2)}); }

TEST(ReducedVisibilityGraph, RowsOfEqualBoxes) {
  Oracle::Polygons boxes;
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 4; ++k) boxes.push_back(box(4 * i, 4 * k, 2, 2));
  expect_oracle(boxes);
  expect_oracle(boxes, 0.125, {1e7, -1e7});
}

TEST(ReducedVisibilityGraph, SharedVerticesAndSharedEdges) {
  expect_oracle({box(0, 0, 2, 2), box(2, 2, 2, 2), box(2, 0, 2, 2), box(7, 1, 1, 1)});
  expect_oracle({box(0, 0, 2, 2), box(2, 0, 2, 1), box(4, 0, 2, 2), box(3, 5, 2, 2)});
}

TEST(ReducedVisibilityGraph, CollinearVerticesOnAnEdge) {
  expect_oracle({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 3}, {2, 3}, {0, 3}}, box(6, 0, 2, 3), box(-5, 3, 2, 2)});
}

TEST(ReducedVisibilityGraph, OverlappingAndNestedObstacles) {
  expect_oracle({box(0, 0, 6, 6), box(4, 4, 6, 6), box(1, 1, 2, 2), box(12, 0, 2, 8)});
}

TEST(ReducedVisibilityGraph, NeedlesAndNearlyParallelEdges) {
  expect_oracle({{{0, 0}, {1000000, 1}, {1000000, 2}},
                 {{0, 5}, {1000000, 6}, {0, 7}},
                 box(400000, 20, 10, 10),
                 {{10, -3}, {999999, -3}, {999998, -2}}});
}

TEST(ReducedVisibilityGraph, NonConvexObstacles) {
  expect_oracle(
      {{{0, 0}, {10, 0}, {10, 10}, {8, 10}, {8, 2}, {2, 2}, {2, 10}, {0, 10}}, box(4, 4, 2, 2), box(4, 12, 3, 3)});
}

// Random triangles on a small grid: contacts, overlaps and collinear triples of every kind.
TEST(ReducedVisibilityGraph, RandomTrianglesOnACoarseGrid) {
  test::Random random(2024);
  for (int round = 0; round < 60; ++round) {
    Oracle::Polygons triangles;
    while (triangles.size() < 8) {
      const auto coordinate = [&] { return static_cast<std::int64_t>(random.uniform(0.0, 12.0)); };
      Oracle::Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()}, c{coordinate(), coordinate()};
      const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (area == 0) continue;
      if (area < 0) std::swap(b, c);
      triangles.push_back({a, b, c});
    }
    SCOPED_TRACE(round);
    expect_oracle(triangles);
  }
}

void expect_oracle_in_clutter(ClutterKind kind, std::uint32_t obstacles) {
  const Clutter clutter =
      generate_clutter({.kind = kind, .obstacles = obstacles, .vertices = 8, .fill = 0.3, .seed = 12});
  Oracle::Polygons polygons;
  for (const Polygon& obstacle : clutter.obstacles) {
    polygons.emplace_back();
    for (const Vec2& p : obstacle.outer)
      polygons.back().push_back({std::llround(1e3 * p.x()), std::llround(1e3 * p.y())});
  }
  SCOPED_TRACE(name_of(kind));
  expect_oracle(polygons);
}

TEST(ReducedVisibilityGraph, CluttersInWholeMillimetres) {
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) expect_oracle_in_clutter(kind, 125);
}

// Minutes of brute force: asked for by name, see tests/README.md.
TEST(ReducedVisibilityGraph, CluttersOfTenThousandVertices) {
  if (std::getenv("ARCWAY_LONG_TESTS") == nullptr) GTEST_SKIP() << "runs where ARCWAY_LONG_TESTS is set";
  for (const ClutterKind kind : {ClutterKind::kConvex, ClutterKind::kStar}) expect_oracle_in_clutter(kind, 1250);
}

TEST(VisibilityGraph, TakesRowsInOrderOnly) {
  struct Case {
    std::vector<std::uint64_t> row_starts;
    std::vector<VertexId> targets;
    Table table;
    std::size_t index;
  };
  const Case cases[] = {{{}, {}, Table::kRowStarts, 0},
                        {{1, 1}, {0}, Table::kRowStarts, 0},
                        {{0, 2, 1, 2}, {1, 2}, Table::kRowStarts, 2},
                        {{0, 1}, {}, Table::kRowStarts, 1},
                        {{0, 0, 0}, {1}, Table::kRowStarts, 2},
                        {{0, 1, 1}, {0}, Table::kTargets, 0},
                        {{0, 0, 1}, {0}, Table::kTargets, 0},
                        {{0, 1, 1}, {2}, Table::kTargets, 0},
                        {{0, 2, 2, 2}, {1, 1}, Table::kTargets, 1},
                        {{0, 2, 2, 2}, {2, 1}, Table::kTargets, 1}};
  for (const Case& c : cases) {
    SCOPED_TRACE(&c - cases);
    try {
      const VisibilityGraph graph(c.row_starts, c.targets);
      ADD_FAILURE() << "took it";
    } catch (const TableError& error) {
      EXPECT_EQ(error.table(), c.table) << error.what();
      EXPECT_EQ(error.index(), c.index) << error.what();
    }
  }
  EXPECT_EQ(VisibilityGraph({0, 2, 3, 3}, {1, 2, 2}).edge_count(), 3u);
}

TEST(FullVisibilityGraph, HoldsTheReducedOneAndMore) {
  const World world(
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}}, {{{8, 1}, {10, 1}, {9, 3}}, {}}, {{{2, 8}, {6, 7}, {5, 10}}, {}}});
  const QuerySet queries = make_reference_queries(world);
  const auto full = edges_of(build_full_visibility_graph(world, *queries.visibility));
  const auto reduced = edges_of(build_reduced_visibility_graph(world, *queries.visibility));
  EXPECT_TRUE(std::includes(full.begin(), full.end(), reduced.begin(), reduced.end()));
  EXPECT_GT(full.size(), reduced.size());
}

}  // namespace
}  // namespace arcway
