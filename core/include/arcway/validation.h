#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

struct ValidationOptions {
  double position_tolerance = 1e-6;  ///< joints and end poses [m]
  double heading_tolerance = 1e-6;   ///< joints and end poses [rad]
  double relative_tolerance = 1e-6;  ///< curvature, speeds, accelerations, durations
  bool reverse = true;               ///< segments may be driven backwards
};

enum class Violation {
  kNotFinite,
  kStartPose,
  kGoalPose,
  kPositionJump,
  kHeadingJump,
  kCurvature,
  kCollision,
  kOutsideBounds,
  kSpeedLimit,
  kSpeedJump,
  kAcceleration,
  kDuration,
  kNegativeLength,
  kReverse,   ///< driven backwards, which the options do not allow
  kCuspSpeed  ///< the gear changes while the vehicle moves
};
ARCWAY_API const char* name_of(Violation violation);

struct ValidationIssue {
  Violation violation;
  std::size_t segment;  ///< where
  double arc_length;    ///< from the start of that segment [m]
  std::string message;  ///< with values and limits
};

struct ARCWAY_API ValidationReport {
  std::vector<ValidationIssue> issues;  ///< at most one a kind and segment
  double length = 0.0;                  ///< [m]
  double travel_time = 0.0;             ///< sum of the durations [s]
  /// A lower bound on the distance between the bare body and the obstacles, proved along the whole path [m];
  /// within 1e-6 of the true one, or 1e-7 of the body's reach; 0 in collision, infinity without obstacles.
  double min_clearance = 0.0;
  [[nodiscard]] bool valid() const { return issues.empty(); }
};

/// Checks a path against world and vehicle: finite numbers, end poses, joints (position and
/// heading), curvature at most 1 / rho_min, the bare body (no margin) touching no obstacle and not leaving the bounds
/// at any moment of the continuous motion. Of the speeds: limits, acceleration limits, durations equal to the fastest
/// ones for the given joint speeds or longer, rest at both ends and where the gear changes. Joints are continuous in
/// the body's heading, in whichever gear. Shares types with the planner, no decisions: no predicate, query or interval
/// code of the planner is used. On a straight line the swept rectangle is compared with the edges. On an arc collision
/// is decided by subdivision of the motion: an interval is free of an edge if their distance at its middle exceeds what
/// any body point can move within it. It also is if the hull of the edge's extreme places seen from the body, grown by
/// the height of the arcs between them, keeps away; an interval that is neither, and in which no body point travels
/// 1e-9 of the body's reach, is a collision. Never samples. An empty path is valid where start and goal agree within
/// the tolerances and the body at the start is free. O(n) to sort the edges by place, some 50 ns each; then a path
/// costs what lies near it: a millisecond or two for a hundred segments. See Validator for many paths on one map.
/// @throws std::invalid_argument if speeds or durations are given, but not one a segment.
ARCWAY_API ValidationReport validate(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                                     const TimedPath& path, const ValidationOptions& options = {});

/// `validate` for many paths on one map, whose edges are sorted once. Immutable and thread-safe; the world need not
/// outlive it.
class ARCWAY_API Validator {
 public:
  explicit Validator(const World& world);
  /// As `validate`, errors included.
  [[nodiscard]] ValidationReport operator()(const Vehicle& vehicle, const Pose& start, const Pose& goal,
                                            const TimedPath& path, const ValidationOptions& options = {}) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway
