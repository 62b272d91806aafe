#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "arcway/path.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "tests/support/random_bodies.h"

namespace arcway::internal::test {

/// The parts of a body, for PlacedBody.
inline std::vector<Ring> parts_of(const Body& body) {
  if (body.shape != nullptr) return {body.shape->pieces.begin(), body.shape->pieces.end()};
  return {{{-body.rear, -body.right}, {body.front, -body.right}, {body.front, body.left}, {-body.rear, body.left}}};
}

/// What driving close in clearance zones costs by samples.
struct SampledCost {
  double cost = 0.0;   ///< [s]
  double doubt = 0.0;  ///< by which that may be off: cells in which something changes [s]
};

/// Samples a path in cells of a length: in each zone the place of F and the distance of the grown body from all edges.
/// Shares no decision with the planner.
inline SampledCost sampled_cost(const Path& path, const World& world, const Vehicle& vehicle, double cell_length) {
  SampledCost sum;
  for (const Zone& zone : world.zones()) {
    const auto* rule = std::get_if<KeepClear>(&zone.rule);
    if (rule == nullptr) continue;
    const World area({zone.area});
    const std::vector<Ring> parts = parts_of(vehicle.body(rule->distance));
    for (const PathSegment& segment : path) {
      const int cells = std::max(1, static_cast<int>(std::ceil(segment.length / cell_length)));
      const double cell = segment.length / cells;
      bool before = false;
      for (int i = 0; i < cells; ++i) {
        const Pose pose = segment.at((i + 0.5) * cell);
        const bool counts = area.locate(pose.position(), 0) != PointLocation::kOutside &&
                            PlacedBody(parts, pose).distance_to(world) == 0.0L;
        if (counts) sum.cost += rule->cost * cell;
        if (counts != before) sum.doubt += rule->cost * cell;
        before = counts;
      }
      sum.doubt += 2.0 * rule->cost * cell;  // at its ends
    }
  }
  return sum;
}

}  // namespace arcway::internal::test
