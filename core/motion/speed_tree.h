#pragma once

#include <cstddef>
#include <cstdint>

#include "arcway/time_model.h"
#include "core/base/huge_pages.h"

namespace arcway::internal {

/// The fastest speed profiles of many paths from rest that share their beginnings: a tree of joints between path
/// segments. A joint knows how fast, and when, it is passed at best. What it costs to pass it slower, because of a
/// curve or a stop further on, follows exactly from the segments before it: T(v), the least time to get there with
/// speed v, falls and is convex on [0, speed].
class SpeedTree {
 public:
  static constexpr std::uint32_t kNoJoint = 0xFFFFFFFFu;
  struct Joint {
    std::uint32_t before = kNoJoint;  ///< the joint at the start of the segment that ends here
    double length = 0.0;              ///< of that segment [m]
    double limit = 0.0;               ///< top speed on it [m/s]
    double speed = 0.0;               ///< the highest with which this joint can be passed [m/s]
    double time = 0.0;                ///< T(speed) [s]
  };

  /// Forgets all joints but the first one, index 0: at rest, time 0.
  /// @param acceleration  a_max [m/s^2], > 0.
  /// @param time_model  kSegments: joints are passed at the limits beside them, reachable or not, and T is the time at
  ///   that speed.
  void reset(double acceleration, TimeModel time_model = TimeModel::kProfile);

  void reserve(std::size_t joints) { joints_.reserve(joints); }
  /// Forgets all joints, with memory for so many at hand.
  void warm_up(std::size_t joints) { empty_with_memory(joints_, joints); }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }
  /// Forgets the joints added last.
  void truncate(std::size_t size) { joints_.resize(size); }
  [[nodiscard]] const Joint& operator[](std::uint32_t joint) const { return joints_[joint]; }
  /// The end of one more segment behind a joint, not added to the tree.
  /// @param limit  top speed on the segment;  @param next_limit  on what follows; 0 to stop [m/s].
  [[nodiscard]] Joint extend(std::uint32_t from, double length, double limit, double next_limit) const;
  /// The same behind a joint that is not in the tree: the result has no `before` and can't be asked for more than its
  /// speed and time.
  [[nodiscard]] Joint extend(const Joint& from, double length, double limit, double next_limit) const;
  /// Adds what `extend(from, ...)` gives.
  std::uint32_t add(std::uint32_t from, double length, double limit, double next_limit);

  /// Adds a stop of `wait` seconds behind a joint, where what was before no longer matters.
  std::uint32_t add_stop(std::uint32_t from, double wait);

  /// T(speed), 0 <= speed <= joint.speed. Looks back over as many segments as braking takes.
  [[nodiscard]] double time_at(const Joint& joint, double speed) const { return pass(joint, speed).time; }

  /// Whether no path that goes on from b is faster than the same continuation from a; both joints at the same place
  /// with the same limit ahead, or none by more than `slack` seconds. True is certain up to rounding; false may be said
  /// where a is better by less than some microseconds.
  [[nodiscard]] bool dominates(const Joint& a, const Joint& b, double slack = 0.0) const;

 private:
  struct Passing {
    double time;
    double peak;  // where braking for the joint begins: dT/dv = -(1 - v / peak) / a
  };
  [[nodiscard]] Passing pass(const Joint& joint, double speed) const;

  double acceleration_ = 1.0;
  TimeModel time_model_ = TimeModel::kProfile;
  double top_limit_ = 0.0;  // of all segments so far
  HugeVector<Joint> joints_;
};

}  // namespace arcway::internal
