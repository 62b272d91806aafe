#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "arcway/planner.h"
#include "arcway/validation.h"
#include "bench/robots.h"

namespace arcway::internal::bench {

/// The fastest queries of this build.
/// @throws Canceled once the clock is over.
QuerySet fastest_queries(const World& world, const StopClock& clock = {});

/// A planner on the fastest builder's graph.
/// @throws Canceled once the executor's clock is over.
Planner make_planner(const World& world, const Vehicle& vehicle, const PlannerOptions& options,
                     const Executor& executor = SerialExecutor());
/// A planner for the paper's robot, made once for each name and heuristic and kept.
const Planner& shared_planner(std::string_view world_name, Heuristic heuristic = Heuristic::kTravelTime);

/// world_for a kept vehicle, made once for each name and kept.
const World& shared_world(const KeptVehicle& kept, std::string_view world_name);

std::vector<PlanResult> plan_all(const Planner& planner, const std::vector<PlanRequest>& requests);

/// What the validator says of the path of a plan, made longer by 1 cm where answers shall be wrong (`corrupting`).
ValidationReport validated(const Validator& validator, const Vehicle& vehicle, const PlanResult& result,
                           const ValidationOptions& options = {});
/// Whether the validator takes the path.
bool is_valid(const Validator& validator, const Vehicle& vehicle, const PlanResult& result);
/// Whether at least one query is solved and the validator takes all paths.
bool are_right(const Planner& planner, const std::vector<PlanResult>& results);

}  // namespace arcway::internal::bench
