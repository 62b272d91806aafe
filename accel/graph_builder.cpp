#include "accel/graph_builder.h"

namespace arcway {

namespace {

// Where both took as long, on convex clutters: 1,000 vertices each with 10 obstacles, 1,000 with 100, above 4,000 with
// 1,000.
constexpr std::size_t kManyVertices = 2000;
constexpr std::size_t kFewObstacles = 500;
constexpr std::size_t kMostWedgeVertices = std::size_t{1} << 28;

bool all_convex(const World& world) {
  for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
    const auto [first, last] = world.vertices_of(o);
    for (VertexId v = first; v < last; ++v)
      if (!world.is_convex(v)) return false;
  }
  return true;
}

}  // namespace

const char* name_of(GraphBuilder builder) { return builder == GraphBuilder::kPairwise ? "pairwise" : "wedge"; }

GraphBuilder faster_graph_builder(const World& world) {
  const std::size_t vertices = world.vertices().size(), obstacles = world.obstacle_count();
  if (vertices > kMostWedgeVertices) return GraphBuilder::kPairwise;
  const bool many_each = obstacles > 0 && vertices / obstacles >= kManyVertices;
  return many_each && obstacles <= kFewObstacles && all_convex(world) ? GraphBuilder::kPairwise : GraphBuilder::kWedge;
}

}  // namespace arcway
