#pragma once

#include <span>

#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/path_cost.h"

namespace arcway::internal {

/// What drives a path, among which obstacles, and what it costs. All that it refers to must outlive it.
struct JoinQuery {
  const Vehicle& vehicle;
  const SweepQuery& sweep;
  const StopClock& clock;  ///< asked before each trial; once over, the path so far is the result
  PathCosts costs = {};
};

/// Drives free paths in fewer motions, and keeps its memory for the next one.
class ArcJoiner {
 public:
  /// The path in fewer motions, forwards as before. From each joint on, a biarc takes the place of as many motions as
  /// possible, three at least, where it is free and hardly longer. The path costs a thousandth more at most. Paths of
  /// trees and of refinement turn in many short arcs, each with contacts of its own, which ChainOptimizer hardly moves.
  /// Fewer arcs move further. O(n^3) for n motions, but some tens of milliseconds at most.
  /// @return memory of this, until the next call.
  const Path& join(std::span<const PathSegment> path, const JoinQuery& query);

 private:
  class Joining;

  Path path_, joined_;
  SpeedProfile profile_;
  HeadingSet headings_;
};

}  // namespace arcway::internal
