#include "core/attach/roadmap.h"

#include <utility>

#include "core/attach/circle_places.h"
#include "core/attach/circle_table.h"
#include "core/attach/close_turns.h"

namespace arcway::internal {

namespace {

std::shared_ptr<const CirclePlaces> places_of(const std::shared_ptr<const FeasibleGraph>& graph,
                                              const CircleRadii& radii, const std::shared_ptr<const Outlines>& outlines,
                                              const RoadmapBefore* before, const StopClock& clock) {
  if (before && before->map.radii == radii && outlines->shares_pieces_with(before->map.places->outlines()))
    return std::make_shared<const CirclePlaces>(*before->map.places, graph, outlines, before->may_differ);
  return std::make_shared<const CirclePlaces>(graph->turn_circles(), outlines, clock);
}

}  // namespace

// Many parameters because a roadmap is made of these parts, and of no more.
Roadmap::Roadmap(const World& w, const Vehicle& v, QuerySet q, CircleRadii r, std::shared_ptr<const FeasibleGraph> g,
                 std::shared_ptr<const Outlines> o, const RoadmapBefore* before, const StopClock& clock)
    : world(w),
      vehicle(v),
      queries(std::move(q)),
      radii(std::move(r)),
      graph(std::move(g)),
      circles(std::make_shared<const CircleTable>(*graph)),
      body(vehicle.body(0.5 * v.safety_margin())),
      outlines(std::move(o)),
      places(places_of(graph, radii, outlines, before, clock)),
      gaps(std::make_shared<const VehicleGaps>(w, v, radii.front())),
      speed_zones(SpeedZones::of(w)),
      one_way_zones(OneWayZones::of(w)) {}

Roadmap Roadmap::with_graph(std::shared_ptr<const FeasibleGraph> other, CircleRadii other_radii,
                            const RoadmapBefore* before, const StopClock& clock) const {
  Roadmap map = *this;
  map.radii = std::move(other_radii);
  map.graph = std::move(other);
  map.circles = std::make_shared<const CircleTable>(*map.graph);
  map.places = places_of(map.graph, map.radii, outlines, before, clock);
  return clearance_cost ? map.with_cost(clearance_cost) : map;
}

Roadmap Roadmap::with_cost(std::shared_ptr<const ClearanceCost> cost) const {
  Roadmap map = *this;
  map.clearance_cost = std::move(cost);
  map.close_turns = std::make_shared<const CloseTurns>(map.graph, map.clearance_cost);
  return map;
}

}  // namespace arcway::internal
