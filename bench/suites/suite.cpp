#include "bench/suites/suite.h"

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "arcway/datasets/catalog.h"
#include "bench/cpu_clock.h"
#include "bench/suites/run_policy.h"

namespace arcway::internal::bench {
namespace {

struct Registered {
  void (*add)(Study);
  Takes part;
};

std::vector<Registered>& registered() {
  static std::vector<Registered> suites;
  return suites;
}

std::string number_text(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return std::to_string(static_cast<long long>(value));
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

}  // namespace

Suite::Suite(void (*add)(Study), Takes part) { registered().push_back({add, part}); }

void add_all_suites(Study study) {
  for (const Registered& suite : registered()) {
    if (study != Study::kQuick || suite.part == Takes::kAll) suite.add(study);
  }
}

benchmark::internal::Benchmark* add_benchmark(const std::string& name, Body body) {
  auto* added = benchmark::RegisterBenchmark(name.c_str(), std::move(body));
  return added->UseRealTime()->MeasureProcessCPUTime();
}

void set_batch(benchmark::State& state, std::size_t answers) { state.counters["batch"] = static_cast<double>(answers); }

bool require(benchmark::State& state, bool right, std::string_view what) {
  if (!right) state.SkipWithError(std::string(what).c_str());
  return right;
}

bool require_once(benchmark::State& state, const std::string& key, const std::function<bool()>& right,
                  std::string_view what) {
  static std::map<std::string, bool> known;
  const auto found = known.find(key);
  return require(state, found != known.end() ? found->second : known.emplace(key, right()).first->second, what);
}

struct Series::State {
  std::string law;
  double exponent;
  double budget;           // time of one iteration with world and check [s]
  double last_size = 0.0;  // seconds of the last size that ran
  double last_seconds = 0.0;
  bool over = false;
};

Series::Series(Study study, std::string name, std::string size_name, std::string law, double exponent)
    : name_(std::move(name)), size_name_(std::move(size_name)), state_(std::make_shared<State>()) {
  state_->law = std::move(law);
  state_->exponent = exponent;
  state_->budget = size_budget(study);
}

Series& Series::allow(double seconds) {
  state_->budget += seconds;
  return *this;
}

benchmark::internal::Benchmark* Series::add(double size, Body body) {
  const auto run = [series = state_, size, body = std::move(body)](benchmark::State& state) {
    const double expected =
        series->last_size > 0.0 ? series->last_seconds * std::pow(size / series->last_size, series->exponent) : 0.0;
    if (size > series->last_size && (series->over || expected > series->budget)) {
      series->over = true;
      skip_for_budget(state, expected, series->budget);
      return;
    }
    state.SetLabel(series->law);
    const CpuClock clock(CpuClock::Of::kProcess);
    body(state);
    if (state.max_iterations > 1) return;  // a repetition
    series->last_seconds = clock.seconds();
    series->last_size = size;
  };
  return add_benchmark(name_ + "/" + size_name_ + ":" + number_text(size), run);
}

const World& shared_world(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, World, std::less<>> worlds;
  const std::lock_guard lock(mutex);
  const auto found = worlds.find(name);
  return found != worlds.end() ? found->second : worlds.emplace(std::string(name), catalog_world(name)).first->second;
}

std::string clutter_name(std::string_view kind, std::size_t obstacles, std::size_t vertices, int fill_percent,
                         std::uint64_t seed) {
  return "clutter/" + std::string(kind) + "/n" + std::to_string(obstacles) + "/m" + std::to_string(vertices) + "/f" +
         std::to_string(fill_percent) + "/s" + std::to_string(seed);
}

std::vector<std::size_t> sizes(Study study, std::initializer_list<std::size_t> values, std::size_t check_limit,
                               std::size_t quick_limit) {
  std::vector<std::size_t> kept;
  for (const std::size_t value : values) {
    if (study == Study::kCheck && value > check_limit) continue;
    if (study == Study::kQuick && value > quick_limit) continue;
    kept.push_back(value);
  }
  return kept;
}

}  // namespace arcway::internal::bench
