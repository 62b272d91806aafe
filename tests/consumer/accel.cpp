#include <iostream>

#include "accel/backend/accel_backend.h"
#include "core/planner/planner.h"

int main() {
  const arcway::World world({{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, {}}});
  // As in the main README.
  const arcway::Planner planner(world, arcway::Vehicle{}, arcway::accel_backend(world));
  const arcway::PlanResult result = planner.plan({.start = {0, 0, 0}, .goal = {20, 0, 0}});
  std::cout << arcway::name_of(result.status) << ": " << result.travel_time << " s\n";
  return result.solved() ? 0 : 1;
}
