#pragma once

#include <memory>

#include "arcway/feasible_graph_snapshot.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal {

/// The graph whose tables these are. Checks no heading and no link again.
/// @throws SnapshotError if the tables are not those of such a graph: a value out of range or order.
[[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> restore_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                                  FeasibleGraphSnapshot tables);

}  // namespace arcway::internal
