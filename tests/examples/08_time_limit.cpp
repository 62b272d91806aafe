// example
#include <arcway/datasets/clutter.h>
#include <arcway/planner.h>

#include <iostream>

// The best path found within a time limit, or the reason why there is none.
int main() {
  const arcway::World world = arcway::random_world({.obstacles = 30, .vertices = 6, .fill = 0.15, .seed = 7});
  const arcway::Planner planner(world, arcway::Vehicle{});
  const arcway::PlanResult plan = planner.plan({.start = {2, 2, 0}, .goal = {60, 50, 0}}, {.time = 0.05});
  if (plan.solved())
    std::cout << plan.travel_time << " s, at most " << 100.0 * plan.optimality_gap() << " % slower than the fastest"
              << (plan.interrupted ? ", when the time was up\n" : "\n");
  else
    std::cout << arcway::name_of(plan.status) << ", " << arcway::name_of(plan.certainty) << ": " << plan.reason << '\n';
  return 0;
}
// end
