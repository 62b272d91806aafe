#include "bench/suites/cgal_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace arcway::bench {

std::size_t triangulate_by_cgal(const World& world) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  points.reserve(world.vertices().size());
  for (const Vec2& p : world.vertices()) points.emplace_back(p.x(), p.y());
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(points.size());
  for (VertexId v = 0; v < points.size(); ++v) edges.emplace_back(v, world.next(v));
  CGAL::Constrained_Delaunay_triangulation_2<Kernel> triangulation;
  triangulation.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
  return triangulation.number_of_faces();
}

}  // namespace arcway::bench
