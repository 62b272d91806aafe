#include "arcway/accel/visibility_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "accel/backend/make_queries.h"
#include "arcway/accel/parallel.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

constexpr std::uint64_t kNastyMaps = 600;

// Vertices, middles of edges, points on a coarse grid and anywhere, some beyond the map.
Vec2 troublesome_point(const World& world, test::RandomInputs& random) {
  const auto count = static_cast<std::int64_t>(world.vertices().size());
  const std::int64_t kind = random.integer(0, 4);
  if (count > 0 && kind == 0) return world.vertex(static_cast<VertexId>(random.integer(0, count - 1)));
  if (count > 0 && kind == 1) {
    const LineSegment& edge = world.edges()[static_cast<std::size_t>(random.integer(0, count - 1))];
    return 0.5 * (edge.a + edge.b);
  }
  if (kind == 2 || count == 0) return random.grid_point(-2, 16);
  const Vec2 size = world.box().max - world.box().min;
  if (kind == 3) return world.box().min + size.cwiseProduct(random.point(-0.2, 1.2));
  return world.box().min + size.cwiseProduct(random.point(-3.0, 4.0));
}

void expect_same_visibility(const World& world, std::uint64_t seed, int segments) {
  const VisibilityMap map(world);
  const QuerySet reference = make_reference_queries(world);
  test::RandomInputs random(seed);
  for (int i = 0; i < segments; ++i) {
    const Vec2 a = troublesome_point(world, random);
    const Vec2 b = random.integer(0, 19) == 0 ? a : troublesome_point(world, random);
    ASSERT_EQ(map.visible({a, b}), reference.visibility->visible({a, b}))
        << a.transpose() << " to " << b.transpose() << ", world " << seed;
  }
}

TEST(VisibilityMap, SeesWhatTheReferenceSees) {
  for (std::uint64_t seed = 0; seed < kNastyMaps; ++seed) {
    expect_same_visibility(test::nasty_world(seed + 20000, 14), seed, 120);
    if (HasFatalFailure()) return;
  }
  for (const char* family : {"adversarial/touching", "adversarial/shared", "adversarial/collinear",
                             "adversarial/needles", "adversarial/far", "adversarial/nested", "adversarial/overlapping",
                             "adversarial/contacts", "adversarial/holes", "maze", "coastline"}) {
    SCOPED_TRACE(family);
    expect_same_visibility(catalog_world(std::string(family) + "/v250/s3"), 5, 1500);
  }
}

std::vector<VertexId> seen_by_trying_all(const World& world, const Vec2& p, const VisibilityQuery& visibility) {
  std::vector<VertexId> found;
  for (VertexId v = 0; v < world.vertices().size(); ++v)
    if (!world.is_covered(v) && world.vertex(v) != p && visibility.visible({p, world.vertex(v)})) found.push_back(v);
  return found;
}

// @returns how many vertices were found from troublesome points of nasty worlds.
template <class Find, class TryAll>
std::size_t expect_same_from_points(std::uint64_t first_seed, const Find& find, const TryAll& try_all) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < kNastyMaps; ++seed) {
    const World world = test::nasty_world(seed + first_seed, 14);
    const VisibilityMap map(world);
    const QuerySet reference = make_reference_queries(world);
    test::RandomInputs random(seed);
    for (int i = 0; i < 30; ++i) {
      const Vec2 p = troublesome_point(world, random);
      const std::vector<VertexId> found = find(map, p);
      EXPECT_EQ(found, try_all(world, p, *reference.visibility)) << p.transpose() << ", " << seed;
      if (testing::Test::HasFailure()) return count;
      count += found.size();
    }
  }
  return count;
}

TEST(VisibilityMap, FindsTheVerticesThatAPointSees) {
  const auto find = [](const VisibilityMap& map, const Vec2& p) { return map.visible_from(p); };
  EXPECT_GT(expect_same_from_points(70000, find, seen_by_trying_all), 50000u);
}

