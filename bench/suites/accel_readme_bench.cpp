#include <algorithm>
#include <string>
#include <vector>

#include "arcway/datasets/catalog.h"
#include "arcway/validation.h"
#include "bench/suites/plans.h"
#include "bench/suites/readme_plan.h"
#include "bench/suites/suite.h"

// The time of the README's own lines, from a map in memory to the first plan, on all threads of the machine.
namespace arcway::internal::bench::accel_readme_suite {
namespace {

constexpr std::size_t kPlans = 5;  // plans in an iteration, each with a planner of its own

void time_first_plans(benchmark::State& state, const std::string& name) {
  const World& world = shared_world(name);
  const std::vector<PlanRequest> requests = catalog_queries(name, kPlans, 1);
  const auto plan_each = [&] {
    std::vector<PlanResult> results;
    for (const PlanRequest& request : requests) results.push_back(plan_on(world, request));
    return results;
  };
  const auto right = [&] {
    const Validator validator(world);
    const std::vector<PlanResult> results = plan_each();
    return std::ranges::any_of(results, &PlanResult::solved) && std::ranges::all_of(results, [&](const PlanResult& r) {
             return !r.solved() || is_valid(validator, Vehicle(), r);
           });
  };
  if (!require_once(state, "FirstPlan/" + name, right, "no plan, or the validator refuses one")) return;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(plan_each());
  set_batch(state, kPlans);
}

void add(Study study) {
  Series series(study, "FirstPlan/readme", "n", "O(n log n) for queries and triangles", 1.1);
  for (const std::size_t n : sizes(study, {100, 1000, 3000, 10'000, 100'000}, 100, 10'000)) {
    const std::string name = clutter_name("convex", n, 10, 15);
    series.add(static_cast<double>(n), [name](benchmark::State& state) { time_first_plans(state, name); });
  }
}
const Suite suite(add);

}  // namespace
}  // namespace arcway::internal::bench::accel_readme_suite
