#pragma once

#include <cstddef>

#include "arcway/feasible_tables.h"

namespace arcway::internal {

/// Sizes and ranges; what headings and lengths are is taken as it comes.
/// @param circles  of the graph.  @throws TableError for the first entry that cannot be.
void require_tables(const FeasibleTables& known, std::size_t circles);

}  // namespace arcway::internal
