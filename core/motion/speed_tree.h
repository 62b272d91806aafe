#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/time_model.h"
#include "core/base/huge_pages.h"
#include "core/motion/end_speeds.h"

namespace arcway::internal {

/// The fastest speed profiles of many paths that share their beginnings, as a tree of joints between segments. A joint
/// knows its highest speed, and the least time to pass it at that speed. A curve or a stop further on may require a
/// lower speed there. The time for that, T(v), follows exactly from the segments before the joint. T is decreasing and
/// convex on [0, speed].
///
/// A path that begins with a speed v0 can only brake so much: at arc length s it is at least as fast as
/// sqrt(v0^2 - 2 a_max s). Below that speed T is infinite, and so is the time of a joint that must be slower.
class SpeedTree {
 public:
  static constexpr std::uint32_t kNoJoint = 0xFFFFFFFFu;
  /// Share by which braking from the start may exceed the acceleration: less than speed_profile tolerates.
  static constexpr double kTolerance = 0.9 * kEndTolerance;
  struct Joint {
    std::uint32_t before = kNoJoint;  ///< the joint at the start of the segment that ends here
    double length = 0.0;              ///< of that segment [m]
    double limit = 0.0;               ///< top speed on it [m/s]
    double speed = 0.0;               ///< highest speed with which this joint can be passed [m/s]
    double time = 0.0;                ///< T(speed) [s]
  };

  /// Forgets all joints but the first one, index 0, at time 0.
  /// @param acceleration  a_max [m/s^2], > 0.
  /// @param time_model  kSegments: joints are passed at the limits beside them, reachable or not, and T is the time at
  ///   that speed. Precondition: both speeds are 0 then.
  /// @param start_speed  with which the first joint is passed [m/s], >= 0.
  /// @param goal_speed  with which all paths end [m/s], >= 0. Only `dominates` depends on it.
  void reset(double acceleration, TimeModel time_model = TimeModel::kProfile, double start_speed = 0.0,
             double goal_speed = 0.0);

  void reserve(std::size_t joints) { joints_.reserve(joints); }
  /// Forgets all joints, and takes memory for `joints` joints.
  void warm_up(std::size_t joints) { empty_with_memory(joints_, joints); }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }
  /// Forgets the joints added last.
  void truncate(std::size_t size) { joints_.resize(size); }
  [[nodiscard]] const Joint& operator[](std::uint32_t joint) const { return joints_[joint]; }
  /// The end of one more segment behind a joint, not added to the tree.
  /// @param limit  top speed on the segment;  @param next_limit  on what follows; 0 to stop [m/s].
  [[nodiscard]] Joint extend(std::uint32_t from, double length, double limit, double next_limit) const;
  /// Overload for a joint that is not in the tree. The result has no `before`; only its speed and time may be used.
  [[nodiscard]] Joint extend(const Joint& from, double length, double limit, double next_limit) const;
  /// Adds the joint that extend(from, ...) returns.
  std::uint32_t add(std::uint32_t from, double length, double limit, double next_limit);

  /// Adds a stop of `wait` seconds behind a joint. What lies before it does not affect later times.
  std::uint32_t add_stop(std::uint32_t from, double wait);

  /// T(speed) [s], 0 <= speed <= joint.speed; infinity below the lowest speed there. It examines as many segments
  /// before the joint as braking takes.
  [[nodiscard]] double time_at(const Joint& joint, double speed) const { return pass(joint, speed).time; }

  /// Whether joint a is at least as good as joint b: no continuation is faster from b than from a, or none by more than
  /// `slack` seconds. Both joints must be at the same place, with the same limit ahead. True is certain up to rounding.
  /// False may be returned where a is better by less than some microseconds.
  [[nodiscard]] bool dominates(const Joint& a, const Joint& b, double slack = 0.0) const;

 private:
  struct Passing {
    double time;
    double peak;  // where braking for the joint begins: dT/dv = -(1 - v / peak) / a
  };
  [[nodiscard]] Passing pass(const Joint& joint, double speed) const;
  // The lowest speed with which a joint can be passed.
  [[nodiscard]] double lowest(const Joint& joint) const;

  double acceleration_ = 1.0;
  TimeModel time_model_ = TimeModel::kProfile;
  double start_speed_ = 0.0, goal_speed_ = 0.0;
  double top_limit_ = 0.0;  // of all segments so far
  HugeVector<Joint> joints_;
};

}  // namespace arcway::internal
