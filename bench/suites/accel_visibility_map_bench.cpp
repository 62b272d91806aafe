#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "arcway/accel/visibility_map.h"
#include "arcway/query_set.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/geometry/predicates.h"
#include "datasets/io/random.h"

// What a visibility library is asked for, from free points, one by one; the map is made before.
namespace arcway::internal::bench::accel_visibility_map_suite {
namespace {

constexpr std::size_t kPoints = 512;
constexpr std::size_t kChecked = 8;

using VisibleEdge = VisibilityMap::VisibleEdge;

std::vector<Vec2> free_points(const World& world, const DistanceQuery& distance) {
  Random random(1);
  const Box& box = world.box();
  std::vector<Vec2> points;
  while (points.size() < kPoints) {
    const Vec2 p(random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()));
    if (distance.containing(p) == kNone) points.push_back(p);
  }
  return points;
}

// By trying all edges; none where the ray leaves the map, or touches a vertex.
std::optional<VertexId> first_edge(const World& world, const Vec2& from, const Vec2& towards) {
  std::optional<VertexId> first;
  double nearest = std::numeric_limits<double>::infinity();
  for (VertexId e = 0; e < world.edges().size(); ++e) {
    const LineSegment& edge = world.edges()[e];
    const double a = cross(towards - from, edge.a - from), b = cross(towards - from, edge.b - from);
    if (!(a * b < 0.0)) continue;
    const double along = (towards - from).dot(edge.a + a / (a - b) * (edge.b - edge.a) - from);
    if (along <= 0.0 || along >= nearest) continue;
    nearest = along;
    first = e;
  }
  return first;
}

bool is_edge(const World& world, const std::optional<VertexId>& expected, const LineSegment& edge) {
  if (!expected) return false;
  const LineSegment& e = world.edges()[*expected];
  return (e.a == edge.a && e.b == edge.b) || (e.a == edge.b && e.b == edge.a);
}

bool is_right(const World& world, const Vec2& p, const std::vector<VertexId>& seen) {
  const QuerySet reference = make_reference_queries(world);
  std::vector<VertexId> expected;
  for (VertexId v = 0; v < world.vertices().size(); ++v)
    if (!world.is_covered(v) && reference.visibility->visible({p, world.vertex(v)})) expected.push_back(v);
  return seen == expected;
}

bool is_right(const World& world, const Vec2& p, const std::vector<VisibleEdge>& seen) {
  for (const VisibleEdge& piece : seen) {
    const Vec2 middle = 0.5 * (piece.right + piece.left);
    if (!piece.is_frame && !is_edge(world, first_edge(world, p, middle), piece.edge)) return false;
  }
  return !seen.empty();
}

template <class Answer>
Answer corrupted_if_asked(Answer answer) {
  if (corrupting()) answer.clear();
  return answer;
}

template <class Ask>
void time_questions(benchmark::State& state, const std::string& world_name, const Ask& ask) {
  const World& world = shared_world(world_name);
  const VisibilityMap map(world);
  const std::vector<Vec2> points = free_points(world, *make_reference_queries(world).distance);
  double found = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto answer = corrupted_if_asked(ask(map, points[i]));
    found += static_cast<double>(answer.size());
    if (i < kChecked && !require(state, is_right(world, points[i], answer), "differs from the reference")) return;
  }
  for ([[maybe_unused]] auto _ : state)
    for (const Vec2& p : points) benchmark::DoNotOptimize(ask(map, p));
  state.counters["found"] = found / static_cast<double>(kPoints);
  set_batch(state, kPoints);
}

void time_rays(benchmark::State& state, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const VisibilityMap map(world);
  const std::vector<Vec2> points = free_points(world, *make_reference_queries(world).distance);
  Random random(2);
  std::vector<Vec2> towards;
  for (const Vec2& p : points) towards.push_back(p + random.unit_vector());
  for (std::size_t i = 0; i < 16 * kChecked; ++i) {
    const auto hit = map.first_hit(points[i], towards[i]);
    const auto expected = first_edge(world, points[i], towards[i]);
    const bool same = hit ? is_edge(world, expected, hit->edge) : !expected;
    if (!require(state, same != corrupting(), "differs from the reference")) return;
  }
  for ([[maybe_unused]] auto _ : state)
    for (std::size_t i = 0; i < kPoints; ++i) benchmark::DoNotOptimize(map.first_hit(points[i], towards[i]));
  set_batch(state, kPoints);
}

void add(Study study) {
  Series vertices(study, "VisibilityMap/visible_vertices", "obstacles", "O(log n + triangles seen)", 0.2);
  Series polygons(study, "VisibilityMap/visibility_polygon", "obstacles", "O(log n + triangles seen)", 0.2);
  Series rays(study, "VisibilityMap/first_hit", "obstacles", "O(log n + triangles on the way)", 0.2);
  for (const std::size_t n : sizes(study, {100, 1000, 10000}, 100, 10000)) {
    const std::string name = clutter_name("convex", n, 10, 30);
    vertices.add(static_cast<double>(n), [name](benchmark::State& state) {
      time_questions(state, name, [](const VisibilityMap& map, const Vec2& p) { return map.visible_from(p); });
    });
    polygons.add(static_cast<double>(n), [name](benchmark::State& state) {
      time_questions(state, name, [](const VisibilityMap& map, const Vec2& p) { return map.visibility_polygon(p); });
    });
    rays.add(static_cast<double>(n), [name](benchmark::State& state) { time_rays(state, name); });
  }
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_visibility_map_suite
