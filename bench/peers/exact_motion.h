#pragma once

#include <optional>

#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/motion_free.h"

namespace arcway::internal::peers {

/// What a peer gets: the same world, robot and exact collision checks as the planner.
struct Problem {
  const World& world;
  const Vehicle& vehicle;
  const SweepQuery& sweep;
  PlanRequest request;
};

/// The body that planner and peers check: grown by half of the safety margin.
Body checked_body(const Vehicle& vehicle);

bool pose_free(const SweepQuery& sweep, const Body& body, const Pose& pose);

/// Whether the validator takes a path, driven by the fastest speed profile, as an answer to the request.
bool is_valid(const Problem& problem, const Path& path);

/// The shortest Dubins word between two poses.
Path shortest_dubins_path(const Pose& from, const Pose& to, double radius);

/// Travel time from rest to rest, by the fastest speed profile [s].
double travel_time(std::span<const PathSegment> path, const Vehicle& vehicle);

}  // namespace arcway::internal::peers
