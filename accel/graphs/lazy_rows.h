#pragma once

#include <memory>

#include "arcway/executor.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Rows of the reduced visibility graph, each computed by tangent-cone expansion when it is first asked for. A first
/// query on a large map needs only few of them; accel_backend gives them to its planners.
///
/// Triangulates free space, see TangentNeighbors for cost and limits. Each row is kept once, as long as the result
/// lives. All rows take 8 bytes an edge of the graph and about 60 bytes a vertex. Thread-safe.
std::shared_ptr<const VisibilityRows> make_lazy_rows(const World& world, const Executor& executor = SerialExecutor());

}  // namespace arcway::internal
