#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/attach/attachment_links.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

/// How far apart poses are: dense ones find the way out of a narrow place, sparse ones find room to turn around.
enum class Spread { kDense, kSparse };

/// A body that turns with one radius to each side, and the obstacles around it.
struct ManeuveringBody {
  ManeuveringBody(const Vehicle& vehicle, const SideRadii& r, const SweepQuery& s)
      : body(vehicle.body(0.5 * vehicle.safety_margin())), radii(r), sweep(s) {}
  Body body;        ///< with half of the safety margin: what is checked
  SideRadii radii;  ///< of the reference point's arcs
  const SweepQuery& sweep;
};

/// How many poses to look for, and how far from each other.
struct ManeuverPoses {
  std::size_t most;  ///< number of poses
  Spread spread = Spread::kDense;
};

/// Finds maneuvers: chains of short free motions, left arcs, right arcs and straights, that leave a start or lead to a
/// goal. It grows a tree of poses from the end's own pose, which is the first one returned:
/// 1. The pose nearest to the root that has not been extended is extended by all steps that are free.
/// 2. The pose at the end of a step is kept if its cell of a grid over position and heading is empty.
/// 3. The tree ends at `ManeuverPoses::most` poses, or with up to ten more from the last pose extended.
///
/// Straight steps have three lengths. Arcs turn by one angle; where an obstacle ends them sooner, by shares of the turn
/// up to it. Steps are checked exactly. As their number is limited, a missing pose proves nothing. O(most) queries
/// and memory.
///
/// Memory is kept for the next search, on any map. One search at a time.
class ManeuverSearch {
 public:
  ManeuverSearch();
  ~ManeuverSearch();
  ManeuverSearch(ManeuverSearch&&) noexcept;
  ManeuverSearch& operator=(ManeuverSearch&&) noexcept;

  /// @param clock  may end the search; the poses found by then are returned.
  /// @return the poses; valid until the next search.
  std::span<const Attachment> find(const Pose& pose, Direction direction, const ManeuveringBody& body,
                                   const ManeuverPoses& poses, const StopClock& clock = {});

 private:
  struct Memory;
  class Run;
  std::unique_ptr<Memory> memory_;
};

}  // namespace arcway::internal
