#pragma once

/// \file
/// The lines of the main README about accel, as they stand there: the benchmarks time them, the consumer's test runs
/// them.

// example
#include <arcway/accel/accel_backend.h>
#include <arcway/planner.h>

inline arcway::PlanResult plan_on(const arcway::World& world, const arcway::PlanRequest& request) {
  const arcway::Planner planner(world, arcway::Vehicle{}, arcway::accel_backend(world));
  return planner.plan(request);
}
// end
