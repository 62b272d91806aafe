// example
#include <arcway/datasets/clutter.h>
#include <arcway/planner.h>

#include <iostream>

int main() {
  const arcway::World world = arcway::random_world({.obstacles = 30, .vertices = 6, .fill = 0.15, .seed = 7});
  const arcway::Planner planner(world, arcway::Vehicle{});
  const arcway::PlanResult result = planner.plan({.start = {2, 2, 0}, .goal = {60, 50, arcway::kPi / 2}});
  std::cout << (result.solved() ? "solved" : result.reason) << ": " << result.travel_time << " s\n";
  return result.solved() ? 0 : 1;
}
// end
