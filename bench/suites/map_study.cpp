#include "bench/suites/map_study.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "arcway/backend.h"
#include "arcway/validation.h"
#include "bench/cpu_clock.h"
#include "bench/suites/backends.h"
#include "bench/suites/plans.h"
#include "bench/suites/quality.h"
#include "bench/suites/reporter.h"
#include "bench/suites/run_policy.h"
#include "bench/suites/suite.h"

namespace arcway::internal::bench {
namespace {

constexpr std::size_t kFirstPlans = 5;  // plans from the bare map; each prepares it anew
constexpr double kLeastSeconds = 0.1;   // of a repetition of what is short [s]

/// The benchmarks of a study, and what several of them need of one map or case.
class MapBenchmarks {
 public:
  MapBenchmarks(const MapStudy& study, const MapStudyProgress& progress)
      : study_(study), progress_(progress), executor_(kSerialExecutor, progress.stop) {}

  void add_all() {
    for (std::size_t m = 0; m < study_.maps.size(); ++m) {
      const StudiedMap& map = study_.maps[m];
      add("ReducedGraph/" + map.name, [this, &map](auto& state) { time_reduced_graph(state, map.world); });
      for (const StudiedCase& c : study_.cases) {
        if (c.map != m) continue;
        const std::string name = study_.robots[c.robot].name + "/" + map.name;
        add("FeasibleGraph/" + name, [this, &c](auto& state) { time_feasible_graph(state, c); });
        add("PlanFirst/" + name, [this, &c](auto& state) { time_first_plans(state, c); })->Iterations(1);
        add("RealMap/" + name + "/prepared", [this, &c](auto& state) { time_plans(state, c); })->Iterations(1);
      }
    }
  }

 private:
  using Run = std::function<void(benchmark::State&)>;

  benchmark::internal::Benchmark* add(const std::string& name, const Run& run) {
    const auto body = [this, name, run](benchmark::State& state) {
      current_ = name;
      has_looped_ = false;
      progress_.show(current_, 0, 1);
      try {
        if (!is_stopped()) run(state);
      } catch (const Canceled&) {  // before the loop
      }
      if (!is_stopped()) return;
      // Google Benchmark wants equal numbers of rounds in all repetitions, and counts none where no loop began.
      if (!has_looped_) loop(state, [] {});
      interrupt(state);
    };
    return add_benchmark(name, body)->Repetitions(study_.repetitions);
  }

  /// The timed loop. Its rounds do nothing after a stop request; then it returns false.
  bool loop(benchmark::State& state, const std::function<void()>& work) {
    has_looped_ = true;
    for ([[maybe_unused]] auto _ : state) {
      try {
        if (!is_stopped()) work();
      } catch (const Canceled&) {
      }
    }
    return !is_stopped();
  }

  [[nodiscard]] bool is_stopped() const { return progress_.stop.stop_requested(); }
  [[nodiscard]] const World& world_of(const StudiedCase& c) const { return study_.maps[c.map].world; }
  [[nodiscard]] const Vehicle& vehicle_of(const StudiedCase& c) const { return study_.robots[c.robot].vehicle; }
  [[nodiscard]] PlanLimits limits() const { return {.time = study_.time_limit, .stop = progress_.stop}; }

  void time_reduced_graph(benchmark::State& state, const World& world) {
    std::optional<VisibilityGraph> graph;
    if (!loop(state, [&] { graph = graph_builders().back().build(world, executor_); })) return;
    state.counters["vertices"] = static_cast<double>(world.vertices().size());
    state.counters["edges"] = static_cast<double>(graph->edge_count());
  }

  /// Queries and reduced graph of a map, made once for all of its robots.
  const Backend& graph_of(std::size_t map) {
    if (!backend_ || backend_map_ != map) {
      backend_.reset();
      const World& world = study_.maps[map].world;
      backend_ = backend_of(world, fastest_queries(world, executor_.clock()),
                            graph_builders().back().build(world, executor_), executor_);
      backend_map_ = map;
    }
    return *backend_;
  }

