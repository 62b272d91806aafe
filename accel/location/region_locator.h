#pragma once

#include <cstdint>
#include <vector>

#include "arcway/world.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Finds the region that contains a point strictly inside. The answer is exact: that of trying all regions with
/// World::locate.
///
/// A tree over the regions' boxes, and for regions of many vertices a tree over their edges. O(log regions + vertices
/// of small regions around + edges of large regions that the ray in +x direction meets). No allocation, thread-safe.
class RegionLocator {
 public:
  explicit RegionLocator(const World& world);

  /// The first region, in id order, with p strictly inside, or kNone. The bounds contain what is strictly outside of
  /// them.
  [[nodiscard]] ObstacleId containing(const Vec2& p) const;

 private:
  [[nodiscard]] bool is_inside(const Vec2& p, ObstacleId region) const;

  World world_;
  BoxTree obstacles_;
  std::vector<BoxTree> edge_trees_;
  std::vector<std::uint32_t> tree_of_;  // region -> edge_trees_, kNone for small regions
};

}  // namespace arcway::internal
