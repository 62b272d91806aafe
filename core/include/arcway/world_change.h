#pragma once

#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// How the vertices of two worlds correspond after World::changed, for graphs that are updated.
struct ARCWAY_API WorldChange {
  /// @param removed  as given to before.changed(removed, added), which returned `after`. O(n).
  WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed);

  std::vector<VertexId> vertex_after;           ///< by vertex of `before`: its id in `after`, or kNone; ascending
  std::vector<Box> removed_boxes, added_boxes;  ///< boxes of the obstacles removed and added [m]
  VertexId first_added, end_added;              ///< range of the added obstacles' vertices in `after`
};

}  // namespace arcway
