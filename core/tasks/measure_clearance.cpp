#include "core/tasks/measure_clearance.h"

#include <cstddef>

#include "core/motion/clearance.h"

namespace arcway::internal {

void measure_clearance(const World& world, const Vehicle& vehicle, PlanResult& plan) {
  const Body bare = vehicle.body();
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const PathSegment& segment = plan.segments[i].segment;
    const double clearance = clearance_along(segment, bare, world).distance;
    if (i > 0 && clearance >= plan.min_clearance) continue;
    plan.min_clearance = clearance;
    plan.clearance_segment = segment;
    plan.clearance_index = i;
  }
}

}  // namespace arcway::internal
