#pragma once

#include <cstdint>
#include <span>

#include "accel/triangulation/triangulation.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// Which diagonals are worth a flip.
enum class Diagonals : std::uint8_t {
  kAll,  ///< all that become shorter: for maps where each is crossed by many lines of sight, or that are kept
  kLong  ///< long ones, and those that become much shorter: half as many flips
};

/// Flips diagonals that become shorter by it: the fewer and shorter the diagonals on the way, the fewer steps of a
/// walk. A flip is made only if rounded arithmetic is sure that it may be: any triangulation is correct, so nothing
/// exact is needed. Up to two flips a vertex. Blocks of triangles first, side by side, then the seams between them: the
/// same result for any executor.
void shorten_diagonals(std::span<const Vec2> points, Triangulation& triangulation, Diagonals which,
                       const Executor& executor);

}  // namespace arcway::internal
