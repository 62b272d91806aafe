#pragma once

#include <span>

#include "accel/triangulation/triangulation.h"
#include "core/executor.h"

namespace [[gnu::visibility("default")]] arcway {

/// Flips diagonals towards the constrained Delaunay triangulation, whose compact triangles keep walks short. A flip is
/// made only if rounded arithmetic is sure of it: any triangulation is correct, so nothing exact is needed. About two
/// flips a vertex. Blocks of triangles first, side by side, then the seams between them: the same result for any
/// executor.
void flip_towards_delaunay(std::span<const Vec2> sites, Triangulation& triangulation, const Executor& executor);

}  // namespace arcway
