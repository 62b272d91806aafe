#include "core/search/search_map.h"

#include <utility>

namespace arcway {

namespace {

BoxTree tree_of_vertices(const World& world) {
  std::vector<Box> boxes;
  boxes.reserve(world.convex_vertices().size());
  for (const VertexId v : world.convex_vertices()) boxes.push_back({world.vertex(v), world.vertex(v)});
  return BoxTree(boxes);
}

}  // namespace

SearchMap::SearchMap(const World& w, const Vehicle& v, QuerySet q, std::vector<double> r, FeasibleGraph g)
    : world(w),
      vehicle(v),
      queries(std::move(q)),
      radii(std::move(r)),
      graph(std::move(g)),
      body(v.footprint(0.5 * v.safety_margin())),
      vertices(tree_of_vertices(w)),
      outlines(w) {}

}  // namespace arcway
