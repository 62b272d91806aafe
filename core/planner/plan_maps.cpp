#include "core/planner/plan_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "arcway/executor.h"

namespace arcway::internal {

namespace {

// The first so many radii, of five at most, and how many times the lateral acceleration that there may be.
struct OtherRoute {
  std::size_t radii;
  double factor;
  bool operator==(const OtherRoute&) const = default;
};
constexpr std::array<OtherRoute, 7> kOtherRoutes{
    {{3, 4.0}, {2, 4.0}, {2, 16.0}, {1, 16.0}, {4, 2.0}, {3, 1.0}, {5, 4.0}}};
constexpr double kFasterFactor = 2.0, kSlowerFactor = 0.5;

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
      faster_turns(with_other_turns(plain, plain.vehicle, kFasterFactor)),
      slower_turns(with_other_turns(plain, plain.vehicle, kSlowerFactor)) {
  if (gap_circles && plain.world.vertices().size() <= kNarrowVertices) narrow.emplace(plain);
}

std::vector<Roadmap> maps_of_other_routes(const Roadmap& all, const Roadmap& smallest,
                                          const std::shared_ptr<const VisibilityRows>& rows, const Executor& executor) {
  std::vector<Roadmap> maps;
  const auto add_with = [&](std::size_t count, double factor) {
    if (count == smallest.radii.size()) return maps.push_back(with_other_turns(smallest, all.vehicle, factor));
    if (count == all.radii.size()) return maps.push_back(with_other_turns(all, all.vehicle, factor));
    const auto same = std::ranges::find(maps, count, [](const Roadmap& map) { return map.radii.size(); });
    if (same != maps.end()) return maps.push_back(with_other_turns(*same, all.vehicle, factor));
    const std::vector<double> radii(all.radii.begin(), all.radii.begin() + static_cast<std::ptrdiff_t>(count));
    FeasibleGraph lazy(all.world, all.vehicle, rows, all.queries, radii, executor, GraphMode::kLazy);
    maps.push_back(with_other_turns(all.with_graph(std::move(lazy), radii), all.vehicle, factor));
  };
  std::vector<OtherRoute> known{{all.radii.size(), kFasterFactor}, {all.radii.size(), 1.0}};
  for (OtherRoute way : kOtherRoutes) {
    way.radii = std::clamp(way.radii, smallest.radii.size(), all.radii.size());
    if (std::ranges::find(known, way) != known.end()) continue;
    known.push_back(way);
    add_with(way.radii, way.factor);
  }
  return maps;
}

}  // namespace arcway::internal
