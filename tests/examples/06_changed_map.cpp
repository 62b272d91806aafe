// example
#include <arcway/datasets/clutter.h>
#include <arcway/planner.h>
#include <arcway/world_change.h>

#include <iostream>

// An obstacle goes and another one comes: what lies far from both is not checked again.
int main() {
  const arcway::World before = arcway::random_world({.obstacles = 30, .vertices = 6, .fill = 0.15, .seed = 7});
  const arcway::Planner planner(before, arcway::Vehicle{});
  const std::vector<arcway::ObstacleId> removed{4};
  const arcway::World after = before.changed(removed, {{{{30, 30}, {34, 30}, {34, 33}, {30, 33}}, {}}});
  const arcway::Planner next =
      arcway::Planner::changed(planner, arcway::WorldChange(before, after, removed), arcway::reference_backend(after));
  const arcway::PlanResult plan = next.plan({.start = {2, 2, 0}, .goal = {60, 50, arcway::kPi / 2}});
  std::cout << (plan.solved() ? "solved" : plan.reason) << ": " << plan.travel_time << " s\n";
  return plan.solved() ? 0 : 1;
}
// end
