#pragma once

#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// Mean number of triangles that the expansion of a node to the right enters, from a sample of nodes.
/// @param executor  asked only whether to stop.
/// @throws Canceled if it is to stop.
double steps_per_node(const FreeSpaceTriangulation& triangulation, const Executor& executor,
                      const LongFans* fans = nullptr);

/// Long fans of a triangulation whose expansions are very long, if the fans shorten them much; else none. O(n log n).
/// @param executor  asked only whether to stop.
/// @throws Canceled if it is to stop.
LongFans worthwhile_fans(const FreeSpaceTriangulation& triangulation, const Executor& executor);

}  // namespace arcway::internal
