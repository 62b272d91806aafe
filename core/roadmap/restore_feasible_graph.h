#pragma once

#include <memory>

#include "arcway/feasible_graph_snapshot.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal {

/// The graph of a snapshot. Checks no heading and no link again.
/// @throws SnapshotError if a value of the snapshot is out of range or order.
[[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> restore_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                                  FeasibleGraphSnapshot snapshot);

}  // namespace arcway::internal
