#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/suites/allocations.h"
#include "bench/suites/backends.h"
#include "bench/suites/suite.h"
#include "bench/suites/work.h"
#include "core/roadmap/build_feasible_graph.h"
#include "core/roadmap/lazy_feasible_graph.h"
#include "datasets/io/random.h"

namespace arcway::internal::bench::feasible_graph_suite {
namespace {

struct Case {
  std::string world;
  std::size_t radii = 1;
  std::size_t threads = 1;
};

std::vector<double> radii_of(std::size_t count) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i)
    radii.push_back(Vehicle().min_turning_radius() * (1.0 + 0.5 * static_cast<double>(i)));
  return radii;
}

/// The fastest builder's graph: they all give the same.
const VisibilityGraph& reduced_graph(const std::string& world_name) {
  static std::map<std::string, VisibilityGraph> graphs;
  const auto found = graphs.find(world_name);
  if (found != graphs.end()) return found->second;
  return graphs.emplace(world_name, graph_builders().back().build(shared_world(world_name), SerialExecutor()))
      .first->second;
}

bool same_links(std::span<const FeasibleGraph::Link> a, std::span<const FeasibleGraph::Link> b) {
  return std::ranges::equal(a, b, [](const FeasibleGraph::Link& x, const FeasibleGraph::Link& y) {
    return x.from == y.from && x.to == y.to && x.heading == y.heading && x.length == y.length;
  });
}

/// Whether a graph is the one that the reference builds: whole up to 4,000 vertices, above it the links that leave some
/// circles, which a lazy graph on the reference decides one by one.
bool is_right(const FinishedFeasibleGraph& graph, const World& world, const VisibilityGraph& reduced,
              const std::vector<double>& radii) {
  constexpr std::size_t kWholeUpTo = 4'000, kCircles = 12;
  const FeasibleGraphInputs inputs{world, Vehicle(), rows_of(world, reduced), make_reference_queries(world), radii};
  if (world.vertices().size() <= kWholeUpTo)
    return same_links(graph.links(), build_feasible_graph(inputs, SerialExecutor())->links());
  const LazyFeasibleGraph reference(inputs, SerialExecutor());
  Random random(1);
  for (std::size_t i = 0; i < kCircles; ++i) {
    const auto circle = static_cast<std::uint32_t>(random.below(graph.circles().size()));
    std::vector<FeasibleGraph::Link> kept;
    const auto links = reference.links_from(circle);
    for (std::size_t k = 0; k < links.size(); ++k)
      if (reference.is_kept(circle, k)) kept.push_back(links[k]);
    if (!same_links(graph.links_from(circle), kept)) return false;
  }
  return true;
}

void build(benchmark::State& state, const QueryBackend& backend, const Case& c) {
  const World& world = shared_world(c.world);
  const VisibilityGraph& reduced = reduced_graph(c.world);
  const Vehicle vehicle;
  const std::vector<double> radii = radii_of(c.radii);
  const std::unique_ptr<Executor> executor = make_executor(c.threads);
  const QuerySet queries = backend.queries(world);
  const auto build_once = [&] {
    return build_feasible_graph({world, vehicle, rows_of(world, reduced), queries, radii}, *executor);
  };

  reset_heap_peak();
  const HeapUse before = heap_use();
  std::shared_ptr<const FinishedFeasibleGraph> graph = build_once();
  const HeapUse after = heap_use();
  const auto right = [&] { return is_right(*graph, world, reduced, radii); };
  const std::string key = backend.name + c.world + std::to_string(c.radii) + "/" + std::to_string(c.threads);
  if (!require_once(state, "FeasibleGraph/" + key, right, "links differ from the reference")) return;
  const LoopWork work;
  for ([[maybe_unused]] auto _ : state) graph = build_once();
  if (c.threads == 1) work.count(state, "graph");  // several threads share the work out as they come

  const auto vertices = static_cast<double>(world.vertices().size());
  state.counters["vertices"] = vertices;
  state.counters["links"] = static_cast<double>(graph->links().size());
  state.counters["bytes_per_vertex"] = static_cast<double>(after.live_bytes - before.live_bytes) / vertices;
  state.counters["peak_bytes_per_vertex"] = static_cast<double>(after.peak_bytes - before.live_bytes) / vertices;
}

void add(Study study) {
  for (const QueryBackend& backend : query_backends()) {
    const bool reference = backend.name == "reference";
    const std::string law = reference ? "O(k n) for k bitangents among n edges" : "O(k log n) for k bitangents";
    const double exponent = reference ? 2.0 : 1.1;
    const std::string stage = "FeasibleGraph/" + backend.name;
    Series by_obstacles(study, stage, "obstacles", law, exponent);
    if (!reference) by_obstacles.allow(6.0);
    for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 3162, 10000}, 10, 1000))
      by_obstacles.add(static_cast<double>(n), [&backend, n](benchmark::State& state) {
        build(state, backend, {clutter_name("convex", n, 10, 30)});
      });
    if (study == Study::kQuick) continue;
    Series by_radii(study, stage + "/n:100", "radii", "O(r^2) pairs of radii an edge", 2.0);
    for (const std::size_t r : sizes(study, {1, 2, 3, 5, 8}, 1, reference ? 5 : 8))
      by_radii.add(static_cast<double>(r), [&backend, r](benchmark::State& state) {
        build(state, backend, {clutter_name("convex", 100, 10, 30), r});
      });
    const std::size_t shared = study == Study::kCheck ? 10 : 316;
    Series by_threads(study, stage + "/n:" + std::to_string(shared), "threads", "1 / threads", 0.0);
    for (const std::size_t t : thread_counts())
      by_threads.add(static_cast<double>(t), [&backend, shared, t](benchmark::State& state) {
        build(state, backend, {clutter_name("convex", shared, 10, 30), 1, t});
      });
  }
}

const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::feasible_graph_suite
