#include "arcway/visibility_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <ranges>
#include <set>
#include <span>
#include <stop_token>
#include <utility>

#include "arcway/datasets/clutter.h"
#include "arcway/executor.h"
#include "arcway/query_set.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"
#include "tests/support/touching_worlds.h"
#include "tests/support/visibility_oracle.h"

namespace arcway::internal {
namespace {

using test::edges_of;

void expect_oracle(const World& world) {
  const QuerySet queries = make_reference_queries(world);
  const test::VisibilityOracle oracle(world);
  for (VertexId v = 0; v < world.vertices().size(); ++v) ASSERT_EQ(world.is_convex(v), oracle.is_convex(v)) << v;
  ASSERT_EQ(edges_of(build_reduced_visibility_graph(world, *queries.visibility)), oracle.reduced());
}

using Rings = std::vector<Ring>;

World world_of(const Rings& rings, double scale = 1.0, Vec2 offset = {0, 0}) {
  std::vector<Polygon> obstacles;
  for (const Ring& ring : rings) {
    obstacles.emplace_back();
    for (const Vec2& p : ring) obstacles.back().outer.push_back(p * scale + offset);
  }
  return World(std::move(obstacles));
}

void expect_oracle(const Rings& rings) { expect_oracle(world_of(rings)); }

Ring sized_box(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

TEST(ReducedVisibilityGraph, OneBoxHasItsEdges) { expect_oracle({sized_box(0, 0, 4, 2)}); }

TEST(ReducedVisibilityGraph, RowsOfEqualBoxes) {
  Rings boxes;
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 4; ++k) boxes.push_back(sized_box(4 * i, 4 * k, 2, 2));
  expect_oracle(boxes);
  const auto edges = [](const World& world) {
    return edges_of(build_reduced_visibility_graph(world, *make_reference_queries(world).visibility));
  };
  EXPECT_EQ(edges(world_of(boxes, 0.125, {1e7, -1e7})), edges(world_of(boxes)));
}

TEST(ReducedVisibilityGraph, SharedVerticesAndSharedEdges) {
  expect_oracle({sized_box(0, 0, 2, 2), sized_box(2, 2, 2, 2), sized_box(2, 0, 2, 2), sized_box(7, 1, 1, 1)});
  expect_oracle({sized_box(0, 0, 2, 2), sized_box(2, 0, 2, 1), sized_box(4, 0, 2, 2), sized_box(3, 5, 2, 2)});
}

TEST(ReducedVisibilityGraph, CollinearVerticesOnAnEdge) {
  expect_oracle(
      {{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 3}, {2, 3}, {0, 3}}, sized_box(6, 0, 2, 3), sized_box(-5, 3, 2, 2)});
}

TEST(ReducedVisibilityGraph, OverlappingAndNestedObstacles) {
  expect_oracle({sized_box(0, 0, 6, 6), sized_box(4, 4, 6, 6), sized_box(1, 1, 2, 2), sized_box(12, 0, 2, 8)});
}

TEST(ReducedVisibilityGraph, NeedlesAndNearlyParallelEdges) {
  expect_oracle({{{0, 0}, {1000000, 1}, {1000000, 2}},
                 {{0, 5}, {1000000, 6}, {0, 7}},
                 sized_box(400000, 20, 10, 10),
                 {{10, -3}, {999999, -3}, {999998, -2}}});
}

TEST(ReducedVisibilityGraph, NonConvexObstacles) {
  expect_oracle({{{0, 0}, {10, 0}, {10, 10}, {8, 10}, {8, 2}, {2, 2}, {2, 10}, {0, 10}},
                 sized_box(4, 4, 2, 2),
                 sized_box(4, 12, 3, 3)});
}

// Random triangles on a small grid: contacts, overlaps and collinear triples of every kind.
TEST(ReducedVisibilityGraph, RandomTrianglesOnACoarseGrid) {
  test::RandomInputs random(2024);
  for (int round = 0; round < 60; ++round) {
    Rings triangles;
    while (triangles.size() < 8) {
      Ring triangle{random.grid_point(0, 11), random.grid_point(0, 11), random.grid_point(0, 11)};
      if (winding(triangle) != 0) triangles.push_back(std::move(triangle));
    }
    SCOPED_TRACE(round);
    expect_oracle(triangles);
  }
}

// Holes that touch rings, and rings that touch themselves, at vertices and inside edges: the full graph and the reduced
// one.
TEST(VisibilityGraphs, OfRegionsThatTouchThemselves) {
  std::size_t contacts = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const World world = test::touching_world(seed, 3);
    contacts += world.self_contacts().size();
    expect_oracle(world);
    const QuerySet queries = make_reference_queries(world);
    ASSERT_EQ(edges_of(build_full_visibility_graph(world, *queries.visibility)), test::VisibilityOracle(world).full());
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(contacts, 300u);
}

// Shortest paths between points along a graph. Left out are paths that cross an edge where a vertex of its own region
// touches it, since they have no width.
class ShortestPaths {
 public:
  ShortestPaths(const World& world, const VisibilityGraph& graph, const VisibilityQuery& visibility)
      : world_(world), visibility_(visibility), n_(world.vertices().size()), length_(n_ * n_, kNoWay) {
    for (const auto& [u, v] : edges_of(graph))
      if (has_width({world.vertex(u), world.vertex(v)}))
        length(u, v) = length(v, u) = (world.vertex(u) - world.vertex(v)).norm();
    for (VertexId u = 0; u < n_; ++u)
      for (VertexId v = 0; v < n_; ++v)
        if (world.vertex(u) == world.vertex(v)) length(u, v) = 0.0;
    for (VertexId k = 0; k < n_; ++k)
      for (VertexId u = 0; may_turn_at(k) && u < n_; ++u)
        for (VertexId v = 0; v < n_; ++v) length(u, v) = std::min(length(u, v), length(u, k) + length(k, v));
  }

