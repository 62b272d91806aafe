#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// How the vertices of two worlds correspond after World::changed, for graphs that are updated.
struct ARCWAY_API WorldChange {
  /// @param removed  as given to before.changed(removed, added), which returned `after`. O(n).
  /// @throws std::invalid_argument if the remaining obstacles and the bounds are not those of `after`, in their order;
  ///   if that call was not made, in front of the added ones. Graphs of such a change would differ from new ones.
  WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed);
  /// A change by before.changed(removed, added), which returned `after`. Obstacles that remain are not looked at, so
  /// that it takes time by what changed only. Precondition: that call was made.
  [[nodiscard]] static WorldChange unchecked(const World& before, const World& after,
                                             std::span<const ObstacleId> removed);

  /// The id in `after` of a vertex of `before`; kNone if it was removed. Ids of vertices that remain ascend.
  /// O(obstacles removed and added).
  [[nodiscard]] VertexId vertex_after(VertexId before) const;

  std::size_t vertices_before;                       ///< number of vertices of `before`
  std::vector<Box> removed_boxes, added_boxes;       ///< boxes of the obstacles removed and added [m]
  std::vector<World::VertexRange> removed_vertices;  ///< of each removed obstacle in `before`, ascending
  std::vector<World::VertexRange> added_vertices;    ///< of each added obstacle in `after`, ascending

 private:
  WorldChange() = default;
};

}  // namespace arcway
