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

/// How a planner gets its geometry: queries about one map, builders of its reduced visibility graph, and the executor
/// that runs both. All backends give the same answers and graphs, bit for bit; they differ in time.
///
///     const Planner planner(world, vehicle, accel_backend(world));
///
/// Copies share everything. Thread-safe.
class ARCWAY_API Backend {
 public:
  using Graph = std::shared_ptr<const VisibilityGraph>;
  /// Functions that make the parts of a backend. Each is called when a planner first needs its part, and gets the
  /// backend. All throw Canceled if the executor's clock is over.
  struct Parts {
    /// The queries; required.
    std::function<QuerySet(const Backend&)> queries;
    /// The reduced visibility graph; empty: the backend has only rows.
    std::function<Graph(const Backend&)> reduced_graph = nullptr;
    /// The rows of that graph, each computed when first asked for; empty: the backend has only whole graphs.
    std::function<std::shared_ptr<const VisibilityRows>(const Backend&)> lazy_rows = nullptr;
    /// The reduced graph after a change, from that of the world before; empty: the graph is built anew.
    std::function<Graph(const Backend&, const VisibilityGraph& before, const WorldChange&)> changed_graph = nullptr;
    /// The parts for the world after a change. They may use what this backend has made. Empty: `changed` is refused.
    std::function<Parts(const Backend& before, const World& after, const WorldChange&)> changed_parts = nullptr;
  };

  /// @param executor  runs the functions above and the construction of planners; must outlive both.
  /// @throws std::invalid_argument if there is no maker of queries, or neither one of graphs nor one of rows.
  Backend(const World& world, Parts parts, const Executor& executor);
  /// Overload that shares the ownership of the executor.
  Backend(const World& world, Parts parts, std::shared_ptr<const Executor> executor);

  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Executor& executor() const;
  /// The queries: made by the first call, and kept.
  /// @throws std::invalid_argument if the maker leaves one of them null.
  [[nodiscard]] const QuerySet& queries() const;
  /// Whether rows are computed one by one, so that the first search need not wait for the whole reduced graph.
  [[nodiscard]] bool has_lazy_rows() const;
  /// Whether the backend builds whole reduced graphs.
  [[nodiscard]] bool has_graphs() const;
  /// Rows that are computed when first asked for. Precondition: has_lazy_rows().
  [[nodiscard]] std::shared_ptr<const VisibilityRows> lazy_rows() const;
  /// The reduced visibility graph, built by each call. Precondition: has_graphs().
  [[nodiscard]] Graph reduced_graph() const;
  /// The reduced visibility graph of this world from that of the world before a change. It equals reduced_graph(), bit
  /// for bit, and takes less time: rows far from the change are kept. Precondition: has_graphs().
  /// @param change  from the world of `before` to this one.
  [[nodiscard]] Graph changed_graph(const VisibilityGraph& before, const WorldChange& change) const;
  /// A backend of the same kind, with the same executor, for the world after a change.
  /// @param change  from this world to `after`.
  /// @throws std::invalid_argument if the parts of this backend are of its world alone, as those of backend_of.
  [[nodiscard]] Backend changed(const World& after, const WorldChange& change) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// The brute-force backend on one thread: the reference that all others are tested against. O(n^2) pairs of vertices,
/// each against all edges: for maps of some hundred vertices.
ARCWAY_API Backend reference_backend(const World& world);

/// Backends of parts that exist already, for tests and measurements of single parts. They cannot be changed.
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, const Executor& executor = kSerialExecutor);
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, VisibilityGraph graph,
                              const Executor& executor = kSerialExecutor);
ARCWAY_API Backend backend_of(const World& world, const QuerySet& queries, std::shared_ptr<const VisibilityRows> rows,
                              const Executor& executor = kSerialExecutor);

}  // namespace arcway
