#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "arcway/replan.h"
#include "arcway/trajectory.h"
#include "bench/live/live_planner.h"
#include "bench/live/walking_obstacles.h"

namespace arcway::internal::bench {

struct LiveSetting {
  double rate = 10.0;    ///< cycles a second of the drive
  double within = 0.01;  ///< for changing the map and planning on in a cycle [s]
  std::uint64_t seed = 7;
};

/// What one cycle of a drive took, and what came of it.
struct LiveCycle {
  TrajectoryState now;                              ///< where the vehicle is, with its speed
  double change_seconds = 0.0, plan_seconds = 0.0;  ///< processor time of the calling thread
  Replan next;

  [[nodiscard]] double seconds() const { return change_seconds + plan_seconds; }
  [[nodiscard]] bool leads_to_goal() const;
};

/// A vehicle drives from goal to goal through a map that changes. In each cycle it drives on for a while, the map
/// changes, its planner follows, and it plans on from where it is.
class LiveDrive {
 public:
  /// @param planner  must outlive this.
  /// @param first    the motion to the first goal, of the planner's vehicle.
  /// @param goals    taken in turn, at least one.
  LiveDrive(LivePlanner& planner, Trajectory first, std::vector<Pose> goals, const LiveSetting& setting);

  LiveCycle next_cycle();

  [[nodiscard]] const WalkingObstacles& obstacles() const { return obstacles_; }
  [[nodiscard]] std::size_t goals_reached() const { return goals_reached_; }
  [[nodiscard]] const Pose& goal() const { return goals_[goal_ % goals_.size()]; }

 private:
  void choose_goal(const TrajectoryState& now);

  LivePlanner& planner_;
  std::vector<Pose> goals_;
  LiveSetting setting_;
  WalkingObstacles obstacles_;
  Trajectory driven_;
  std::vector<TimedSegment> given_up_;  // see Replan::given_up
  double time_ = 0.0;                   // of the motion that is driven [s]
  double standing_ = 0.0;               // for how long the vehicle has stood [s]
  std::size_t goal_ = 0, goals_reached_ = 0;
  bool leads_to_goal_ = true;
};

}  // namespace arcway::internal::bench