TEST(VisibilityMap, GraphsByExpansionAreTheReferences) {
  const auto expect_same_graph = [](const World& world) {
    const VisibilityGraph graph = build_full_visibility_graph(world, *make_reference_queries(world).visibility);
    EXPECT_EQ(build_full_visibility_graph_by_expansion(world), graph);
    EXPECT_EQ(build_full_visibility_graph_by_expansion(world, TbbExecutor(3)), graph);
    return graph.edge_count();
  };
  std::size_t edges = 0;
  for (std::uint64_t seed = 0; seed < kNastyMaps && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    edges += expect_same_graph(test::nasty_world(seed + 80000, 16));
  }
  EXPECT_GT(edges, 30000u);
  for (const char* name :
       {"clutter/convex/n30/m8/f30/s1", "clutter/star/n30/m8/f15/s1", "adversarial/touching/v250/s3",
        "adversarial/shared/v250/s3", "adversarial/collinear/v250/s3", "adversarial/needles/v250/s3",
        "adversarial/far/v250/s3", "adversarial/nested/v250/s3", "adversarial/overlapping/v250/s3",
        "adversarial/contacts/v250/s3", "adversarial/holes/v250/s3", "maze/v250/s3", "coastline/v250/s3"}) {
    SCOPED_TRACE(name);
    EXPECT_GT(expect_same_graph(catalog_world(name)), 0u);
  }
  EXPECT_EQ(build_full_visibility_graph_by_expansion(World({})).vertex_count(), 0u);
}

std::vector<VertexId> tangents_by_trying_all(const World& world, const Vec2& p, const VisibilityQuery& visibility) {
  std::vector<VertexId> found;
  for (const VertexId v : world.convex_vertices()) {
    const LineSegment segment{p, world.vertex(v)};
    const bool nearest = std::ranges::none_of(world.convex_vertices(),
                                              [&](VertexId w) { return on_open_segment(world.vertex(w), segment); });
    if (nearest && is_tangent(world, v, p) && visibility.visible(segment)) found.push_back(v);
  }
  return found;
}

TEST(VisibilityMap, FindsTheTangentsOfAPoint) {
  const auto find = [](const VisibilityMap& map, const Vec2& p) { return map.tangents_from(p); };
  EXPECT_GT(expect_same_from_points(30000, find, tangents_by_trying_all), 10000u);
}

TEST(VisibilityMap, FindsTheTangentsOfAVertex) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const World world = test::nasty_world(seed + 40000, 14);
    const VisibilityMap map(world);
    const auto rows = rows_of(
        world, build_reduced_visibility_graph(world, *make_reference_queries(world).visibility, SerialExecutor()));
    for (VertexId v = 0; v < world.vertices().size(); ++v)
      ASSERT_TRUE(std::ranges::equal(map.tangents_from(v), rows->of(v))) << seed << " " << v;
    EXPECT_THROW((void)map.tangents_from(static_cast<VertexId>(world.vertices().size())), std::out_of_range);
  }
}

bool is_valid(const World& world) {
  TangentConeStatistics statistics;
  build_reduced_visibility_graph_by_tangent_cones(world, SerialExecutor(), &statistics);
  return statistics.invalid_regions == 0;
}

// Whether q, on the ray, is not beyond its hit.
bool is_before(const VisibilityMap::RayHit& hit, const Vec2& from, const Vec2& q) {
  if (hit.edge.a != hit.edge.b) return orientation(hit.edge.a, hit.edge.b, q) >= 0;
  return hit.edge.a != from && on_segment(q, {from, hit.edge.a});
}

// Worlds and points on a grid, so that points on a ray are exact.
TEST(VisibilityMap, RaysEndWhereLinesOfSightEnd) {
  std::size_t edges = 0, corners = 0, free = 0;
  for (std::uint64_t seed = 0; seed < 2 * kNastyMaps; ++seed) {
    const World world = test::nasty_world(seed + 50000, 12);
    if (world.vertices().empty() || !is_valid(world)) continue;
    const VisibilityMap map(world);
    const QuerySet reference = make_reference_queries(world);
    test::RandomInputs random(seed);
    for (int i = 0; i < 40; ++i) {
      const Vec2 from = random.integer(0, 1) == 0 ? random.grid_point(0, 14) : Vec2(0.5 * random.grid_point(0, 28));
      const Vec2 step = 0.25 * random.grid_point(-3, 3);
      if (step.isZero(0.0)) continue;
      if (!world.has_bounds() && !Box{world.box().min, world.box().max}.contains(from)) continue;
      const auto hit = map.first_hit(from, from + step);
      ++(!hit ? free : hit->edge.a == hit->edge.b ? corners : edges);
      for (int k = 1; k < 60; ++k) {
        const Vec2 q = from + k * step;
        ASSERT_EQ(reference.visibility->visible({from, q}), !hit || is_before(*hit, from, q))
            << from.transpose() << " to " << q.transpose() << ", world " << seed;
      }
      if (hit && hit->edge.a != hit->edge.b) {
        EXPECT_LE(distance(hit->point, hit->edge), 1e-12 * (1.0 + hit->point.norm())) << seed;
      }
    }
  }
  EXPECT_GT(edges, 1500u);
  EXPECT_GT(corners, 200u);
  EXPECT_GT(free, 200u);
}

