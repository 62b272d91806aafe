#pragma once

#include <memory>
#include <span>

#include "arcway/executor.h"
#include "arcway/world_change.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/finished_feasible_graph.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

/// The graph after a change of the world, the same as one built anew. Where no obstacle was added or removed,
/// results are taken from the graph before, as far as that one has them. The rest is checked. O(n) beside that.
/// @param before  of the world before the change, the same vehicle and the same radii. All of its rows of the reduced
///   graph are asked for.
/// @param after   inputs after the change. All rows are asked for.
[[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> change_feasible_graph(const FeasibleGraph& before,
                                                                                 const FeasibleGraphInputs& after,
                                                                                 const WorldChange& change,
                                                                                 const Executor& executor);

/// A lazy graph after a change of the world, from one that knows all rows of the reduced graph or can find them. It
/// knows what change_feasible_graph would take from the graph before.
[[nodiscard]] std::shared_ptr<const LazyFeasibleGraph> change_lazy_feasible_graph(const FeasibleGraph& before,
                                                                                  const FeasibleGraphInputs& after,
                                                                                  const WorldChange& change,
                                                                                  const Executor& executor);

/// A lazy graph after a change of the world, from a lazy one without added circles, without asking for rows of the
/// reduced graph. It takes headings and rows of links from what graphs before changes have found, when they are first
/// asked for: see FoundBefore.
/// @param may_differ  see VisibilityRows::Changed.
[[nodiscard]] std::shared_ptr<const LazyFeasibleGraph> change_lazy_feasible_graph(const LazyFeasibleGraph& before,
                                                                                  const FeasibleGraphInputs& after,
                                                                                  const WorldChange& change,
                                                                                  std::span<const VertexId> may_differ);

}  // namespace arcway::internal
