#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/attach/attachment_links.h"

namespace arcway::internal {

/// How far poses are from each other: dense ones find the way out of a narrow place, sparse ones a place to turn back.
enum class Spread { kDense, kSparse };

/// Memory of find_maneuvers, kept for the next time: for one at a time, of any map.
class ManeuverWorkspace {
 public:
  ManeuverWorkspace();
  ~ManeuverWorkspace();
  ManeuverWorkspace(ManeuverWorkspace&&) noexcept;
  ManeuverWorkspace& operator=(ManeuverWorkspace&&) noexcept;

  struct Data;
  Data& operator*() { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

/// Poses that free forward motions of short steps (left arc, right arc, straight) reach from a start, or from which
/// they reach a goal, the pose itself first; at most one pose for each cell of a grid over position and heading. Steps
/// are taken from the nearest pose first, until there are `max_poses` poses, or up to ten more with those of the last
/// one. Straight steps are of three lengths; arcs turn by one angle, or where an obstacle is nearer by the rest
/// of the way and shares of it. Steps are checked exactly; only their number is limited, so a missing pose proves
/// nothing. O(max_poses) queries and memory.
/// @param clock  ends that, with the poses found by then.
std::vector<Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                       const SweepQuery& sweep, std::size_t max_poses, Spread spread = Spread::kDense,
                                       const StopClock& clock = {});
/// The same in memory that is used again: theirs is the workspace's.
std::span<const Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                           const SweepQuery& sweep, std::size_t max_poses, Spread spread,
                                           ManeuverWorkspace& workspace, const StopClock& clock = {});

}  // namespace arcway::internal
