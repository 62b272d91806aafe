#pragma once

#include <memory>
#include <vector>

#include "arcway/query_set.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/gaps/vehicle_gaps.h"
#include "core/model/outlines.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway::internal {

class CircleTable;
class CirclePlaces;

/// What all searches on one map share. Immutable.
struct Roadmap {
  /// @param radii  those of the graph;  @param outlines  of the world.
  Roadmap(const World& world, const Vehicle& vehicle, QuerySet queries, std::vector<double> radii, FeasibleGraph graph,
          std::shared_ptr<const Outlines> outlines);
  /// The same map with another graph.
  /// @param other_radii  those of that graph; the smallest as here.
  [[nodiscard]] Roadmap with_graph(FeasibleGraph other, std::vector<double> other_radii) const;

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

}  // namespace arcway::internal
