#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway::internal {

/// Obstacles of one path segment's region, ascending.
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

struct MinimumDistances {
  RadialSet obstacles;                ///< all obstacles, by the side they lie on at the nearest of their segments
  std::vector<RadialSet> by_segment;  ///< one a segment
  std::vector<ObstaclePairDistance> pairs;
  std::vector<SegmentObstacleDistance> to_segments;
};

/// The minimum distances along a point path (a polyline from start to goal): how much room it leaves to a body.
///
/// At each turn point the bisector of the turn divides the plane; the region of a segment lies between the bisectors
/// at its two ends, the first and the last region being open at start and goal. An obstacle belongs to every region it
/// overlaps, so perhaps to several, and there to the side of the segment's line that it reaches further out on. Only
/// pairs across a segment and pairs of a segment with an obstacle of its region are measured. Bounds are left out.
/// Time O(segments * vertices + sum of vertex pairs measured, most of them ruled out by boxes).
/// @throws std::invalid_argument for fewer than two points, repeated consecutive points, or one that is not finite.
MinimumDistances minimum_distances(const World& world, std::span<const Vec2> path);

}  // namespace arcway::internal
