#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// How the base circles of a world are numbered. It is what remains of them for worlds after changes: 4 bytes a vertex.
/// Immutable.
class CircleNumbers {
 public:
  CircleNumbers(const World& world, const TurnCircles& circles);

  /// The index that a base circle of a world after changes has here; kNone if it is not here.
  /// @param map  from this world to that one.
  [[nodiscard]] std::uint32_t before(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const;
  /// The index that a circle has after changes; kNone if it is not there.
  [[nodiscard]] std::uint32_t after(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const;

 private:
  HugeVector<VertexId> convex_;    // ascending
  std::size_t around_ = 0;         // number of circles around one vertex alone
  std::vector<TurnCircle> pairs_;  // around two vertices, by both
};

}  // namespace arcway::internal
