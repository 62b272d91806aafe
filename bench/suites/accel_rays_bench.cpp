#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "accel/backend/make_queries.h"
#include "accel/embree/edge_scene.h"
#include "arcway/accel/parallel.h"
#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "datasets/io/random.h"

// Lines of sight beside Embree alone, which traces the same rays through the same boxes with a callback that refuses
// every edge: what do exact answers cost? And what does a second thread bring to a batch?
namespace arcway::internal::bench::accel_rays_suite {
namespace {

constexpr std::size_t kRays = 1 << 14;
constexpr std::size_t kChecked = 256;

// From random points, up to ten times as long as the obstacles are apart.
std::vector<LineSegment> random_segments(const World& world) {
  Random random(1);
  const Box& box = world.box();
  const double reach = 10.0 * (box.max - box.min).maxCoeff() / std::sqrt(static_cast<double>(world.obstacle_count()));
  std::vector<LineSegment> segments;
  while (segments.size() < kRays) {
    const Vec2 a(random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()));
    const Vec2 b = a + random.uniform(0.0, reach) * random.unit_vector();
    if (box.contains(b)) segments.push_back({a, b});
  }
  return segments;
}

void time_rays(benchmark::State& state, const std::string& world_name, std::size_t threads) {
  const World& world = shared_world(world_name);
  const std::vector<LineSegment> segments = random_segments(world);
  EmbreeOptions options;
  if (threads > 1) options.batches = std::make_shared<const TbbExecutor>(threads);
  QuerySet queries = make_embree_queries(world, options);
  if (corrupting()) queries = corrupted(queries);
  std::vector<std::uint8_t> visible(kRays), expected(kChecked);
  queries.visibility->visible(segments, visible);
  make_reference_queries(world).visibility->visible(std::span(segments).first(kChecked), expected);
  if (!require(state, std::equal(expected.begin(), expected.end(), visible.begin()), "differs from the reference"))
    return;
  for ([[maybe_unused]] auto _ : state) {
    queries.visibility->visible(segments, visible);
    benchmark::DoNotOptimize(visible.data());
  }
  double seen = 0.0;
  for (const std::uint8_t v : visible) seen += v;
  state.counters["seen"] = seen / static_cast<double>(kRays);
  set_batch(state, kRays);
}

struct RefuseAll {
  bool operator()(VertexId) const { return false; }
};

void time_embree_alone(benchmark::State& state, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const std::vector<LineSegment> segments = random_segments(world);
  const embree::RayScene<RefuseAll> scene(std::make_shared<const embree::Device>(), world, {});
  for ([[maybe_unused]] auto _ : state) {
    for (const LineSegment& s : segments)
      benchmark::DoNotOptimize(scene.any(scene.edges().scaled(s.a), scene.edges().scaled(s.b), {}));
  }
  set_batch(state, kRays);
}

void add(Study study) {
  Series exact(study, "Rays/embree", "obstacles", "O(log n) a ray", 0.2);
  Series alone(study, "Rays/embree_alone", "obstacles", "O(log n) a ray", 0.2);
  for (const std::size_t n : sizes(study, {100, 1000, 10000}, 100, 10000)) {
    const std::string name = clutter_name("convex", n, 10, 30);
    exact.add(static_cast<double>(n), [name](benchmark::State& state) { time_rays(state, name, 1); });
    if (study == Study::kCheck) continue;  // has no answers to check
    alone.add(static_cast<double>(n), [name](benchmark::State& state) { time_embree_alone(state, name); });
  }
  Series by_threads(study, "RayBatches/n:1000", "threads", "1 / threads", 0.0);
  for (const std::size_t t : thread_counts())
    by_threads.add(static_cast<double>(t),
                   [t](benchmark::State& state) { time_rays(state, clutter_name("convex", 1000, 10, 30), t); });
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_rays_suite
