// example
#include <arcway/alternatives.h>
#include <arcway/planner.h>
#include <arcway/tour.h>

#include <iostream>

// A tour over a waypoint to the nearer of two goals, and different routes between two poses.
int main() {
  const arcway::World world({arcway::Polygon::rectangle({8, -4}, {12, 4})});
  const arcway::Planner planner(world, arcway::Vehicle{});
  const arcway::Tour tour = arcway::plan_tour(
      planner, {.start = {0, 0, 0}, .waypoints = {{{10, 8}}}, .goals = {{{20, 0}, 0.0}, {{20, 30}, arcway::kPi / 2}}});
  std::cout << tour << '\n';
  const std::vector<arcway::PlanResult> routes =
      arcway::plan_alternatives(planner, {.start = {0, 0, 0}, .goal = {20, 0, 0}}, 2);
  for (const arcway::PlanResult& route : routes) std::cout << route << '\n';
  return tour.plan.solved() && routes.size() == 2 ? 0 : 1;
}
// end
