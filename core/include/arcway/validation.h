#pragma once

#include <memory>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/moving_obstacle.h"
#include "arcway/path.h"
#include "arcway/text.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// What the validator tolerates, and what it expects beside the end poses.
struct ValidationOptions {
  double position_tolerance = 1e-6;         ///< at joints and end poses [m]
  double heading_tolerance = 1e-6;          ///< at joints and end poses [rad]
  double relative_tolerance = 1e-6;         ///< of curvature, speeds, accelerations and durations
  bool reverse = true;                      ///< whether segments may be driven backwards
  double start_speed = 0.0;                 ///< with which the path must begin, negative backwards [m/s]
  double goal_speed = 0.0;                  ///< with which the path must end [m/s]
  std::vector<MovingObstacle> moving = {};  ///< that the motion must not meet, see conflicts()
};

/// What may be wrong with a path.
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
  kReverse,    ///< driven backwards, against the options
  kCuspSpeed,  ///< the gear changes while the vehicle moves
  kDirection   ///< driven against a one-way zone
};
/// The violation in words: "collision", "curvature", ...
ARCWAY_API const char* name_of(Violation violation);
inline std::string to_string(Violation violation) { return name_of(violation); }

/// One violation and where it is.
struct ValidationIssue {
  Violation violation;
  std::size_t segment;  ///< index
  double arc_length;    ///< from the start of that segment [m]
  std::string message;  ///< with values and limits
};

/// "collision in segment 3 after 1.2 m: ..."
ARCWAY_API std::string to_string(const ValidationIssue& issue);

/// The result of a validation.
struct ARCWAY_API ValidationReport {
  std::vector<ValidationIssue> issues;  ///< at most one a kind and segment
  double length = 0.0;                  ///< [m]
  double travel_time = 0.0;             ///< sum of the durations [s]
  /// A lower bound on the distance between the bare body and the obstacles along the whole path [m], proved. It is
  /// within 1e-6 m of the true distance, or within 1e-7 of the body's reach if that is more. 0 in collision, infinity
  /// without obstacles.
  double min_clearance = 0.0;
  /// When and where the motion meets ValidationOptions::moving. Of a path without times, the fastest motion from rest
  /// to rest counts. Not looked for where there are issues, and of an empty path.
  std::vector<Conflict> conflicts;
  [[nodiscard]] bool valid() const { return issues.empty() && conflicts.empty(); }
};

/// "valid: 66.2 m, 5.812 s, clearance 0.001 m", or the issues, one a line.
ARCWAY_API std::string to_string(const ValidationReport& report);

/// Checks a path against world and vehicle, independently of the planner: it shares types with it, but no predicates,
/// queries or interval arithmetic.
///
/// | part | rule |
/// |---|---|
/// | numbers | finite |
/// | end poses, joints | positions and headings agree within the tolerances; headings are the body's in either gear |
/// | curvature | at most 1 / rho_min |
/// | directions | within those of one-way zones, where the reference point is inside |
/// | collision | the bare body, without margin, touches no obstacle and stays within the bounds all the time |
/// | speeds | within limits and acceleration limits; the expected ones at both ends; 0 where the gear changes |
/// | durations | at least the fastest ones for the given joint speeds |
///
/// The motion is never sampled. On a line, the swept rectangle is compared with the edges. On an arc, the motion is
/// subdivided into intervals. An interval is free of an edge in either of two cases:
/// - Their distance at its middle exceeds what any point of the body can travel within the interval.
/// - The hull of the edge's extreme positions seen from the body, grown by the height of the arcs between them, stays
///   away.
///
/// An interval that is neither, and in which no point of the body travels 1e-9 of the body's reach, is a collision.
///
/// An empty path is valid if start and goal agree within the tolerances, in pose and speed, and the body is free at the
/// start. Cost:
/// O(n) to sort the map's edges, some 50 ns each; then one or two milliseconds for a path of a hundred segments. Use a
/// Validator for many paths on one map.
///
/// Where zones limit the speed or the direction of motion, it is checked 0.1 mm inside of their borders and farther in.
/// Directions have the tolerance of headings beside that of the zone.
///
/// Keep-outs for the vehicle are obstacles. Where the world does not have them as such yet, each call makes the world
/// that the vehicle meets: see World::for_vehicle.
///
/// Moving obstacles are looked for by conflicts(). It shares exact predicates with the planner, but no decision with
/// evade().
/// @throws std::invalid_argument if speeds or durations are given, but not one a segment.
ARCWAY_API ValidationReport validate(const World& world, const Vehicle& vehicle, const Pose& start, const Pose& goal,
                                     const TimedPath& path, const ValidationOptions& options = {});

/// `validate` for many paths on one map, whose edges are sorted once. Immutable, thread-safe; the world need not
/// outlive it.
class ARCWAY_API Validator {
 public:
  explicit Validator(const World& world);
  /// See `validate`.
  [[nodiscard]] ValidationReport operator()(const Vehicle& vehicle, const Pose& start, const Pose& goal,
                                            const TimedPath& path, const ValidationOptions& options = {}) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace arcway
