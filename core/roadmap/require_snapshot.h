#pragma once

#include <cstddef>

#include "arcway/feasible_graph_snapshot.h"

namespace arcway::internal {

/// Checks sizes, ranges and order of a snapshot. Whether headings and lengths are right is not checked.
/// @param circles  number of circles of the graph.
/// @throws SnapshotError for the first entry that no graph can have.
void require_snapshot(const FeasibleGraphSnapshot& known, std::size_t circles);

}  // namespace arcway::internal
