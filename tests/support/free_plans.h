#pragma once

#include "arcway/angle.h"
#include "arcway/planner.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// A pose somewhere in a world's box, a little off its border; free or not.
inline Pose pose_in(const World& world, RandomInputs& random) {
  const Vec2 low = world.box().min, span = world.box().max - low;
  const Vec2 place = low + span.cwiseProduct(random.point(0.05, 0.95));
  return {place.x(), place.y(), random.uniform(-kPi, kPi)};
}

/// A request between poses in the square from the origin to (side, side); free or not.
inline PlanRequest request_within(double side, RandomInputs& random) {
  return {.start = {random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)},
          .goal = {random.uniform(0, side), random.uniform(0, side), random.uniform(-3, 3)}};
}

/// A request between poses of a world, and the path that is found for it.
struct FreePlan {
  PlanRequest request;
  Path path;
};

/// The next one that a planner solves.
inline FreePlan next_free_plan(const Planner& planner, RandomInputs& random) {
  for (;;) {
    const Pose start = pose_in(planner.world(), random), goal = pose_in(planner.world(), random);
    const PlanRequest request{start, goal};
    if (const PlanResult plan = planner.plan(request); plan.solved()) return {request, plan.path()};
  }
}

}  // namespace arcway::internal::test
