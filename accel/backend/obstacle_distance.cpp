#include "arcway/accel/obstacle_distance.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "accel/embree/edge_scene.h"
#include "core/geometry/distance.h"

namespace arcway {

using namespace internal;

namespace {

bool operator<(const ObstacleDistance& x, const ObstacleDistance& y) {
  return std::tie(x.distance, x.edge_a, x.edge_b) < std::tie(y.distance, y.edge_a, y.edge_b);
}

void require_regions(const World& world, std::span<const ObstacleId> ids) {
  for (const ObstacleId id : ids)
    if (id >= world.region_count())
      throw std::invalid_argument("obstacle distance: obstacle " + std::to_string(id) + " of " +
                                  std::to_string(world.region_count()));
}

}  // namespace

struct ObstacleDistances::Scene {
  explicit Scene(const World& world) : edges(std::make_shared<const embree::Device>(), world, nullptr, {}) {}

  [[nodiscard]] const World& world() const { return edges.world(); }

  // Lowers `best` to the nearest pair of an edge and an edge of the regions that `belongs` accepts.
  template <class Belongs>
  void lower(ObstacleDistance& best, VertexId edge, const Belongs& belongs) const {
    const LineSegment& s = world().edges()[edge];
    const Vec2 middle = 0.5 * (s.a + s.b);  // rounded: perhaps nearer to one of the ends
    const double half = std::max((s.a - middle).norm(), (s.b - middle).norm());
    edges.visit_near(middle, half + best.distance, [&](VertexId other) {
      if (belongs(world().obstacle_of(other))) {
        const ObstacleDistance found{distance(s, world().edges()[other]), edge, other};
        if (found < best) best = found;
      }
      return half + best.distance;
    });
  }

  // Distance of some pair of edges, as a first bound.
  [[nodiscard]] ObstacleDistance some_distance(ObstacleId a, ObstacleId b) const {
    const VertexId edge_a = world().vertices_of(a).first;
    const VertexId edge_b = world().vertices_of(b).first;
    return {distance(world().edges()[edge_a], world().edges()[edge_b]), edge_a, edge_b};
  }

  embree::EdgeScene edges;
};

ObstacleDistances::ObstacleDistances(const World& world) : scene_(std::make_unique<const Scene>(world)) {}
ObstacleDistances::~ObstacleDistances() = default;
ObstacleDistances::ObstacleDistances(ObstacleDistances&&) noexcept = default;
ObstacleDistances& ObstacleDistances::operator=(ObstacleDistances&&) noexcept = default;

ObstacleDistance ObstacleDistances::between(std::span<const ObstacleId> a, std::span<const ObstacleId> b,
                                            const Executor& executor) const {
  const World& world = scene_->world();
  require_regions(world, a);
  require_regions(world, b);
  if (a.empty() || b.empty()) return {};
  std::vector<std::uint8_t> in_b(world.region_count(), 0);
  for (const ObstacleId o : b) in_b[o] = 1;
  std::vector<VertexId> edges_of_a;
  for (const ObstacleId o : a) {
    const auto [first, last] = world.vertices_of(o);
    for (VertexId e = first; e < last; ++e) edges_of_a.push_back(e);
  }

  // The bound that a range starts from depends on the threads; the minimum over all pairs does not.
  ObstacleDistance best = scene_->some_distance(a[0], b[0]);
  std::mutex mutex;
  executor.for_ranges(edges_of_a.size(), 16, [&](std::size_t begin, std::size_t end) {
    ObstacleDistance least;
    {
      const std::lock_guard lock(mutex);
      least = best;
    }
    for (std::size_t i = begin; i < end; ++i)
      scene_->lower(least, edges_of_a[i], [&](ObstacleId o) { return in_b[o] != 0; });
    const std::lock_guard lock(mutex);
    if (least < best) best = least;
  });
  return best;
}

void ObstacleDistances::between(std::span<const ObstaclePair> pairs, std::span<ObstacleDistance> result,
                                const Executor& executor) const {
  if (pairs.size() != result.size())
    throw std::invalid_argument("obstacle distance: " + std::to_string(pairs.size()) + " pairs but room for " +
                                std::to_string(result.size()) + " distances");
  const World& world = scene_->world();
  for (const ObstaclePair& pair : pairs) {
    require_regions(world, {&pair.a, 1});
    require_regions(world, {&pair.b, 1});
  }
  executor.for_ranges(pairs.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result[i] = scene_->some_distance(pairs[i].a, pairs[i].b);
      const auto [first, last] = world.vertices_of(pairs[i].a);
      for (VertexId e = first; e < last; ++e)
        scene_->lower(result[i], e, [&](ObstacleId o) { return o == pairs[i].b; });
    }
  });
}

}  // namespace arcway