  [[nodiscard]] double between(const Vec2& p, const Vec2& q) const {
    double shortest = sees({p, q}) ? (p - q).norm() : kNoWay;
    const std::vector<double> from = to_vertices(p), to = to_vertices(q);
    for (VertexId u = 0; u < n_; ++u)
      for (VertexId v = 0; v < n_; ++v) shortest = std::min(shortest, from[u] + length_[u * n_ + v] + to[v]);
    return shortest;
  }

  static bool touches_itself(const World& world, const Vec2& p) {
    return std::ranges::any_of(world.self_contacts(),
                               [&](const SelfContact& contact) { return world.vertex(contact.vertex) == p; });
  }

 private:
  static constexpr double kNoWay = std::numeric_limits<double>::infinity();
  double& length(VertexId u, VertexId v) { return length_[u * n_ + v]; }
  [[nodiscard]] bool may_turn_at(VertexId v) const { return !touches_itself(world_, world_.vertex(v)); }
  [[nodiscard]] bool has_width(const LineSegment& s) const {
    return std::ranges::none_of(world_.self_contacts(), [&](const SelfContact& contact) {
      const LineSegment& touched = world_.edges()[contact.edge];
      return on_open_segment(world_.vertex(contact.vertex), s) && orientation(touched.a, touched.b, s.a) != 0;
    });
  }
  [[nodiscard]] bool sees(const LineSegment& s) const { return visibility_.visible(s) && has_width(s); }
  [[nodiscard]] std::vector<double> to_vertices(const Vec2& p) const {
    std::vector<double> lengths;
    for (VertexId v = 0; v < n_; ++v) {
      const Vec2& at = world_.vertex(v);
      lengths.push_back(may_turn_at(v) && sees({p, at}) ? (p - at).norm() : kNoWay);
    }
    return lengths;
  }

  const World& world_;
  const VisibilityQuery& visibility_;
  std::size_t n_;
  std::vector<double> length_;
};

// No shortest path is lost by leaving out edges.
TEST(VisibilityGraphs, HaveTheSameShortestPaths) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE(seed);
    const World world = test::touching_world(seed, 3);
    const auto is_left_out = [&](VertexId v) { return ShortestPaths::touches_itself(world, world.vertex(v)); };
    if (std::ranges::any_of(world.convex_vertices(), is_left_out)) continue;
    const QuerySet queries = make_reference_queries(world);
    const VisibilityQuery& visibility = *queries.visibility;
    const ShortestPaths full(world, build_full_visibility_graph(world, visibility), visibility);
    const ShortestPaths reduced(world, build_reduced_visibility_graph(world, visibility), visibility);
    test::RandomInputs random(seed);
    const Vec2 size = world.box().max - world.box().min;
    for (int i = 0; i < 20; ++i) {
      const Vec2 p = world.box().min + size.cwiseProduct(random.point(-0.1, 1.1));
      const Vec2 q = world.box().min + size.cwiseProduct(random.point(-0.1, 1.1));
      const double length = full.between(p, q);
      if (!std::isfinite(length)) {
        ASSERT_FALSE(std::isfinite(reduced.between(p, q)));
        continue;
      }
      ASSERT_NEAR(reduced.between(p, q), length, 1e-9 * length) << p.transpose() << " to " << q.transpose();
      ++compared;
    }
  }
  EXPECT_GT(compared, 300u);
}

