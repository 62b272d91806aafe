#pragma once

#include <cstddef>

#include "arcway/executor.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// The reduced visibility graph after a change, the same as built anew: rows of vertices that see where something was,
/// or whose edges meet where something is now, are walked again, all others are kept. The world after it is
/// triangulated anew: O(n log n) for that, and what the rows walked again cost.
/// @param graph  of the world before.
/// @param rows   how many rows were walked again, if wanted.
/// @throws std::invalid_argument if graph and change are not of the same worlds, as far as numbers of vertices tell.
VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor = SerialExecutor(),
                                                std::size_t* rows = nullptr);

}  // namespace arcway::internal
