#include <benchmark/benchmark.h>

#include <vector>

#include "accel/embree/edge_scene.h"
#include "accel/make_queries.h"
#include "accel/parallel.h"
#include "bench/suites/bench_worlds.h"

// How many lines of sight a second, beside the reference and beside Embree alone on the same boxes.
namespace arcway {
namespace {

constexpr std::size_t kSegments = 1 << 14;

// From random points, up to the length that crosses about ten obstacles' spacings.
std::vector<LineSegment> random_segments(const World& world) {
  Random random(1);
  const Box& box = world.box();
  const double reach = 10.0 * (box.max - box.min).maxCoeff() / std::sqrt(static_cast<double>(world.obstacle_count()));
  std::vector<LineSegment> segments;
  while (segments.size() < kSegments) {
    const Vec2 a(random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()));
    const Vec2 b = a + random.uniform(0.0, reach) * random.unit_vector();
    if (box.contains(b)) segments.push_back({a, b});
  }
  return segments;
}

void time_visibility(benchmark::State& state, const VisibilityQuery& visibility,
                     const std::vector<LineSegment>& segments) {
  std::vector<std::uint8_t> visible(segments.size());
  for (auto _ : state) {
    visibility.visible(segments, visible);
    benchmark::DoNotOptimize(visible.data());
  }
  double seen = 0.0;
  for (const std::uint8_t v : visible) seen += v;
  state.counters["seen"] = seen / static_cast<double>(segments.size());
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(segments.size()), benchmark::Counter::kIsIterationInvariantRate);
}

bool answers_agree(const World& world, const VisibilityQuery& visibility, const std::vector<LineSegment>& segments) {
  const QuerySet reference = make_reference_queries(world);
  for (std::size_t i = 0; i < 1000; ++i)
    if (visibility.visible(segments[i]) != reference.visibility->visible(segments[i])) return false;
  return true;
}

void Visibility_embree(benchmark::State& state) {
  const World& world = clutter_of(static_cast<std::size_t>(state.range(0)));
  const std::vector<LineSegment> segments = random_segments(world);
  EmbreeOptions options;
  if (state.range(1) > 0) options.batches = std::make_shared<TbbExecutor>(state.range(1));
  const QuerySet queries = make_embree_queries(world, options);
  if (!answers_agree(world, *queries.visibility, segments)) return state.SkipWithError("differs from the reference");
  time_visibility(state, *queries.visibility, segments);
}

void Visibility_reference(benchmark::State& state) {
  const World& world = clutter_of(static_cast<std::size_t>(state.range(0)));
  std::vector<LineSegment> segments = random_segments(world);
  segments.resize(256);
  time_visibility(state, *make_reference_queries(world).visibility, segments);
}

struct AlwaysNo {
  bool operator()(VertexId) const { return false; }
};

// The same rays through the same boxes with a callback that refuses every edge.
void Visibility_raw_embree(benchmark::State& state) {
  const World& world = clutter_of(static_cast<std::size_t>(state.range(0)));
  const std::vector<LineSegment> segments = random_segments(world);
  const embree::RayScene<AlwaysNo> scene(std::make_shared<const embree::Device>(), world, 0.0);
  for (auto _ : state) {
    for (const LineSegment& s : segments) benchmark::DoNotOptimize(scene.any(s.a, s.b, {}));
  }
  state.counters["rays/s"] =
      benchmark::Counter(static_cast<double>(segments.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void edge_counts(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("edges");
  for (const int edges : {1'000, 10'000, 100'000}) benchmark->Arg(edges);
}

void edge_and_thread_counts(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"edges", "threads"})->UseRealTime()->MeasureProcessCPUTime();
  for (const int edges : {1'000, 10'000, 100'000})
    for (const int threads : {0, 1, 2}) benchmark->Args({edges, threads});
}

BENCHMARK(Visibility_embree)->Apply(edge_and_thread_counts);
BENCHMARK(Visibility_raw_embree)->Apply(edge_counts);
BENCHMARK(Visibility_reference)->Apply(edge_counts);

}  // namespace
}  // namespace arcway
