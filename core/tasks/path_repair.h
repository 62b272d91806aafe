#pragma once

#include <optional>
#include <vector>

#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/trajectory.h"
#include "core/tasks/replan_by.h"

namespace arcway::internal {

/// Repairs a motion that is blocked somewhere: keeps what is free before and behind, and plans between two places on
/// these parts, with the speeds there. Such a plan is short, and is found where a whole one is not in time.
class PathRepair {
 public:
  /// @param motion   not empty; ends at the goal. It is blocked, or does not begin where the vehicle is, as fast.
  /// @param now      where the vehicle is.
  /// @param reverse  see PlanRequest.
  /// All must outlive this.
  PathRepair(const ReplanQueries& queries, const Trajectory& motion, const TrajectoryState& now, bool reverse);

  /// A motion from the vehicle's pose and speed to the goal, free by the queries; nothing if none was found in time.
  [[nodiscard]] std::optional<std::vector<TimedSegment>> find(const PlanLimits& limits) const;

 private:
  // Lengths along the motion [m]: it is free up to the first and from the second one on.
  struct Cut {
    double begin, end;
  };
  [[nodiscard]] Cut find_cut() const;
  // Length of the free part at the start or at the end of a blocked segment.
  [[nodiscard]] double free_length(const PathSegment& segment, bool at_end) const;
  // The length along the motion nearest to the vehicle.
  [[nodiscard]] double nearest() const;
  // The motion with a plan between two places. It leaves the motion at 0 from where the vehicle is.
  [[nodiscard]] std::optional<std::vector<TimedSegment>> joined(double leaves, double rejoins,
                                                                const PlanLimits& limits) const;
  [[nodiscard]] double signed_limited(double speed, Gear gear) const;

  const ReplanQueries& queries_;
  const Trajectory& motion_;
  const TrajectoryState& now_;
  bool reverse_, begins_here_;
};

/// Whether two poses are one, but for rounding.
bool are_same_pose(const Pose& a, const Pose& b);

}  // namespace arcway::internal
