#include "core/planner/planner_maps.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "core/attach/clear_circles.h"
#include "core/collision/one_way_sweep.h"
#include "core/planner/strategy.h"

namespace arcway::internal {

namespace {

// The roadmap on which a clearance cost counts, if it is not 0.
Roadmap preferring(Roadmap map, const std::shared_ptr<const ClearanceCost>& cost, const StopClock& clock) {
  if (!cost || cost->costs_nothing()) return map;
  return with_clear_circles(map.with_cost(cost), clock);
}

}  // namespace

std::vector<OtherRoute> routes_of_strategy() {
  std::vector<OtherRoute> routes;
  for (const StrategyRow& row : kStrategy)
    if (const auto* step = std::get_if<TryOtherRadii>(&row.step)) routes.push_back({step->radii, step->factor});
  return routes;
}

// Many parameters because maps come from these parts, one of them from another planner.
PlannerMaps::PlannerMaps(Roadmap map, const std::shared_ptr<const SweepQuery>& obstacles, const PlannerOptions& options,
                         const std::shared_ptr<const VisibilityRows>& rows, const Executor& executor,
                         const MapsBefore* before)
    : base_graph(map.graph),
      clearance_cost(ClearanceCost::of(map.vehicle, map.outlines, options.clearance_preference, map.world.zones())),
      all(preferring(std::move(map), clearance_cost, executor.clock()), options.gap_circles),
      slim(all.plain, rows),
      slim_plans(all.plain, obstacles, options, rows),
      bottleneck(all.plain.world, all.plain.vehicle, all.plain.gaps) {
  end_if_over(executor);
  const Roadmap& plain = all.plain;
  const LazyGraphs graphs(rows, executor, before ? &before->change : nullptr);
  if (plain.one_way_zones) {
    Roadmap reverse = plain;
    reverse.queries.sweep = obeying(obstacles, plain.one_way_zones, Gear::kReverse);
    backwards.emplace(preferring(
        graphs.map_of(reverse, plain.radii, before && before->maps.backwards ? &*before->maps.backwards : nullptr),
        clearance_cost, executor.clock()));
  }
  const std::size_t tightest_count = plain.radii.tightest(plain.vehicle.footprint(plain.vehicle.safety_margin()));
  if (tightest_count < plain.radii.size()) {
    const CircleRadii smallest = plain.radii.first(tightest_count);
    tightest.emplace(
        preferring(
            graphs.map_of(plain, smallest, before && before->maps.tightest ? &before->maps.tightest->plain : nullptr),
            clearance_cost, executor.clock()),
        options.gap_circles);
    other = OtherMaps(plain, tightest->plain, routes_of_strategy(), graphs, before ? &before->maps.other : nullptr);
  }
  if (options.point_robot_lower_bound && plain.vehicle.body().covers_reference())
    point_distance.emplace(plain.world, rows, plain.outlines);
  if (plain.speed_zones) zone_routes.emplace(plain);
}

}  // namespace arcway::internal
