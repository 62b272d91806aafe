#pragma once

namespace arcway {

/// What A* adds to the time so far, to estimate the time to the goal.
enum class Heuristic {
  kTravelTime,  ///< time of the straight line to the goal, from the speed reached to rest at v_ms and a_max; admissible
  kPaperDistance,  ///< straight distance in meters taken as seconds, as in the paper; not admissible if v_ms > 1 m/s
                   ///< m/s
  kDijkstra        ///< 0
};

}  // namespace arcway
