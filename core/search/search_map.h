#pragma once

#include <vector>

#include "core/geometry/box_tree.h"
#include "core/graph/feasible_graph.h"
#include "core/query/query_set.h"
#include "core/search/horizon.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace arcway {

/// What all searches on one map share. Immutable.
struct SearchMap {
  /// @param radii  those of the graph.
  SearchMap(const World& world, const Vehicle& vehicle, QuerySet queries, std::vector<double> radii,
            FeasibleGraph graph);

  World world;
  Vehicle vehicle;
  QuerySet queries;
  std::vector<double> radii;
  FeasibleGraph graph;
  Footprint body;    ///< with half of the safety margin: what is checked
  BoxTree vertices;  ///< of World::convex_vertices; circles of item i start at 2 * radii.size() * i
  Outlines outlines;
};

}  // namespace arcway
