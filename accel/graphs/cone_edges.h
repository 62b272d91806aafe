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

/// Edges to the right of the nodes [first, last), by tangent-cone expansion. After all nodes, each edge is in one list
/// once.
/// @param sleeves, fans  of the triangulation, crossed in one step each.
/// @return lists in the order of the nodes, the same for any executor.
std::vector<EdgeList> cone_edges(const FreeSpaceTriangulation& triangulation, const Sleeves& sleeves,
                                 const LongFans& fans, std::size_t first, std::size_t last, const Executor& executor,
                                 ExpansionCounts* counts = nullptr);

}  // namespace arcway::internal
