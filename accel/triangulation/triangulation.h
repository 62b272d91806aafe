#pragma once

#include <cstddef>
#include <cstdint>

#include "accel/base/big_vector.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Triangles over the points of a PlanarMap.
///
/// Half-edge h = 3 t + i runs from corner i of triangle t to its next corner, counter-clockwise; `corners[h]` is the
/// point at its start.
struct Triangulation {
  BigVector<std::uint32_t> corners;  ///< by half-edge
  BigVector<std::uint32_t> twins;    ///< by half-edge: the same edge in the triangle beyond; kNone on the boundary

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] std::size_t triangle_count() const { return corners.size() / 3; }
};

}  // namespace arcway::internal
