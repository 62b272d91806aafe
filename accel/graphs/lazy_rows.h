#pragma once

#include <memory>

#include "arcway/executor.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"

namespace arcway::internal {

/// The rows of the reduced visibility graph, each found by walks through its vertex's tangent cones when it is first
/// asked for: what a first query on a large map needs of it.
///
/// accel_backend makes its planners with them.
///
/// Triangulates free space, see TangentNeighbors for cost and limits. Rows are kept as long as the result lives, and
/// there is one for a vertex at most: all of them take 8 bytes an edge of the graph and about 60 a vertex. Thread-safe.
std::shared_ptr<const VisibilityRows> make_lazy_rows(const World& world, const Executor& executor = SerialExecutor());

}  // namespace arcway::internal
