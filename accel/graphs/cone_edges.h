#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "accel/expansion/sleeves.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// Work done by tangent-cone expansion.
struct ExpansionCounts {
  std::uint64_t steps = 0;       ///< triangles entered
  std::uint64_t candidates = 0;  ///< edges tested against invalid regions
};

/// What nodes are expanded through: a triangulation with its sleeves and fans, which are crossed in one step each.
struct ExpansionInput {
  const FreeSpaceTriangulation& triangulation;
  const Sleeves& sleeves;
  const LongFans& fans;
};

/// Nodes [first, last).
struct NodeRange {
  std::size_t first, last;
};

/// Edges to the right of some nodes, by tangent-cone expansion. After all nodes, each edge is in one list once.
/// @return lists in the order of the nodes, the same for any executor.
std::vector<EdgeList> cone_edges(const ExpansionInput& input, NodeRange nodes, const Executor& executor,
                                 ExpansionCounts* counts = nullptr);

}  // namespace arcway::internal
