#include "accel/location/region_locator.h"

#include <algorithm>

#include "core/geometry/ray_parity.h"

namespace arcway::internal {

namespace {

// Up to about this many edges, a scan is as fast as a tree.
constexpr std::size_t kScanEdges = 64;

}  // namespace

RegionLocator::RegionLocator(const World& world) : world_(world), tree_of_(world.region_count(), kNone) {
  std::vector<Box> boxes;
  for (ObstacleId o = 0; o < world_.obstacle_count(); ++o) boxes.push_back(world_.box_of(o));
  obstacles_ = BoxTree(boxes);
  for (ObstacleId o = 0; o < world_.region_count(); ++o) {
    const auto [first, last] = world_.vertices_of(o);
    if (last - first <= kScanEdges) continue;
    boxes.clear();
    for (VertexId e = first; e < last; ++e) boxes.push_back(box_of(world_.edges()[e]));
    tree_of_[o] = static_cast<std::uint32_t>(edge_trees_.size());
    edge_trees_.emplace_back(boxes);
  }
}

ObstacleId RegionLocator::containing(const Vec2& p) const {
  ObstacleId first = kNone;
  obstacles_.visit_overlaps(Box{p, p}, [&](ObstacleId o) {
    if (o < first && is_inside(p, o)) first = o;
    return true;
  });
  if (first != kNone || !world_.has_bounds()) return first;
  const auto bounds = static_cast<ObstacleId>(world_.obstacle_count());
  return is_inside(p, bounds) ? bounds : kNone;
}

bool RegionLocator::is_inside(const Vec2& p, ObstacleId region) const {
  if (tree_of_[region] == kNone || !world_.box_of(region).contains(p))
    return world_.locate(p, region) == PointLocation::kInside;
  RayParity parity(p);
  const VertexId first = world_.vertices_of(region).first;
  edge_trees_[tree_of_[region]].visit_overlaps(parity.ray_box(), [&](std::uint32_t i) {
    const LineSegment& edge = world_.edges()[first + i];
    parity.add(edge.a, edge.b);
    return true;
  });
  const bool is_bounds = region == world_.obstacle_count();
  return parity.location() == (is_bounds ? PointLocation::kOutside : PointLocation::kInside);
}

}  // namespace arcway::internal
