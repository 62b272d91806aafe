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

/// How far apart poses are: dense ones find the way out of a narrow place, sparse ones find room to turn around.
enum class Spread { kDense, kSparse };

/// Memory of find_maneuvers, used again by the next call, on any map. For one call at a time.
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

/// Finds maneuvers: chains of short free motions, left arcs, right arcs and straights, that leave a start or lead to a
/// goal. It grows a tree of poses from the end's own pose, which is the first one returned:
/// 1. The pose nearest to the root that had no turn yet is extended by all steps that are free.
/// 2. A step's pose is kept if its cell of a grid over position and heading has none.
/// 3. The tree ends at `max_poses` poses, or with up to ten more from the last pose extended.
///
/// Straight steps have three lengths. Arcs turn by one angle; where an obstacle ends them sooner, by shares of the turn
/// up to it. Steps are checked exactly. As their number is limited, a missing pose proves nothing. O(max_poses) queries
/// and memory.
/// @param radius  of the arcs [m].
/// @param clock  may end the search; the poses found by then are returned.
std::vector<Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                       const SweepQuery& sweep, std::size_t max_poses, Spread spread = Spread::kDense,
                                       const StopClock& clock = {});
/// Overload with memory that is used again. The span is valid until the workspace's next use.
std::span<const Attachment> find_maneuvers(const Pose& pose, Direction direction, const Vehicle& vehicle, double radius,
                                           const SweepQuery& sweep, std::size_t max_poses, Spread spread,
                                           ManeuverWorkspace& workspace, const StopClock& clock = {});

}  // namespace arcway::internal