  void time_feasible_graph(benchmark::State& state, const StudiedCase& c) {
    const Backend& backend = graph_of(c.map);
    std::optional<Planner> planner;
    const auto build = [&] {
      planner.emplace(world_of(c), vehicle_of(c), backend, PlannerOptions{.graph_mode = GraphMode::kEager});
    };
    if (!loop(state, build)) return;
    state.counters["links"] = static_cast<double>(planner->prepare_statistics().counts.kept);
  }

  /// Ends the benchmark with an error if the validator refuses a path.
  bool check(benchmark::State& state, const StudiedCase& c, const std::vector<PlanResult>& results) {
    const Validator validator(world_of(c));
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].solved()) continue;
      const ValidationReport report =
          validated(validator, vehicle_of(c), results[i], {.reverse = c.requests[i].reverse});
      if (!require(state, report.valid(),
                   "query " + std::to_string(i) + ": the validator refuses the path: " + to_string(report)))
        return false;
    }
    return true;
  }

  void time_first_plans(benchmark::State& state, const StudiedCase& c) {
    std::vector<PlanResult> results(std::min(kFirstPlans, c.requests.size()));
    const auto plan_each = [&] {
      for (std::size_t i = 0; i < results.size(); ++i) {
        progress_.show(current_, i, results.size());
        const Planner planner = make_planner(world_of(c), vehicle_of(c), {.graph_mode = GraphMode::kLazy}, executor_);
        results[i] = planner.plan(c.requests[i], limits());
      }
    };
    if (!loop(state, plan_each)) return;
    if (!check(state, c, results)) return;
    set_batch(state, results.size());
    count_search(state, results);
    state.counters["queries"] = static_cast<double>(results.size());
    state.counters["solved"] = static_cast<double>(std::ranges::count_if(results, &PlanResult::solved));
  }

  /// The planner of a case, made and warmed up once for all repetitions.
  const Planner& prepared(const StudiedCase& c) {
    if (prepared_case_ != &c) {
      planner_.reset();
      const CpuClock clock(CpuClock::Of::kProcess);
      planner_ = make_planner(world_of(c), vehicle_of(c), {.graph_mode = GraphMode::kEager}, executor_);
      planner_->warm_up();
      prepare_seconds_ = clock.seconds();
      prepared_case_ = &c;
    }
    return *planner_;
  }

  void time_plans(benchmark::State& state, const StudiedCase& c) {
    const Planner& planner = prepared(c);
    std::vector<PlanResult> results(c.requests.size());
    const auto plan_every = [&] {
      for (std::size_t i = 0; i < results.size() && !is_stopped(); ++i) {
        progress_.show(current_, i, results.size());
        results[i] = plan_by_processor_time(planner, c.requests[i], limits());
      }
    };
    if (!loop(state, plan_every)) return;
    if (!check(state, c, results)) return;
    set_batch(state, results.size());
    count_quality(state, results);
    count_map(state, planner, prepare_seconds_, results);
  }

  const MapStudy& study_;
  const MapStudyProgress& progress_;
  const StoppableExecutor executor_;
  std::string current_;      // the name of the benchmark that runs
  bool has_looped_ = false;  // whether its timed loop has begun
  std::optional<Backend> backend_;
  std::size_t backend_map_ = 0;
  std::optional<Planner> planner_;
  const StudiedCase* prepared_case_ = nullptr;
  double prepare_seconds_ = 0.0;  // processor time of making the planner of that case
};

}  // namespace

MapStudyRun run_map_study(const MapStudy& study, const MapStudyProgress& progress) {
  std::string program = "arcway", least = with_unit("--benchmark_min_time=" + std::to_string(kLeastSeconds));
  char* arguments[] = {program.data(), least.data()};
  int count = 2;
  benchmark::Initialize(&count, arguments);
  [[maybe_unused]] static const bool has_context = (add_context(kMapStudy), true);  // kept for all runs
  MapBenchmarks benchmarks(study, progress);
  benchmarks.add_all();
  Reporter reporter(false);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();  // they know the study
  return {.json = reporter.json(), .failures = reporter.failures()};
}

}  // namespace arcway::internal::bench
