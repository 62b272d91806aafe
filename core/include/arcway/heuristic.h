#pragma once

namespace arcway {

/// What A* adds to the time so far.
enum class Heuristic {
  kTravelTime,  ///< the straight line to the goal, driven from the speed reached to rest at v_ms and a_max: admissible
  kPaperDistance,  ///< straight distance in meters taken as seconds, as the paper has it: not admissible when v_ms > 1
                   ///< m/s
  kDijkstra        ///< no heuristic
};

}  // namespace arcway
