#include "accel/location/region_locator.h"

#include <algorithm>

#include "core/geometry/ray_parity.h"

namespace arcway::internal {

namespace {

// Up to about this many edges, a scan is as fast as a tree.
constexpr std::size_t kScanEdges = 64;

}  // namespace

RegionLocator::Trees::Trees(const World& the_world) : world(the_world), tree_of(world.region_count(), kNone) {
  std::vector<Box> boxes;
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) boxes.push_back(world.box_of(o));
  obstacles = BoxTree(boxes);
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const auto [first, last] = world.vertices_of(o);
    if (last - first <= kScanEdges) continue;
    boxes.clear();
    for (VertexId e = first; e < last; ++e) boxes.push_back(box_of(world.edges()[e]));
    tree_of[o] = static_cast<std::uint32_t>(edge_trees.size());
    edge_trees.emplace_back(boxes);
  }
}

RegionLocator::RegionLocator(const World& world) : trees_(std::make_shared<const Trees>(world)), world_(world) {}

RegionLocator::RegionLocator(const RegionLocator& before, const World& after, const VertexMap& change)
    : trees_(before.trees_), world_(after), map_(before.map_ ? before.map_->then(change) : change) {
  std::vector<Box> boxes;
  for (const World::VertexRange& range : map_->added()) {
    added_.push_back(after.obstacle_of(range.first));
    boxes.push_back(after.box_of(added_.back()));
  }
  if (!added_.empty()) added_tree_ = BoxTree(boxes);
}

ObstacleId RegionLocator::containing(const Vec2& p) const {
  ObstacleId first = kNone;
  trees_->obstacles.visit_overlaps(Box{p, p}, [&](ObstacleId o) {
    const ObstacleId region = now(o);
    if (region < first && trees_->is_inside(p, o)) first = region;
    return true;
  });
  added_tree_.visit_overlaps(Box{p, p}, [&](std::uint32_t i) {
    if (added_[i] < first && world_.locate(p, added_[i]) == PointLocation::kInside) first = added_[i];
    return true;
  });
  if (first != kNone || !world_.has_bounds()) return first;
  const auto built_bounds = static_cast<ObstacleId>(trees_->world.obstacle_count());
  return trees_->is_inside(p, built_bounds) ? static_cast<ObstacleId>(world_.obstacle_count()) : kNone;
}

ObstacleId RegionLocator::now(ObstacleId built) const {
  if (!map_) return built;
  const VertexId vertex = map_->after(trees_->world.vertices_of(built).first);
  return vertex == kNone ? kNone : world_.obstacle_of(vertex);
}

bool RegionLocator::Trees::is_inside(const Vec2& p, ObstacleId region) const {
  if (tree_of[region] == kNone || !world.box_of(region).contains(p))
    return world.locate(p, region) == PointLocation::kInside;
  RayParity parity(p);
  const VertexId first = world.vertices_of(region).first;
  edge_trees[tree_of[region]].visit_overlaps(parity.ray_box(), [&](std::uint32_t i) {
    const LineSegment& edge = world.edges()[first + i];
    parity.add(edge.a, edge.b);
    return true;
  });
  const bool is_bounds = region == world.obstacle_count();
  return parity.location() == (is_bounds ? PointLocation::kOutside : PointLocation::kInside);
}

}  // namespace arcway::internal
