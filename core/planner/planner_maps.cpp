#include "core/planner/planner_maps.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "core/planner/strategy.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal {

std::vector<OtherRoute> routes_of_strategy() {
  std::vector<OtherRoute> routes;
  for (const StrategyRow& row : kStrategy)
    if (const auto* step = std::get_if<TryOtherRadii>(&row.step)) routes.push_back({step->radii, step->factor});
  return routes;
}

PlannerMaps::PlannerMaps(Roadmap map, const PlannerOptions& options, const std::shared_ptr<const VisibilityRows>& rows,
                         const Executor& executor)
    : all(std::move(map), options.gap_circles),
      slim(all.plain, rows),
      bottleneck(all.plain.world, all.plain.vehicle, all.plain.gaps) {
  end_if_over(executor);
  const Roadmap& plain = all.plain;
  const std::size_t tightest_count = plain.radii.tightest(plain.vehicle.footprint(plain.vehicle.safety_margin()));
  if (tightest_count < plain.radii.size()) {
    const CircleRadii smallest = plain.radii.first(tightest_count);
    auto lazy = std::make_shared<const LazyFeasibleGraph>(
        FeasibleGraphInputs{plain.world, plain.vehicle, rows, plain.queries, smallest}, executor);
    tightest.emplace(plain.with_graph(std::move(lazy), smallest), options.gap_circles);
    other = OtherMaps(plain, tightest->plain, routes_of_strategy(), rows, executor);
  }
  if (options.point_robot_lower_bound && plain.vehicle.body().covers_reference())
    point_distance.emplace(plain.world, rows, plain.outlines);
}

}  // namespace arcway::internal
