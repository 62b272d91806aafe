#include "core/planner/plan_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

#include "arcway/executor.h"
#include "core/attach/clear_circles.h"
#include "core/planner/strategy.h"
#include "core/roadmap/change_feasible_graph.h"

namespace arcway::internal {

namespace {

struct WithFactor {
  double factor;
  static double product(double a, double b) { return std::clamp(a * b, kSmallestVehicleNumber, kLargestVehicleNumber); }
  TurnSpeedLaw operator()(const ConstantTurnSpeed& law) const {
    return ConstantTurnSpeed{product(std::sqrt(factor), law.speed)};
  }
  TurnSpeedLaw operator()(const LateralAccelerationLimit& law) const {
    return LateralAccelerationLimit{product(factor, law.lateral_acceleration)};
  }
  TurnSpeedLaw operator()(TurnSpeedTable law) const {
    for (auto& entry : law.entries) entry.second = product(std::sqrt(factor), entry.second);
    return law;
  }
};

Roadmap with_other_turns(Roadmap map, const Vehicle& vehicle, double factor) {
  map.vehicle = internal::with_other_turns(vehicle, factor);
  return map;
}

}  // namespace

Vehicle with_other_turns(const Vehicle& vehicle, double factor) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.turn_speed = std::visit(WithFactor{factor}, parameters.turn_speed);
  return Vehicle(std::move(parameters));
}

PlanMaps::PlanMaps(Roadmap map, bool gap_circles)
    : plain(std::move(map)),
      faster_turns(with_other_turns(plain, plain.vehicle, kFasterTurns)),
      slower_turns(with_other_turns(plain, plain.vehicle, kSlowerTurns)) {
  if (gap_circles && plain.world.vertices().size() <= kNarrowVertices) narrow.emplace(plain);
}

Roadmap LazyGraphs::map_of(const Roadmap& map, const CircleRadii& radii, const Roadmap* before) const {
  const FeasibleGraphInputs inputs{map.world, map.vehicle, rows_, map.queries, radii};
  // A graph with the circles of a preferred clearance is no graph of the vertices' circles alone.
  const auto* graph = change_ && before && before->radii == radii && !before->clearance_cost
                          ? dynamic_cast<const LazyFeasibleGraph*>(before->graph.get())
                          : nullptr;
  if (!graph)
    return map.with_graph(std::make_shared<const LazyFeasibleGraph>(inputs, executor_), radii, nullptr,
                          executor_.clock());
  const RoadmapBefore roadmap{*before, change_->may_differ};
  return map.with_graph(change_lazy_feasible_graph(*graph, inputs, change_->change, change_->may_differ), radii,
                        &roadmap, executor_.clock());
}

OtherMaps::OtherMaps(const Roadmap& all, const Roadmap& smallest, std::span<const OtherRoute> routes,
                     const LazyGraphs& graphs, const OtherMaps* before) {
  const auto map_of = [&](const OtherRoute& route) {
    if (route.radii == smallest.radii.size()) return with_other_turns(smallest, all.vehicle, route.factor);
    if (route.radii == all.radii.size()) return with_other_turns(all, all.vehicle, route.factor);
    if (const Roadmap* same = with_radii(route.radii)) return with_other_turns(*same, all.vehicle, route.factor);
    const CircleRadii radii = all.radii.first(route.radii);
    const Roadmap plain = graphs.map_of(all, radii, before ? before->with_radii(route.radii) : nullptr);
    return with_other_turns(all.clearance_cost ? with_clear_circles(plain, graphs.clock()) : plain, all.vehicle,
                            route.factor);
  };
  std::vector<OtherRoute> known{{all.radii.size(), 1.0}};
  for (const OtherRoute& route : routes) {
    const OtherRoute there{std::clamp(route.radii, smallest.radii.size(), all.radii.size()), route.factor};
    if (std::ranges::find(known, there) != known.end()) continue;
    known.push_back(there);
    entries_.push_back({route, map_of(there)});
  }
}

const Roadmap* OtherMaps::with_radii(std::size_t count) const {
  const auto found = std::ranges::find(entries_, count, [](const Entry& entry) { return entry.map.radii.size(); });
  return found == entries_.end() ? nullptr : &found->map;
}

const Roadmap* OtherMaps::find(const OtherRoute& route) const {
  const auto found = std::ranges::find(entries_, route, &Entry::route);
  return found == entries_.end() ? nullptr : &found->map;
}

}  // namespace arcway::internal
