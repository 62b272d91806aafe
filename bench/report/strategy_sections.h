#pragma once

#include "bench/report/document.h"

namespace arcway::internal::report {

/// The rows of the planner's strategy in their order: when each is taken, what it does, and what plans are without it.
/// Cells are empty where the results have nothing of the stage "Strategy".
Section strategy_section(const Results& results);

/// The moves of refinement in their order, with the same columns.
Section moves_section(const Results& results);
/// The moves of refinement in both gears in their order, with the same columns.
Section gear_moves_section(const Results& results);

}  // namespace arcway::internal::report
