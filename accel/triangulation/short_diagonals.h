#pragma once

#include <span>

#include "accel/triangulation/triangulation.h"
#include "core/executor.h"

namespace [[gnu::visibility("default")]] arcway {

/// Flips diagonals that become much shorter by it: the fewer and shorter the diagonals on the way, the fewer steps of a
/// walk. A flip is made only if rounded arithmetic is sure that it may be: any triangulation is correct, so nothing
/// exact is needed. About two flips a vertex. Blocks of triangles first, side by side, then the seams between them: the
/// same result for any executor.
void shorten_diagonals(std::span<const Vec2> sites, Triangulation& triangulation, const Executor& executor);

}  // namespace arcway
