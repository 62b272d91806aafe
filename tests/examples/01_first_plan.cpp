// example
#include <arcway/planner.h>

#include <iostream>

// A first plan: a robot drives around a wall, and tells where it is every half second.
int main() {
  const arcway::World world({arcway::Polygon::rectangle({8, -4}, {10, 6})});
  const arcway::PlanResult result = arcway::plan(world, arcway::Vehicle{}, {0, 0, 0}, {20, 0, 0});
  std::cout << result << '\n';
  if (!result.solved()) return 1;
  const arcway::Trajectory trajectory = result.trajectory();
  for (const arcway::TrajectoryState& state : trajectory.sample(0.5)) std::cout << state << '\n';
  return 0;
}
// end
