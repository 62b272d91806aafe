#pragma once

#include <vector>

#include "arcway/feasible_graph_snapshot.h"
#include "arcway/visibility_graph.h"

namespace arcway {

/// What a planner builds for a map and a vehicle, to be kept or sent elsewhere and taken up again without building it.
struct PreparedGraph {
  VisibilityGraph reduced_graph;
  std::vector<double> radii;  ///< of the turn circles [m]
  FeasibleGraphSnapshot feasible;
};

}  // namespace arcway
