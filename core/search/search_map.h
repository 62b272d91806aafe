#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/box_tree.h"
#include "core/graph/feasible_graph.h"
#include "core/query/query_set.h"
#include "core/search/horizon.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

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
  Footprint body;  ///< with half of the safety margin: what is checked
  Outlines outlines;
  /// Where on a circle of the graph one may arrive.
  struct Arc {
    std::uint32_t circle;
    int interval;  ///< of its free headings; kAnyHeading: all around, free or not
  };
  static constexpr int kAnyHeading = -1;
  /// All arcs on circles of one radius, and boxes around them: boxes of very different sizes make a bad tree.
  struct ArcsOfRadius {
    std::vector<Arc> arcs;
    BoxTree boxes;
  };
  std::vector<ArcsOfRadius> arcs;  ///< by radius
};

}  // namespace arcway
