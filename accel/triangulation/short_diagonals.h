#pragma once

#include <cstdint>
#include <span>

#include "accel/triangulation/triangulation.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// Which diagonals are flipped.
enum class Diagonals : std::uint8_t {
  kAll,  ///< all that become shorter: for maps with many lines of sight across each, or that are kept
  kLong  ///< long ones, and those that become much shorter: half as many flips
};

/// Flips diagonals that become shorter by it. Fewer and shorter diagonals on the way mean fewer steps of an expansion.
///
/// A flip is made only if rounded arithmetic is sure that it is valid. Any triangulation gives exact results, so no
/// exact test is needed. Up to two flips a vertex. Blocks of triangles are flipped in parallel, then the seams between
/// them: the result does not depend on the executor.
void shorten_diagonals(std::span<const Vec2> points, Triangulation& triangulation, Diagonals which,
                       const Executor& executor);

}  // namespace arcway::internal
