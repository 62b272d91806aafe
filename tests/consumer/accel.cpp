#include <iostream>

#include "readme_plan.h"

int main() {
  const arcway::World world({{{{4, -1}, {6, -1}, {6, 1}, {4, 1}}, {}}});
  const arcway::PlanResult result = plan_on(world, {.start = {0, 0, 0}, .goal = {20, 0, 0}});
  std::cout << arcway::name_of(result.status) << ": " << result.travel_time << " s\n";
  return result.solved() ? 0 : 1;
}
