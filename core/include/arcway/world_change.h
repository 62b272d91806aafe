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

  std::vector<VertexId> moved;    ///< by vertex of `before`: the same vertex in `after`, or kNone; ascending
  std::vector<Box> gone, come;    ///< boxes of the obstacles removed and added [m]
  VertexId first_come, end_come;  ///< range of the added obstacles' vertices in `after`
};

}  // namespace arcway
