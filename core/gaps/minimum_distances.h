#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway::internal {

/// The obstacles of one path segment's region by side, ascending.
struct RadialSet {
  std::vector<ObstacleId> left;
  std::vector<ObstacleId> right;
};

/// D_min of two obstacles on different sides of a path segment.
struct ObstaclePairDistance {
  std::size_t segment;
  ObstacleId left, right;
  double distance;  ///< between the boundaries [m]; compare with (6) and (7)
  Vec2 on_left, on_right;
};

/// Distance of a path segment and an obstacle of its region.
struct SegmentObstacleDistance {
  std::size_t segment;
  ObstacleId obstacle;
  Side side;
  double distance;  ///< to the boundary [m]
  Vec2 on_segment, on_obstacle;
};

/// The result of minimum_distances.
struct MinimumDistances {
  RadialSet obstacles;                ///< all obstacles, by the side they lie on at the nearest of their segments
  std::vector<RadialSet> by_segment;  ///< one a segment
  std::vector<ObstaclePairDistance> pairs;
  std::vector<SegmentObstacleDistance> to_segments;
};

/// The minimum distances along a polyline from start to goal: how much room it leaves to a body.
///
/// The bisectors of the turns divide the plane into one region for each segment; the first and the last region are
/// open. An obstacle belongs to every region that it overlaps, on the side of the segment's line that it reaches
/// further out on. Distances are measured between obstacles across a segment, and between a segment and the obstacles
/// of its region. Bounds are left out. O(segments * vertices + vertex pairs measured); boxes rule out most pairs.
/// @throws std::invalid_argument for fewer than two points, repeated consecutive points, or one that is not finite.
MinimumDistances minimum_distances(const World& world, std::span<const Vec2> path);

}  // namespace arcway::internal
