#include "accel/embree/embree_queries.h"
#include "core/geometry/distance.h"

namespace arcway::internal::embree {

void EmbreeDistance::do_closest(std::span<const Vec2> points, std::span<ClosestPoint> result) const {
  scenes_->for_batch(points.size(), [&](std::size_t begin, std::size_t end) {
    const std::span<const LineSegment> edges = scenes_->world().edges();
    for (std::size_t i = begin; i < end; ++i) {
      ClosestPoint best;
      scenes_->visibility.edges().visit_near(points[i], best.distance, [&](VertexId e) {
        const Vec2 candidate = closest_point(points[i], edges[e]);
        const double distance = (candidate - points[i]).norm();
        if (distance < best.distance || (distance == best.distance && e < best.edge)) best = {distance, candidate, e};
        return best.distance;
      });
      result[i] = best;
    }
  });
}

void EmbreeDistance::do_closer_than(std::span<const Vec2> points, std::span<const double> distances,
                                    std::span<std::uint8_t> closer) const {
  scenes_->for_batch(points.size(), [&](std::size_t begin, std::size_t end) {
    const std::span<const LineSegment> edges = scenes_->world().edges();
    for (std::size_t i = begin; i < end; ++i) {
      bool found = false;
      if (distances[i] > 0.0) {
        scenes_->visibility.edges().visit_near(points[i], distances[i], [&](VertexId e) {
          found = (closest_point(points[i], edges[e]) - points[i]).norm() < distances[i];
          return found ? -1.0 : distances[i];
        });
      }
      closer[i] = found ? 1 : 0;
    }
  });
}

void EmbreeDistance::do_containing(std::span<const Vec2> points, std::span<ObstacleId> result) const {
  scenes_->for_batch(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = scenes_->locator.containing(points[i]);
  });
}

}  // namespace arcway::internal::embree
