// example
#include <arcway/planner.h>
#include <arcway/validation.h>

#include <iostream>

// A delivery van of 6 m backs into a loading bay. The plan is checked, and printed as a controller takes it.
int main() {
  const arcway::Vehicle van({.length = 6.0,
                             .width = 2.1,
                             .wheelbase = 3.7,
                             .max_steering_angle = 0.61,
                             .max_speed = 8.0,
                             .turn_speed = arcway::LateralAccelerationLimit{1.5},
                             .max_reverse_speed = 2.0,
                             .max_acceleration = 1.2,
                             .safety_margin = 0.2});
  std::cout << van << '\n';
  const arcway::World yard = arcway::World::from_polygons(
      {arcway::Polygon::rectangle({0, 10}, {18, 20}), arcway::Polygon::rectangle({22, 10}, {40, 20})},
      arcway::Polygon::rectangle({-20, -20}, {60, 20}));
  const arcway::Planner planner(yard, van);
  const arcway::PlanRequest request{.start = {0, 0, 0}, .goal = {20, 17, -arcway::kPi / 2}, .reverse = true};
  if (!planner.is_free(request.goal)) return 1;
  const arcway::PlanResult plan = planner.plan(request, {.time = 10.0});
  std::cout << plan << '\n';
  if (!plan.solved()) return 1;
  for (const arcway::TrajectoryState& s : plan.trajectory().sample(1.0))
    std::cout << s.time << " s: " << s.speed << " m/s " << s.gear << ", steering " << s.steering_angle << " rad\n";
  const arcway::ValidationReport report = arcway::validate(yard, van, plan.start, plan.goal, plan.timed_path());
  std::cout << report << '\n';
  return report.valid() ? 0 : 1;
}
// end