// The pieces follow each other. A ray that ends at an edge has its direction within exactly one piece.
TEST(VisibilityMap, PolygonsAreWhereRaysEnd) {
  std::size_t inside = 0, on_ends = 0;
  for (std::uint64_t seed = 0; seed < kNastyMaps; ++seed) {
    const World world = test::nasty_world(seed + 60000, 12);
    if (world.vertices().empty() || !is_valid(world)) continue;
    const VisibilityMap map(world);
    test::RandomInputs random(seed);
    for (int i = 0; i < 20; ++i) {
      const Vec2 p = random.integer(0, 1) == 0 ? random.grid_point(0, 14) : Vec2(0.5 * random.grid_point(0, 28));
      if (!world.has_bounds() && !Box{world.box().min, world.box().max}.contains(p)) continue;
      const auto polygon = map.visibility_polygon(p);
      std::size_t gaps = 0;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto& piece = polygon[k];
        EXPECT_GT(orientation(p, piece.past_right, piece.past_left), 0);
        EXPECT_GT(orientation(piece.edge.a, piece.edge.b, p), 0);
        const auto& next = polygon[(k + 1) % polygon.size()];
        gaps += orientation(p, piece.past_left, next.past_right) == 0 ? 0 : 1;
      }
      EXPECT_LE(gaps, 8u);  // one for each obstacle that p lies on
      for (int k = 0; k < 40; ++k) {
        // Along edges between two obstacles, the visible area is empty.
        const bool anywhere = k % 2 == 0;
        const Vec2 towards = p + (anywhere ? random.point(-9, 9) : random.grid_point(-9, 9));
        if (towards == p) continue;
        const auto hit = map.first_hit(p, towards);
        std::size_t within = 0, at_end = 0;
        for (const auto& piece : polygon) {
          const int right = orientation(p, piece.past_right, towards), left = orientation(p, piece.past_left, towards);
          at_end += right == 0 || left == 0;
          if (right <= 0 || left >= 0) continue;
          ++within;
          ASSERT_EQ(piece.is_frame, !hit) << seed;
          if (!hit) continue;
          EXPECT_EQ(hit->edge.a, piece.edge.a);
          EXPECT_EQ(hit->edge.b, piece.edge.b);
        }
        EXPECT_LE(within, 1u);
        const bool at_edge = hit && hit->edge.a != hit->edge.b && hit->point != p;
        if (anywhere) {
          EXPECT_EQ(within == 1, at_edge || !hit) << p.transpose() << " " << towards.transpose();
        }
        inside += within;
        on_ends += at_end > 0;
      }
    }
  }
  EXPECT_GT(inside, 10000u);
  EXPECT_GT(on_ends, 1000u);
}

TEST(VisibilityMap, PolygonOfARoom) {
  const World room({{test::square(1, 1, 1), {}}}, test::square(0, 0, 4));
  double area = 0.0;
  for (const auto& piece : VisibilityMap(room).visibility_polygon({0.5, 1.5})) {
    EXPECT_FALSE(piece.is_frame);
    area += 0.5 * cross(piece.right - Vec2(0.5, 1.5), piece.left - Vec2(0.5, 1.5));
  }
  // The square hides (1, 1), (2, 0), (4, 0), (4, 4), (3, 4), (1, 2).
  EXPECT_NEAR(area, 16.0 - 9.5, 1e-12);
}

