#pragma once

#include <optional>
#include <string>

#include "arcway/path.h"
#include "arcway/query_set.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// What a body meets at a pose.
struct Collision {
  ObstacleId region;  ///< an obstacle, or the bounds
  Vec2 point;         ///< of that region, on or in the body; where one of its edges enters it, to a rounding
};

/// The obstacle that the body meets at a pose in collision, and where: of all edges that meet the body the point
/// nearest to its middle, or the middle itself where an obstacle swallows the body. Of edges equally near, that of
/// the lowest vertex counts. Nothing if no edge is found in the body, as where rounding decides. O(log n + edges near
/// the body), and a `containing` query where there are none.
/// @param outlines  of the world.
std::optional<Collision> contact_of(const World& world, const Outlines& outlines, const DistanceQuery& distance,
                                    const Footprint& body, const Pose& pose);

/// Where the body is free near a pose at which it is not.
struct FreePose {
  Pose pose;
  double distance;  ///< of the reference points [m]
  double travel;    ///< of the point of the body that moves most [m]
};
/// How far `nearest_free_pose` looks: twice the diagonal of the body [m].
double free_pose_reach(const Footprint& body);
/// The nearest free pose of a fixed pattern, by the travel of the body: of the same place with headings turned by
/// multiples of 15 degrees, the smallest turn; of the same heading on 16 circles of rising radius, in 24 directions
/// counted from the heading, the nearest of the first circle with any, drawn in towards the pose by bisection. Each
/// pose is decided exactly by the sweep query; another one may be nearer. At most 767 checks.
std::optional<FreePose> nearest_free_pose(const SweepQuery& sweep, const Footprint& body, const Pose& pose);

/// "collides with obstacle 3 at (4, 1.5); the nearest free pose found is (4, 0.3, 0), 1.2 m away", of a pose at which
/// the body is not free.
/// @param outlines  of the world.
std::string collision_text(const World& world, const Outlines& outlines, const QuerySet& queries, const Footprint& body,
                           const Pose& pose);

}  // namespace arcway::internal