void expect_oracle_in_clutter(ClutterKind kind, std::uint32_t obstacles) {
  const Clutter clutter =
      generate_clutter({.kind = kind, .obstacles = obstacles, .vertices = 8, .fill = 0.3, .seed = 12});
  Rings rings;
  for (const Polygon& obstacle : clutter.obstacles) {
    rings.emplace_back();
    for (const Vec2& p : obstacle.outer) rings.back().emplace_back((p * 1e3).array().round());
  }
  SCOPED_TRACE(name_of(kind));
  expect_oracle(rings);
}

TEST(ReducedVisibilityGraph, CluttersInWholeMillimeters) {
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
    SnapshotArray array;
    std::size_t index;
  };
  const Case cases[] = {{{}, {}, SnapshotArray::kRowStarts, 0},
                        {{1, 1}, {0}, SnapshotArray::kRowStarts, 0},
                        {{0, 2, 1, 2}, {1, 2}, SnapshotArray::kRowStarts, 2},
                        {{0, 1}, {}, SnapshotArray::kRowStarts, 1},
                        {{0, 0, 0}, {1}, SnapshotArray::kRowStarts, 2},
                        {{0, 1, 1}, {0}, SnapshotArray::kTargets, 0},
                        {{0, 0, 1}, {0}, SnapshotArray::kTargets, 0},
                        {{0, 1, 1}, {2}, SnapshotArray::kTargets, 0},
                        {{0, 2, 2, 2}, {1, 1}, SnapshotArray::kTargets, 1},
                        {{0, 2, 2, 2}, {2, 1}, SnapshotArray::kTargets, 1}};
  for (const Case& c : cases) {
    SCOPED_TRACE(&c - cases);
    try {
      const VisibilityGraph graph(c.row_starts, c.targets);
      ADD_FAILURE() << "took it";
    } catch (const SnapshotError& error) {
      EXPECT_EQ(error.array(), c.array) << error.what();
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

// Each line of sight may try every edge of the map: a row of them is too long to wait for.
class StoppingSights final : public VisibilityQuery {
 public:
  [[nodiscard]] const std::stop_source& stop() const { return stop_; }
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  void do_visible(std::span<const LineSegment> segments, std::span<std::uint8_t> visible) const override {
    asked_ += segments.size();
    std::ranges::fill(visible, std::uint8_t{1});
    stop_.request_stop();
  }
  mutable std::stop_source stop_;
  mutable std::size_t asked_ = 0;
};

TEST(VisibilityGraph, EndsWithinARow) {
  const World world = random_world({.obstacles = 100, .seed = 2});
  const StoppingSights sights;
  const SerialExecutor serial;
  const StoppableExecutor executor(serial, sights.stop().get_token());
  EXPECT_THROW(build_full_visibility_graph(world, sights, executor), Canceled);
  EXPECT_LT(sights.asked(), world.vertices().size() / 4);
}

TEST(VisibilityGraph, HasItsEdgesAsARange) {
  static_assert(std::forward_iterator<GraphEdges::Iterator>);
  static_assert(std::ranges::forward_range<GraphEdges>);
  const VisibilityGraph graph({0, 0, 2, 2, 3, 3, 3}, {3, 5, 4});
  std::vector<GraphEdge> edges;
  for (const auto [a, b] : graph.edges()) edges.push_back({a, b});
  EXPECT_EQ(edges, (std::vector<GraphEdge>{{1, 3}, {1, 5}, {3, 4}}));
  EXPECT_EQ(graph.edges().size(), 3u);
  EXPECT_EQ(std::ranges::distance(graph.edges()), 3);
  EXPECT_TRUE(VisibilityGraph().edges().empty());
  EXPECT_TRUE(VisibilityGraph().edges().begin() == VisibilityGraph().edges().end());
}

}  // namespace
}  // namespace arcway::internal
