#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/executor.h"
#include "core/graph/visibility_graph.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// What World::changed did to a world, as the graphs see it.
struct WorldChange {
  /// @param removed  as given to World::changed, which made `after` of `before`.
  WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed);

  std::vector<VertexId> moved;    ///< by vertex of `before`: the same one in `after`, or kNone
  std::vector<Box> gone, come;    ///< around obstacles removed and added
  VertexId first_come, end_come;  ///< vertices of those added
};

/// The reduced visibility graph after a change, the same as built anew: rows of vertices that see where something was,
/// or whose edges meet where something is now, are walked again, all others are kept. The world after it is
/// triangulated anew.
/// @param graph  of the world before.
/// @param rows   how many rows were walked again, if wanted.
VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor = SerialExecutor(),
                                                std::size_t* rows = nullptr);

}  // namespace arcway
