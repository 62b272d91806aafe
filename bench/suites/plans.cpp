#include "bench/suites/plans.h"

#include <algorithm>
#include <map>
#include <utility>

#include "bench/suites/backends.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::bench {

ValidationReport validated(const Validator& validator, const Vehicle& vehicle, const PlanResult& result,
                           const ValidationOptions& options) {
  TimedPath path = result.timed_path();
  if (corrupting() && !path.segments.empty()) path.segments.back().length += 0.01;
  return validator(vehicle, result.start, result.goal, path, options);
}

bool is_valid(const Validator& validator, const Vehicle& vehicle, const PlanResult& result) {
  return validated(validator, vehicle, result).valid();
}

QuerySet fastest_queries(const World& world, const StopClock& clock) {
  return query_backends().back().make(world, clock);
}

Planner make_planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options,
                     const Executor& executor) {
  return {world, vehicle,
          backend_of(world, fastest_queries(world, executor.clock()), graph_builders().back().build(world, executor),
                     executor),
          options};
}

const Planner& shared_planner(std::string_view world_name, Heuristic heuristic) {
  static std::map<std::pair<std::string, Heuristic>, Planner> planners;
  const std::pair key{std::string(world_name), heuristic};
  const auto found = planners.find(key);
  if (found != planners.end()) return found->second;
  return planners.emplace(key, make_planner(shared_world(world_name), Vehicle(), {.heuristic = heuristic}))
      .first->second;
}

const World& shared_world(const KeptVehicle& kept, std::string_view world_name) {
  static std::map<std::pair<std::string_view, std::string>, World> worlds;
  const std::pair key{kept.name, std::string(world_name)};
  const auto found = worlds.find(key);
  if (found != worlds.end()) return found->second;
  return worlds.emplace(key, world_for(kept.vehicle(), world_name)).first->second;
}

std::vector<PlanResult> plan_all(const Planner& planner, const std::vector<PlanRequest>& requests) {
  std::vector<PlanResult> results;
  for (const PlanRequest& request : requests) results.push_back(planner.plan(request));
  return results;
}

bool are_right(const Planner& planner, const std::vector<PlanResult>& results) {
  const Validator validator(planner.world());
  const Vehicle& vehicle = planner.vehicle();
  return std::ranges::any_of(results, &PlanResult::solved) && std::ranges::all_of(results, [&](const PlanResult& r) {
           return !r.solved() || is_valid(validator, vehicle, r);
         });
}

}  // namespace arcway::internal::bench
