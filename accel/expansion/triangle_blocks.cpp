#include "accel/expansion/triangle_blocks.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// The convex hull of points that ascend by (x, y), counter-clockwise [Andrew 1979].
std::vector<Vec2> convex_hull_of_sorted(std::span<const Vec2> points) {
  std::vector<Vec2> hull;
  const auto add = [&hull](const Vec2& p, std::size_t first) {
    while (hull.size() >= first + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2& p : points) add(p, 0);
  const std::size_t lower = hull.empty() ? 0 : hull.size() - 1;
  for (std::size_t i = points.size(); i-- > 0;) add(points[i], lower);
  if (hull.size() > 1) hull.pop_back();  // the first one
  return hull;
}

}  // namespace

TriangleBlocks::TriangleBlocks(const FreeSpaceTriangulation& triangulation)
    : triangles_(triangulation.half_edges().size() / 3), points_(triangulation.points().size()) {
  const std::span<const Vec2> points = triangulation.points();
  for (std::size_t i = 0; i < triangulation.half_edges().size(); ++i)
    triangles_.of(i / 3).extend(points[triangulation.half_edges()[i].point]);
  for (std::uint32_t point = 0; point < points.size(); ++point)
    for (const PlanarMap::Edge& boundary : triangulation.edges_from(point)) {
      points_.of(point).extend(points[boundary.low]);
      points_.of(point).extend(points[boundary.high]);
    }
  triangles_.make_tree();
  points_.make_tree();
  hull_ = convex_hull_of_sorted(points);
}

void TriangleBlocks::Blocks::make_tree() {
  std::vector<Box> some;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    in_tree.push_back(i);
    some.push_back(boxes[i]);
  }
  if (!some.empty()) tree = BoxTree(some);
}

TriangleBlocks::Ranges TriangleBlocks::Blocks::near(std::span<const Box> places) const {
  std::vector<std::uint32_t> found;
  for (const Box& place : places)
    tree.visit_overlaps(place, [&](std::uint32_t i) {
      found.push_back(in_tree[i]);
      return true;
    });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  Ranges ranges;
  for (const std::uint32_t block : found)
    ranges.emplace_back(static_cast<std::uint32_t>(block * kInBlock),
                        static_cast<std::uint32_t>(std::min(count, (block + 1) * kInBlock)));
  return ranges;
}

bool TriangleBlocks::hull_contains(const Box& box) const {
  for (std::size_t i = 0; i < hull_.size(); ++i)
    for (const Vec2& corner : box.corners())
      if (orientation(hull_[i], hull_[(i + 1) % hull_.size()], corner) < 0) return false;
  return !hull_.empty();
}

}  // namespace arcway::internal
