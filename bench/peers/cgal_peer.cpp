#include "bench/peers/cgal_peer.h"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <CGAL/version.h>

#include <algorithm>
#include <map>
#include <utility>

namespace arcway::internal::peers {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Visibility = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;
using Coordinates = std::pair<double, double>;

}  // namespace

struct CgalVisibility::Data {
  Arrangement arrangement;
  std::map<Coordinates, VertexId> vertices;
  std::vector<Arrangement::Halfedge_const_handle> seen_from;  // ends at the vertex, free space on its left
  Visibility visibility;
};

CgalVisibility::CgalVisibility(const World& world) : data_(std::make_unique<Data>()) {
  std::vector<Kernel::Segment_2> segments;
  for (const LineSegment& e : world.edges())
    segments.emplace_back(Kernel::Point_2(e.a.x(), e.a.y()), Kernel::Point_2(e.b.x(), e.b.y()));
  CGAL::insert_non_intersecting_curves(data_->arrangement, segments.begin(), segments.end());
  for (VertexId v = 0; v < world.vertices().size(); ++v)
    data_->vertices.emplace(Coordinates(world.vertex(v).x(), world.vertex(v).y()), v);
  const auto id_of = [&](const Kernel::Point_2& p) {
    return data_->vertices.at({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
  };
  data_->seen_from.resize(world.vertices().size());
  for (auto h = data_->arrangement.halfedges_begin(); h != data_->arrangement.halfedges_end(); ++h) {
    const VertexId target = id_of(h->target()->point());
    // Obstacles lie to the left of v -> next(v), free space to the left of the way back.
    if (world.next(target) == id_of(h->source()->point())) data_->seen_from[target] = h;
  }
  data_->visibility.attach(data_->arrangement);
}

CgalVisibility::~CgalVisibility() = default;

std::vector<VertexId> CgalVisibility::visible_from(VertexId v) const {
  const Arrangement::Halfedge_const_handle edge = data_->seen_from[v];
  Arrangement region;
  data_->visibility.compute_visibility(edge->target()->point(), edge, region);
  std::vector<VertexId> seen;
  for (auto corner = region.vertices_begin(); corner != region.vertices_end(); ++corner) {
    const auto found =
        data_->vertices.find({CGAL::to_double(corner->point().x()), CGAL::to_double(corner->point().y())});
    if (found != data_->vertices.end() && found->second != v) seen.push_back(found->second);
  }
  std::ranges::sort(seen);
  return seen;
}

std::size_t triangulate_by_cgal(const World& world) {
  using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Fast::Point_2> points;
  points.reserve(world.vertices().size());
  for (const Vec2& p : world.vertices()) points.emplace_back(p.x(), p.y());
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(points.size());
  for (VertexId v = 0; v < points.size(); ++v) edges.emplace_back(v, world.next(v));
  CGAL::Constrained_Delaunay_triangulation_2<Fast> triangulation;
  triangulation.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
  return triangulation.number_of_faces();
}

std::string cgal_version() {
  constexpr long kNumber = CGAL_VERSION_NR;  // 1MMmmb1000
  return std::to_string(kNumber / 10'000'000 % 100) + "." + std::to_string(kNumber / 100'000 % 100) + "." +
         std::to_string(kNumber / 10'000 % 10);
}

}  // namespace arcway::internal::peers
