#pragma once

#include <functional>
#include <memory>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway {

/// What a planner is made with: the queries about one map, the builders of its reduced visibility graph, and the
/// executor that both run on. All backends give the same answers and graphs, bit for bit; they differ in time.
///
///     const Planner planner(world, vehicle, accel_backend(world));
///
/// Copies share all. Thread-safe.
class ARCWAY_API Backend {
 public:
  using Graph = std::shared_ptr<const VisibilityGraph>;
  /// How the parts are made, from what the backend has: each when a planner first needs it. All throw Canceled if the
  /// executor's clock is over.
  struct Parts {
    std::function<QuerySet(const Backend&)> queries;
    /// The whole reduced graph; none: only rows.
    std::function<Graph(const Backend&)> reduced_graph = nullptr;
    /// Its rows, each found when it is first asked for; none: only whole graphs.
    std::function<std::shared_ptr<const VisibilityRows>(const Backend&)> lazy_rows = nullptr;
    /// The reduced graph from that of the world before a change; none: built anew.
    std::function<Graph(const Backend&, const VisibilityGraph& before, const WorldChange&)> changed_graph = nullptr;
  };

  /// @param executor  of the parts, and of the construction of planners; must outlive that.
  /// @throws std::invalid_argument if there is no maker of queries, or neither of graphs nor of rows.
  Backend(const World& world, Parts parts, const Executor& executor);
  /// The same, and keeps the executor.
  Backend(const World& world, Parts parts, std::shared_ptr<const Executor> executor);

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Executor& executor() const;
  /// Made by the first call, and kept.
  /// @throws std::invalid_argument if one of them is missing.
  [[nodiscard]] const QuerySet& queries() const;
  /// Whether searches need not wait for a whole reduced graph.
  [[nodiscard]] bool has_lazy_rows() const;
  [[nodiscard]] bool has_graphs() const;
  /// Precondition: has_lazy_rows().
  [[nodiscard]] std::shared_ptr<const VisibilityRows> lazy_rows() const;
  /// Precondition: has_graphs().
  [[nodiscard]] Graph reduced_graph() const;
  /// The same graph, sooner: of what is far from the change the rows are kept.
  /// @param change  from the world of `before` to this one.
  [[nodiscard]] Graph changed_graph(const VisibilityGraph& before, const WorldChange& change) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Brute force on one thread: the reference of all others. O(n^2) pairs of vertices, each against all edges: for maps
/// of some hundred vertices.
ARCWAY_API Backend reference_backend(const World& world);

/// Parts that were made elsewhere: for those who measure or test one of them alone.
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, const Executor& executor = kSerialExecutor);
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, VisibilityGraph graph,
                              const Executor& executor = kSerialExecutor);
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, std::shared_ptr<const VisibilityRows> rows,
                              const Executor& executor = kSerialExecutor);

}  // namespace arcway
