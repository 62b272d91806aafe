#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "arcway/world.h"

namespace arcway::internal::bench {

/// How much is run: `check` each benchmark once, small, to see that its answers are right; `quick` what plans cost and
/// how good they are, some two minutes; `full` everything, up to an hour.
enum class Study { kCheck, kQuick, kFull };

/// Which studies a suite takes part in: a quick one leaves out what explains the planner instead of measuring its
/// plans.
enum class Takes { kAll, kAllButQuick };

/// A file of benchmarks. A static instance makes `add` be called once the study is known:
///
///     void add(Study study) { add_benchmark("Predicates/orientation/random", [](benchmark::State& state) {...}); }
///     const Suite suite(add);
class Suite {
 public:
  explicit Suite(void (*add)(Study), Takes part = Takes::kAll);
};
/// Calls the suites that take part, in the order of their sources' names.
void add_all_suites(Study study);

using Body = std::function<void(benchmark::State&)>;

/// Registers a benchmark that reports wall time, and the processor time of all threads.
/// @param name  Stage/variant/fixed:value/size:value. What stands before the last `key:value` is a series, which the
///   report fits over that key.
benchmark::internal::Benchmark* add_benchmark(const std::string& name, Body body);

/// Says how many answers an iteration gives: the report's times are for one.
void set_batch(benchmark::State& state, std::size_t answers);

/// Ends a benchmark with an error unless its answer is right. To be called before the timed loop:
///
///     if (!require(state, graph == reference, "edges differ from the reference")) return;
bool require(benchmark::State& state, bool right, std::string_view what);
/// `require` for checks that cost much more than the benchmark. Runs once for each key, because a body is called
/// repeatedly until its timing is good enough.
bool require_once(benchmark::State& state, const std::string& key, const std::function<bool()>& right,
                  std::string_view what);

/// One series over growing sizes, which stops where the next size would take too long: judged by the last one, grown
/// by the stated law. What is left out is reported as skipped, and is no error.
class Series {
 public:
  /// @param exponent  of the law that theory gives, for the estimate.
  Series(Study study, std::string name, std::string size_name, std::string law, double exponent);

  /// Lets a size take this many seconds more: for what is prepared once and kept, or worth the time.
  Series& allow(double seconds);

  /// Registers one size. `body` runs the timed loop itself.
  benchmark::internal::Benchmark* add(double size, Body body);

 private:
  struct State;
  std::string name_, size_name_;
  std::shared_ptr<State> state_;
};

/// The world of a catalog name, built once and kept.
const World& shared_world(std::string_view name);
/// "clutter/convex/n1000/m10/f30/s1"
std::string clutter_name(std::string_view kind, std::size_t obstacles, std::size_t vertices, int fill_percent,
                         std::uint64_t seed = 1);

/// `values` up to a limit that depends on the study.
std::vector<std::size_t> sizes(Study study, std::initializer_list<std::size_t> values, std::size_t check_limit,
                               std::size_t quick_limit);

}  // namespace arcway::internal::bench
