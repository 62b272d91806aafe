#pragma once

#include <memory>
#include <span>

#include "arcway/query_set.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/collision/clearance_cost.h"
#include "core/gaps/vehicle_gaps.h"
#include "core/model/outlines.h"
#include "core/roadmap/circle_radii.h"
#include "core/roadmap/feasible_graph.h"
#include "core/zones/one_way_zones.h"
#include "core/zones/speed_zones.h"

namespace arcway::internal {

class CircleTable;
class CirclePlaces;
class CloseTurns;
struct RoadmapBefore;

/// The roadmap: the world, the vehicle, their queries and the feasible graph. All searches on one map share it.
/// Immutable.
struct Roadmap {
  /// @param queries  see the member.
  /// @param radii  of the graph.
  /// @param outlines  of the world.
  /// @param before  null if all is made anew.
  /// @throws Canceled if the clock is over before.
  Roadmap(const World& world, const Vehicle& vehicle, QuerySet queries, CircleRadii radii,
          std::shared_ptr<const FeasibleGraph> graph, std::shared_ptr<const Outlines> outlines,
          const RoadmapBefore* before = nullptr, const StopClock& clock = {});
  /// A roadmap of the same world and vehicle with another graph.
  /// @param other_radii  of that graph; the smallest are those of this roadmap.
  /// @param before  that with the graph before a change; null if there is none.
  /// @throws Canceled if the clock is over before.
  [[nodiscard]] Roadmap with_graph(std::shared_ptr<const FeasibleGraph> other, CircleRadii other_radii,
                                   const RoadmapBefore* before = nullptr, const StopClock& clock = {}) const;
  /// The roadmap on which driving close to obstacles costs.
  [[nodiscard]] Roadmap with_cost(std::shared_ptr<const ClearanceCost> cost) const;

  World world;
  Vehicle vehicle;
  QuerySet queries;  ///< motions against one-way zones are not free; obstacles alone are not asked for
  CircleRadii radii;
  std::shared_ptr<const FeasibleGraph> graph;
  std::shared_ptr<const CircleTable> circles;  ///< of the graph
  Body body;                                   ///< with half of the safety margin: what is checked
  std::shared_ptr<const Outlines> outlines;
  std::shared_ptr<const CirclePlaces> places;  ///< of the graph
  std::shared_ptr<const VehicleGaps> gaps;
  std::shared_ptr<const SpeedZones> speed_zones;        ///< of the world; null: no zone limits the speed
  std::shared_ptr<const OneWayZones> one_way_zones;     ///< of the world; null: no zone forbids a direction
  std::shared_ptr<const ClearanceCost> clearance_cost;  ///< null: time alone counts, beside changes of gear
  std::shared_ptr<const CloseTurns> close_turns;        ///< on circles of the graph; null without that cost
};

/// A roadmap before a change of the world, for one after it that has the same circles where nothing has changed.
struct RoadmapBefore {
  const Roadmap& map;
  std::span<const VertexId> may_differ;  ///< see VisibilityRows::Changed
};

}  // namespace arcway::internal
