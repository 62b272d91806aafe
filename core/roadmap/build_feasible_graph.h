#pragma once

#include <memory>

#include "arcway/executor.h"
#include "arcway/process_group.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal {

/// Checks all circles and links. See FeasibleGraphCounts for what is checked.
/// @throws std::invalid_argument if the radii are not as FeasibleGraphInputs says.
[[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> build_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                                const Executor& executor);

/// Checks a share of the circles and their links in each process. All processes get the whole graph.
[[nodiscard]] std::shared_ptr<const FinishedFeasibleGraph> build_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                                const Executor& executor,
                                                                                const ProcessGroup& process_group);

}  // namespace arcway::internal
