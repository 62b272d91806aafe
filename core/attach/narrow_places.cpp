#include "core/attach/narrow_places.h"

#include "arcway/executor.h"
#include "core/gaps/gap_circles.h"
#include "core/roadmap/extend_feasible_graph.h"

namespace arcway::internal {

namespace {

constexpr double kWideTurn =
    4.0;  // radius of the wide circles, in smallest radii: such a turn sweeps hardly more than the body's width

// Adds wide turns, which sweep less and so fit into more places, (7). A map of several radii has wider turns already.
// Where a wider turn is a faster one, a single radius means that no wider ones are wanted.
void add_wide_turns(const Roadmap& map, const StopClock& clock, AddedCircles& added) {
  const SideRadii smallest = map.radii.front(), radii = smallest.times(kWideTurn);
  if (map.radii.size() > 1 || map.vehicle.turn_speed(radii.smaller()) > map.vehicle.turn_speed(smallest.smaller()))
    return;
  const Footprint grown_body = map.vehicle.footprint(map.vehicle.safety_margin());
  StopTicker ticker(clock);
  for (const VertexId v : map.world.convex_vertices()) {
    end_if_over(ticker);
    for (const Side side : {Side::kLeft, Side::kRight})
      added.around_vertices.push_back(turn_circle(map.world, v, radii.of(side), side, grown_body));
  }
}

}  // namespace

const Roadmap& NarrowPlaces::map(const StopClock& clock) const {
  const auto make = [&]() -> std::optional<Roadmap> {
    const GapMap* gaps = map_.gaps->map(clock);
    if (!gaps) throw Canceled("canceled");
    AddedCircles added = find_gap_circles(map_.world, *gaps, map_.vehicle, map_.radii.front(), clock);
    if (added.around_vertices.empty() && added.gap_straights.empty()) return std::nullopt;
    add_wide_turns(map_, clock, added);
    return map_.with_graph(extend_feasible_graph(map_.graph, map_.vehicle, added, clock), map_.radii, nullptr, clock);
  };
  const std::optional<Roadmap>* detailed = detailed_.get(clock, make);
  return detailed && *detailed ? **detailed : map_;
}

}  // namespace arcway::internal
