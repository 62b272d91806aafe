#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/text.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

struct PlanResult;

/// The vehicle at one moment of a trajectory.
struct TrajectoryState {
  double time = 0.0;            ///< since the start [s]
  double distance = 0.0;        ///< driven since the start [m]
  Pose pose;                    ///< of the reference point [m, m, rad]; heading in (-pi, pi]
  double speed = 0.0;           ///< in the direction of travel, never negative [m/s]
  double acceleration = 0.0;    ///< in the direction of travel, negative while braking [m/s^2]
  double curvature = 0.0;       ///< [1/m], left positive
  double steering_angle = 0.0;  ///< Vehicle::steering_angle of the curvature [rad]
  Gear gear = Gear::kForward;   ///< direction of travel along the body
  std::size_t segment = 0;      ///< index of the segment

  /// The speed, negative while driving backwards [m/s]: PlanRequest::start_speed of a plan that goes on from here.
  [[nodiscard]] double signed_speed() const { return gear == Gear::kReverse ? 0.0 - speed : speed; }
};

/// "1.5 s, 12 m: (13, 2, 0) at 12 m/s forwards, 0 m/s^2, curvature 0 1/m".
ARCWAY_API std::string to_string(const TrajectoryState& state);

/// Steps of samples by length and angle.
struct PathSampling {
  double max_length = 0.5;  ///< between two samples [m], > 0
  double max_angle = 0.05;  ///< between two samples [rad], > 0
};

/// A path in time: where the vehicle is, and how it moves, at any moment or after any distance.
///
///     const Trajectory trajectory(planner.plan(request));
///     for (double t = 0.0; t < trajectory.duration(); t += 0.01) drive(trajectory.at(t));
///
/// On each segment the vehicle moves as fast as its speeds at both ends allow: it accelerates, holds its speed, and
/// brakes. All values are closed forms of that motion, correct to some units in the last place.
///
/// Times are from 0 to duration() [s], distances from 0 to length() [m]. At a joint the state is that of the segment
/// that begins there; where the gear changes, it has the new gear and speed 0.
///
/// Immutable and thread-safe. Copies share the data: a copy is O(1). Construction is O(segments).
class ARCWAY_API Trajectory {
 public:
  /// The motion of a plan, with the plan's vehicle and world.
  /// @throws std::invalid_argument if the plan is not solved, naming its status and reason; or if it was not made by a
  ///   planner, so that its vehicle is not known.
  explicit Trajectory(const PlanResult& result);
  /// Segments with speeds and durations, as PlanResult::segments.
  /// @param world  that `clearance_at` measures in; none: that function needs a world.
  /// @throws std::invalid_argument without segments, or naming a segment that the vehicle cannot drive so. Its numbers
  ///   must be finite, its speeds within the limit and reached within the segment, and its duration that of the fastest
  ///   motion. Speeds and durations may be off by a millionth, durations by a nanosecond in any case.
  Trajectory(std::span<const TimedSegment> segments, const Vehicle& vehicle,
             const std::optional<World>& world = std::nullopt);
  /// A path with claimed speeds and durations or, if it has none, the fastest motion from rest to rest.
  /// @throws std::invalid_argument as above, or if the speeds and durations are not one a segment.
  Trajectory(const TimedPath& path, const Vehicle& vehicle, const std::optional<World>& world = std::nullopt);
  /// The fastest motion along a path, from rest to rest.
  /// @throws std::invalid_argument without segments, or naming one with a negative or infinite number.
  Trajectory(std::span<const PathSegment> path, const Vehicle& vehicle,
             const std::optional<World>& world = std::nullopt);

  /// The time from start to end [s]. O(1).
  [[nodiscard]] double duration() const;
  /// The length of the path [m]. O(1).
  [[nodiscard]] double length() const;

  /// The state at a time from 0 to duration() [s]. O(log segments).
  /// @throws std::out_of_range naming the time and the duration.
  [[nodiscard]] TrajectoryState at(double time) const;
  /// The state at a distance from 0 to length() along the path [m]. O(log segments).
  /// @throws std::out_of_range naming the distance and the length.
  [[nodiscard]] TrajectoryState at_distance(double distance) const;

  /// Distance of the bare body from the nearest obstacle at a time from 0 to duration() [m]; 0 in contact, infinity in
  /// a world without obstacles. Precondition: no obstacle contains the whole body. O(obstacles + edges near by).
  /// @throws std::out_of_range as `at`; std::logic_error if the trajectory was made without a world.
  [[nodiscard]] double clearance_at(double time) const;
  /// The clearance in another world, as one that changed since.
  [[nodiscard]] double clearance_at(double time, const World& world) const;

  /// Positions along the path [m], at most `step` apart [m]: see the free function of path.h. O(points).
  /// @throws std::invalid_argument as that does.
  [[nodiscard]] std::vector<Vec2> polyline(double step) const;
  /// The states at the times 0, dt, 2 dt, ... and at the end [s]. O(states).
  /// @param dt  [s], > 0; infinity gives both ends.
  /// @throws std::invalid_argument naming the value and the limit, unless dt is positive and gives at most
  ///   kMostSamplingSteps states.
  [[nodiscard]] std::vector<TrajectoryState> sample(double dt) const;
  /// The states at steps of length and angle. The ends of all segments are kept. Where curvature or gear change, the
  /// joint comes twice, once for each segment.
  ///
  /// There is a state at each change between accelerating, holding and braking. The mean of two neighbors' speeds times
  /// the time between them is thus their distance, up to rounding. Times never descend. O(states).
  /// @throws std::invalid_argument naming the value and the limit, unless both steps are positive and give at most
  ///   kMostSamplingSteps states.
  [[nodiscard]] std::vector<TrajectoryState> sample(const PathSampling& sampling) const;

  [[nodiscard]] std::span<const TimedSegment> segments() const;
  [[nodiscard]] const Vehicle& vehicle() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// "2.74 s, 30 m, 3 segments".
ARCWAY_API std::string to_string(const Trajectory& trajectory);

}  // namespace arcway
