#include <arcway/arcway.h>

#include <iostream>

#include "core/planner/plan_run.h"

static_assert(ARCWAY_VERSION_NUMBER >= 100, "0.1.0 and newer");

int main() {
  const arcway::World world({{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, {}}});
  const arcway::Planner planner(world, arcway::Vehicle{}, arcway::reference_backend(world));
  const arcway::PlanResult result = planner.plan({.start = {0, 0, 0}, .goal = {20, kTopFloor, 0}});
  std::cout << "arcway " << ARCWAY_VERSION_STRING << ", " << arcway::name_of(result.status) << '\n';
  return result.solved() ? 0 : 1;
}
