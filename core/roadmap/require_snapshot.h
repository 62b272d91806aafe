#pragma once

#include <cstddef>

#include "arcway/feasible_graph_snapshot.h"

namespace arcway::internal {

/// Sizes and ranges; what headings and lengths are is taken as it comes.
/// @param circles  of the graph.  @throws SnapshotError for the first entry that cannot be.
void require_snapshot(const FeasibleGraphSnapshot& known, std::size_t circles);

}  // namespace arcway::internal
