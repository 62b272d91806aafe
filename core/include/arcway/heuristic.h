#pragma once

namespace arcway {

/// What A* adds to the time so far, to estimate the time of the whole path.
enum class Heuristic {
  /// The time of the straight line to the goal, from the speed reached to rest, at most at v_ms and a_max. Admissible.
  kTravelTime,
  /// The distance to the goal in meters, taken as seconds, as in the paper. Not admissible if v_ms > 1 m/s.
  kPaperDistance,
  kDijkstra  ///< nothing: Dijkstra's algorithm
};

}  // namespace arcway
