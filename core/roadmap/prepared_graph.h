#pragma once

#include <vector>

#include "core/roadmap/feasible_tables.h"
#include "core/roadmap/visibility_graph.h"

namespace [[gnu::visibility("default")]] arcway {

/// What a planner builds for a map and a vehicle, to be kept or sent elsewhere and taken up again without building it.
struct PreparedGraph {
  VisibilityGraph reduced_graph;
  std::vector<double> radii;  ///< of the turn circles [m]
  FeasibleTables feasible;
};

}  // namespace arcway
