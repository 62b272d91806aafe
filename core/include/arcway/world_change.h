#pragma once

#include <span>
#include <vector>

#include "arcway/export.h"
#include "arcway/world.h"

namespace arcway {

/// What World::changed did to a world, as the graphs see it.
struct ARCWAY_API WorldChange {
  /// @param removed  as given to World::changed, which made `after` of `before`.
  WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed);

  std::vector<VertexId> moved;    ///< by vertex of `before`: the same one in `after`, or kNone; ascending
  std::vector<Box> gone, come;    ///< around obstacles removed and added
  VertexId first_come, end_come;  ///< vertices of those added
};

}  // namespace arcway
