// example
#include <arcway/datasets/clutter.h>
#include <arcway/planner.h>

#include <iostream>
#include <vector>

// A map that changes: a box is put across the plan. What lies far from it is not checked again.
int main() {
  const arcway::World before = arcway::random_world({.obstacles = 30, .vertices = 6, .fill = 0.15, .seed = 7});
  const arcway::Planner planner(before, arcway::Vehicle{});
  const arcway::PlanRequest request{.start = {2, 2, 0}, .goal = {60, 50, arcway::kPi / 2}};
  const arcway::PlanResult plan = planner.plan(request);
  std::cout << plan << '\n';
  if (!plan.solved()) return 1;

  const arcway::Path path = plan.path();
  const arcway::Pose halfway = path.at(path.length() / 2);
  const arcway::Polygon box = arcway::Polygon::rectangle(halfway.position(), 2.0, 1.0, halfway.heading);

  const std::vector<arcway::ObstacleKey> removed;  // none goes
  const arcway::Planner next = planner.with_obstacles(removed, {box});
  if (next.is_free(path)) return 1;
  const arcway::PlanResult around = next.plan(request);
  std::cout << around << '\n';
  return around.solved() && next.is_free(around.path()) ? 0 : 1;
}
// end
