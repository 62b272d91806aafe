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

/// The obstacle that the body meets at a pose in collision, and where. The point is that of the edges in the body
/// nearest to its middle; of edges equally near, that of the lowest vertex. It is the middle itself where the body lies
/// inside an obstacle. Nothing if no edge is found in the body, as where rounding decides. O(log n + edges near the
/// body), plus one `containing` query where there are none.
/// @param outlines  of the world.
std::optional<Collision> contact_of(const World& world, const Outlines& outlines, const DistanceQuery& distance,
                                    const Body& body, const Pose& pose);

/// A free pose near a pose in collision.
struct FreePose {
  Pose pose;
  double distance;  ///< between the reference points [m]
  double travel;    ///< of the point of the body that moves most [m]
};
/// The range of nearest_free_pose: twice the diagonal of the body [m].
double free_pose_reach(const Footprint& body);
/// The nearest free pose of a fixed pattern, by the travel of the body. The pattern has two parts:
/// - the same position, with headings turned by multiples of 15 degrees;
/// - the same heading, on 16 circles of rising radius in 24 directions. On the first circle with free poses the nearest
///   one is taken, and moved towards the pose by bisection.
///
/// Each pose is decided exactly by the sweep query. Free poses off the pattern may be nearer. At most 767 checks.
std::optional<FreePose> nearest_free_pose(const SweepQuery& sweep, const Body& body, const Pose& pose);

/// The collision in words: "collides with obstacle 3 at (4, 1.5); the nearest free pose found is (4, 0.3, 0), 1.2 m
/// away". Precondition: the body is not free at the pose.
/// @param outlines  of the world.
std::string collision_text(const World& world, const Outlines& outlines, const QuerySet& queries, const Body& body,
                           const Pose& pose);

}  // namespace arcway::internal
