#include <iostream>

#include "accel/parallel.h"
#include "core/planner.h"

int main() {
  const arcway::World world({{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, {}}});
  const arcway::Planner planner(world, arcway::Vehicle{}, arcway::make_reference_queries(world), {},
                                arcway::TbbExecutor(2));
  const arcway::PlanResult result = planner.plan({.start = {0, 0, 0}, .goal = {20, 0, 0}});
  std::cout << arcway::name_of(result.status) << ": " << result.travel_time << " s\n";
  return result.solved() ? 0 : 1;
}
