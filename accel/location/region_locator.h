#pragma once

#include <cstdint>
#include <vector>

#include "arcway/world.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Which region has a point strictly inside? Exact, the same as trying all regions with World::locate, by a tree over
/// their boxes, and for regions of many vertices one over their edges. O(log regions + vertices of small regions
/// around + edges of large ones that the ray in +x direction meets); no allocation, thread-safe.
class RegionLocator {
 public:
  explicit RegionLocator(const World& world);

  /// The first region, in id order, that has p strictly inside (for the bounds: strictly outside of them), or kNone.
  [[nodiscard]] ObstacleId containing(const Vec2& p) const;

 private:
  [[nodiscard]] bool is_inside(const Vec2& p, ObstacleId region) const;

  World world_;
  BoxTree obstacles_;
  std::vector<BoxTree> edge_trees_;
  std::vector<std::uint32_t> tree_of_;  // region -> edge_trees_, kNone for small ones
};

}  // namespace arcway::internal