// The last digit of p decides on which side of the edge it lies, and where along the edge the ray meets it.
TEST(VisibilityMap, RaysAlmostAlongAnEdgeMeetItSomewhere) {
  const double inf = std::numeric_limits<double>::infinity();
  test::RandomInputs random(3);
  std::size_t met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 a = random.grid_point(-8, 8), along = random.grid_point(-30, 30);
    if (along.isZero(0.0)) continue;
    const Vec2 b = a + along, inside = a + 0.5 * along + 3.0 * perpendicular(along);
    const VisibilityMap map(World({{{a, b, inside}, {}}}));
    const Vec2 middle = a + 0.25 * static_cast<double>(random.integer(-2, 6)) * along;
    Vec2 p = middle, q = middle + 0.5 * static_cast<double>(random.integer(0, 1) * 2 - 1) * along;
    p.x() = std::nextafter(p.x(), random.integer(0, 1) == 0 ? -inf : inf);
    q.y() = std::nextafter(q.y(), random.integer(0, 1) == 0 ? -inf : inf);
    if (!is_in_range(p) || !is_in_range(q)) continue;
    const auto hit = map.first_hit(p, q);
    if (!hit) continue;
    ++met;
    ASSERT_LE(distance(hit->point, {a, b}), 1e-13) << hit->point.transpose();
    for (const auto& piece : map.visibility_polygon(p)) {
      ASSERT_TRUE(piece.right.allFinite() && piece.left.allFinite());
      if (piece.is_frame) continue;
      ASSERT_LE(distance(piece.right, piece.edge) + distance(piece.left, piece.edge), 1e-12);
    }
  }
  EXPECT_GT(met, 500u);
}

// Half of the edge is free from the crossing on, and so is the edge behind its end.
TEST(VisibilityMap, FindsTangentsAlongEdgesFromWhereTheyCross) {
  const World world({{{{0, 0}, {4, 0}, {4, 4}, {4, 6}, {2, 6}, {0, 4}}, {}}, {{{3, 1}, {5, 1}, {5, 3}, {3, 3}}, {}}});
  const VisibilityMap map(world);
  const QuerySet reference = make_reference_queries(world);
  for (const Vec2& p : {Vec2(4, 3), Vec2(4, 3.5), Vec2(4, 1), Vec2(4, 0.5), Vec2(3, 0), Vec2(5, 2)})
    EXPECT_EQ(map.tangents_from(p), tangents_by_trying_all(world, p, *reference.visibility)) << p.transpose();
}

TEST(VisibilityMap, RefusesWhatItCannotSay) {
  const World crossing({{test::square(0, 0, 4), {}}, {test::square(2, 2, 4), {}}});
  const VisibilityMap map(crossing);
  EXPECT_THROW((void)map.first_hit({-1, -1}, {0, 0}), std::domain_error);
  EXPECT_THROW((void)map.visibility_polygon({-1, -1}), std::domain_error);
  EXPECT_TRUE(map.visible({{-1, -1}, {0, 0}}));
  const VisibilityMap square(World({{test::square(0, 0, 4), {}}}));
  EXPECT_THROW((void)square.first_hit({1e6, 0}, {0, 0}), std::domain_error);
  EXPECT_THROW((void)square.first_hit({1, 0}, {1, 0}), std::invalid_argument);
  EXPECT_TRUE(square.visibility_polygon({1, 1}).empty());
  EXPECT_TRUE(square.visible_from({1, 1}).empty());
  EXPECT_THROW((void)square.visible_from(4), std::out_of_range);
  const double nan = std::nan("");
  for (const Vec2& bad : {Vec2(nan, 0.0), Vec2(0.0, 1e101), Vec2(1e-101, 0.0)}) {
    EXPECT_THROW((void)square.visible({{0, 0}, bad}), std::invalid_argument);
    EXPECT_THROW((void)square.visible({bad, {0, 0}}), std::invalid_argument);
    EXPECT_THROW((void)square.first_hit(bad, {1, 1}), std::invalid_argument);
    EXPECT_THROW((void)square.first_hit({-1, -1}, bad), std::invalid_argument);
    EXPECT_THROW((void)square.tangents_from(bad), std::invalid_argument);
    EXPECT_THROW((void)square.visible_from(bad), std::invalid_argument);
    EXPECT_THROW((void)square.visibility_polygon(bad), std::invalid_argument);
  }
  EXPECT_TRUE(VisibilityMap(World({})).visible({{0, 0}, {1, 1}}));
  EXPECT_FALSE(VisibilityMap(World({})).first_hit({0, 0}, {1, 1}).has_value());
}

}  // namespace
}  // namespace arcway::internal
