#pragma once

#include <memory>
#include <vector>

#include "core/collision/query_set.h"
#include "core/gaps/vehicle_gaps.h"
#include "core/model/outlines.h"
#include "core/model/vehicle.h"
#include "core/model/world.h"
#include "core/roadmap/feasible_graph.h"

namespace [[gnu::visibility("default")]] arcway {

class CircleTable;
class CirclePlaces;

/// What all searches on one map share. Immutable.
struct SearchMap {
  /// @param radii  those of the graph;  @param outlines  of the world.
  SearchMap(const World& world, const Vehicle& vehicle, QuerySet queries, std::vector<double> radii,
            FeasibleGraph graph, std::shared_ptr<const Outlines> outlines);
  /// The same map with another graph.
  /// @param other_radii  those of that graph; the smallest as here.
  [[nodiscard]] SearchMap with_graph(FeasibleGraph other, std::vector<double> other_radii) const;

  World world;
  Vehicle vehicle;
  QuerySet queries;
  std::vector<double> radii;
  FeasibleGraph graph;
  std::shared_ptr<const CircleTable> circles;  ///< of the graph
  Footprint body;                              ///< with half of the safety margin: what is checked
  std::shared_ptr<const Outlines> outlines;
  std::shared_ptr<const CirclePlaces> places;  ///< of the graph
  std::shared_ptr<const VehicleGaps> gaps;
};

}  // namespace arcway
