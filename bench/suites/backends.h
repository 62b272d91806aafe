#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "arcway/executor.h"
#include "arcway/query_set.h"
#include "arcway/stop_clock.h"
#include "arcway/visibility_graph.h"

namespace arcway::internal::bench {

/// An implementation of the queries.
struct QueryBackend {
  std::string name;
  /// Ends at the clock where making them takes long: Canceled is thrown.
  std::function<QuerySet(const World&, const StopClock&)> make;
  /// What benchmarks use: `make`, or with one answer wrong if that is asked for.
  [[nodiscard]] QuerySet queries(const World& world) const;
};
/// All implementations, the reference first.
const std::vector<QueryBackend>& query_backends();

/// A builder of visibility graphs as benchmarks measure it: it also makes the queries that it needs.
struct MeasuredBuilder {
  std::string name;
  std::function<VisibilityGraph(const World&, const Executor&)> build;
  std::string law;  ///< growth in obstacles n at constant density, as theory has it
  double exponent;  ///< exponent of that law
  /// What benchmarks use: `build`, or with an edge missing if that is asked for.
  [[nodiscard]] VisibilityGraph graph(const World& world, const Executor& executor) const;
};
/// Builders of the reduced visibility graph; the reference first.
const std::vector<MeasuredBuilder>& graph_builders();
/// Builders of the full visibility graph; the reference first.
const std::vector<MeasuredBuilder>& full_graph_builders();

/// An executor for this many threads; the serial one for 1.
std::unique_ptr<Executor> make_executor(std::size_t threads);
/// Numbers of threads worth measuring in this build: 1, and 2 with oneTBB.
std::vector<std::size_t> thread_counts();

}  // namespace arcway::internal::bench
