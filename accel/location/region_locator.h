#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "arcway/world.h"
#include "core/geometry/box_tree.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// Finds the region that contains a point strictly inside. The answer is exact: that of trying all regions with
/// World::locate.
///
/// A tree over the regions' boxes, and for regions of many vertices a tree over their edges. O(log regions + vertices
/// of small regions around + edges of large regions that the ray in +x direction meets). No allocation, thread-safe.
class RegionLocator {
 public:
  explicit RegionLocator(const World& world);
  /// The locator of a world after a change, in time that depends on the change only. It shares the trees that were
  /// built, passes over removed regions and has a tree of added ones.
  RegionLocator(const RegionLocator& before, const World& after, const VertexMap& change);

  /// The first region, in id order, with p strictly inside, or kNone. The bounds contain what is strictly outside of
  /// them.
  [[nodiscard]] ObstacleId containing(const Vec2& p) const;

 private:
  struct Trees {
    explicit Trees(const World& world);
    [[nodiscard]] bool is_inside(const Vec2& p, ObstacleId region) const;

    World world;
    BoxTree obstacles;
    std::vector<BoxTree> edge_trees;
    std::vector<std::uint32_t> tree_of;  // region -> edge_trees, kNone for small regions
  };
  // The region of the world as it is now that was this one when the trees were built; kNone if it was removed.
  [[nodiscard]] ObstacleId now(ObstacleId built) const;

  std::shared_ptr<const Trees> trees_;
  World world_;
  std::optional<VertexMap> map_;   // from the world of the trees, if it was changed since
  std::vector<ObstacleId> added_;  // that are not in the trees
  BoxTree added_tree_;             // of these
};

}  // namespace arcway::internal
