#pragma once

#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"

namespace arcway::internal::bench {

/// Whether every measured implementation shall get one answer wrong (`--corrupt`). Shows that no benchmark times wrong
/// answers: each one that compares must fail then.
bool corrupting();
void set_corrupting(bool on);

/// The graph without its middle edge.
VisibilityGraph corrupted(const VisibilityGraph& graph);
/// Queries whose first answer of each call is wrong: visible and not, free and not, a distance and no headings.
QuerySet corrupted(QuerySet queries);

}  // namespace arcway::internal::bench
