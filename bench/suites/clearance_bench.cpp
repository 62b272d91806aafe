#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "arcway/sweep_query.h"
#include "bench/suites/corruption.h"
#include "bench/suites/suite.h"
#include "core/geometry/distance.h"
#include "core/motion/clearance.h"
#include "datasets/io/random.h"

// How near a moving body comes to the obstacles, in closed form; checked against poses close together.
namespace arcway::internal::bench::clearance_suite {
namespace {

constexpr std::size_t kSegments = 256;

std::vector<PathSegment> random_segments(const World& world) {
  Random random(1);
  const Box& box = world.box();
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i < kSegments; ++i) {
    const Vec2 along = random.unit_vector();
    const Pose start{random.uniform(box.min.x(), box.max.x()), random.uniform(box.min.y(), box.max.y()),
                     std::atan2(along.y(), along.x())};
    const double curvature = i % 2 == 0 ? 0.0 : random.uniform(-0.7, 0.7);
    segments.push_back({start, random.uniform(0.5, 4.0), curvature});
  }
  return segments;
}

double clearance_at(const Pose& pose, const Footprint& body, const World& world) {
  const SweptRectangle standing = swept_rectangle(pose, 0.0, body);
  double nearest = std::numeric_limits<double>::infinity();
  for (const LineSegment& edge : world.edges()) nearest = std::min(nearest, distance(edge, standing));
  return nearest;
}

/// No pose on the way is nearer than what is found, and the nearest one no further away than the body moves in half a
/// step.
bool is_clearance(double found, const PathSegment& segment, const Footprint& body, const World& world) {
  constexpr int kSteps = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i)
    least = std::min(least, clearance_at(segment.at(segment.length * i / kSteps), body, world));
  const double reach = body.farthest();
  const double half_step = 0.5 * segment.length / kSteps * (1.0 + std::abs(segment.curvature) * reach);
  return found <= least + 1e-9 && found >= least - half_step;
}

void time_clearance(benchmark::State& state, const std::string& world_name) {
  const World& world = shared_world(world_name);
  const Footprint body = Vehicle().footprint();
  const std::vector<PathSegment> segments = random_segments(world);
  const auto right = [&] {
    constexpr std::size_t kChecked = 8;
    for (std::size_t i = 0; i < kChecked; ++i) {
      const double found = clearance_along(segments[i], body, world).distance + (corrupting() ? 1.0 : 0.0);
      if (!is_clearance(found, segments[i], body, world)) return false;
    }
    return true;
  };
  if (!require_once(state, "PathClearance/" + world_name, right, "poses on the way are nearer or all further")) return;
  for ([[maybe_unused]] auto _ : state)
    for (const PathSegment& segment : segments) benchmark::DoNotOptimize(clearance_along(segment, body, world));
  set_batch(state, kSegments);
}

void add(Study study) {
  Series series(study, "PathClearance", "obstacles", "O(obstacles + edges of those near by)", 1.0);
  for (const std::size_t n : sizes(study, {10, 32, 100, 316, 1000, 10000}, 10, 1000))
    series.add(static_cast<double>(n),
               [n](benchmark::State& state) { time_clearance(state, clutter_name("convex", n, 10, 30)); });
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::clearance_suite
