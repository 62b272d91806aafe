#pragma once

#include <vector>

#include "arcway/feasible_graph_snapshot.h"
#include "arcway/visibility_graph.h"

namespace arcway {

/// All graphs of a planner, to be stored or sent and then used by Planner::restored.
struct PreparedGraph {
  VisibilityGraph reduced_graph;
  std::vector<double> radii;  ///< of the turn circles [m], ascending
  FeasibleGraphSnapshot feasible;
};

}  // namespace arcway
