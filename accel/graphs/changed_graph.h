#pragma once

#include <cstddef>

#include "arcway/executor.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// Updates the reduced visibility graph after a change of the world; the result equals a new build, bit for bit.
///
/// Recomputes the rows of vertices that may see where something was removed, or whose edges meet where something was
/// added. All other rows are kept. The new world is triangulated: O(n log n), plus the cost of the recomputed rows.
/// @param graph  graph of the world before the change.
/// @param rows   receives the number of recomputed rows; may be null.
/// @throws std::invalid_argument if the numbers of vertices of graph and change differ.
VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor = SerialExecutor(),
                                                std::size_t* rows = nullptr);

}  // namespace arcway::internal
