#include "accel/expansion/triangular_expansion.h"

#include <algorithm>
#include <span>

#include "core/base/prefetch.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

void TriangularExpansion::find_boundary(const Vec2& p, Scratch& scratch) const {
  scratch.boundary.clear();
  find_views(p, scratch);
  for (const View& view : scratch.views) expand(p, view, scratch);
}

// Lines of sight past points are found by the expansion as long as there is an open cone beside them. Where there is
// none, the line itself is followed.
void TriangularExpansion::find_points(const Vec2& p, std::uint32_t own, Scratch& scratch) const {
  scratch.points.clear();
  find_boundary(p, scratch);
  for (const View& view : scratch.views) {
    scratch.points.push_back(view.right);
    scratch.points.push_back(view.left);
  }
  follow_lines_between_pieces(p, scratch);
  if (own != kNone) follow_edges_between_obstacles(p, own, scratch);
}

// Edges of the triangles at p that p sees from inside.
void TriangularExpansion::find_views(const Vec2& p, Scratch& scratch) const {
  scratch.views.clear();
  const std::span<const Vec2> at = triangulation_.points();
  for (const std::uint32_t t : scratch.triangles)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t right = trace_.corner(t, k), left = trace_.corner(t, (k + 1) % 3);
      if (orientation(at[right], at[left], p) > 0)
        scratch.views.push_back({right, left, trace_.half_edge_out(t, k), right, left, at[right] - p, at[left] - p});
    }
  std::sort(scratch.views.begin(), scratch.views.end(),
            [&](const View& a, const View& b) { return precedes_about(p, at[a.right], at[b.right]); });
}

// Expands a view to the boundary, from right to left. A point on a bounding ray is visible too.
void TriangularExpansion::expand(const Vec2& p, const View& view, Scratch& scratch) const {
  const FreeSpaceTriangulation::HalfEdge* const half_edges = triangulation_.half_edges().data();
  std::vector<View>& postponed = scratch.postponed;
  postponed.clear();
  View v = view;
  while (true) {
    if (v.half_edge != kNone) {
      const FreeSpaceTriangulation::HalfEdge& triangle = half_edges[v.half_edge];
      will_need(half_edges + triangle.left);
      will_need(half_edges + triangle.right);
      const int low = side(p, v.low, v.to_low, triangle), high = side(p, v.high, v.to_high, triangle);
      if (low >= 0 && high <= 0) scratch.points.push_back(triangle.point);
      if (low > 0 && high < 0) {
        const Vec2 middle = triangle.apex - p;
        postponed.push_back({triangle.point, v.left, triangle.left, triangle.point, v.high, middle, v.to_high});
        v.high = triangle.point;
        v.to_high = middle;
      }
      (low > 0 ? v.left : v.right) = triangle.point;
      v.half_edge = low > 0 ? triangle.right : triangle.left;
      continue;
    }
    scratch.boundary.push_back(v);
    if (postponed.empty()) return;
    v = postponed.back();
    postponed.pop_back();
  }
}

// Where one boundary piece ends and the next one begins on the line between them, the line may go on.
void TriangularExpansion::follow_lines_between_pieces(const Vec2& p, Scratch& scratch) const {
  const std::vector<View>& pieces = scratch.boundary;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const View &piece = pieces[i], &next = pieces[(i + 1) % pieces.size()];
    const bool ends = is_on(p, piece.left, piece.high), begins = is_on(p, next.right, next.low);
    if (piece.high != next.low) {  // an obstacle at p is between them
      if (ends) trace_.append_points_on(p, piece.left, scratch.points);
      if (begins) trace_.append_points_on(p, next.right, scratch.points);
    } else if (ends && begins && !(piece.left == next.right && is_of_one_boundary(piece.left))) {
      trace_.append_points_on(p, piece.left, scratch.points);
    }
  }
}

// No triangle lies beside an edge between two obstacles.
void TriangularExpansion::follow_edges_between_obstacles(const Vec2& p, std::uint32_t own, Scratch& scratch) const {
  if (!scratch.triangles.empty() && is_of_one_boundary(own)) return;
  const auto follow = [&](const PlanarMap::Edge& edge, std::uint32_t end) {
    const auto ends_at_it = [&](const View& v) { return v.right == end || v.left == end; };
    if (!triangulation_.is_covered(edge) && std::ranges::none_of(scratch.views, ends_at_it))
      trace_.append_points_on(p, end, scratch.points);
  };
  for (const PlanarMap::Edge& edge : triangulation_.edges_from(own)) follow(edge, edge.high);
  for (const std::uint32_t e : triangulation_.edges_to(own)) follow(triangulation_.edge(e), triangulation_.edge(e).low);
}

// +1 if the apex of a triangle lies to the left of the line from p to a point.
int TriangularExpansion::side(const Vec2& p, std::uint32_t point, const Vec2& to_point,
                              const FreeSpaceTriangulation::HalfEdge& triangle) const {
  const double product = cross(to_point, triangle.apex - p);
  if (product > sure_) return 1;
  if (product < -sure_) return -1;
  return orientation(p, triangulation_.points()[point], triangle.apex);
}

// Whether a point lies on the line from p to another point.
bool TriangularExpansion::is_on(const Vec2& p, std::uint32_t point, std::uint32_t toward) const {
  return point == toward || orientation(p, triangulation_.points()[toward], triangulation_.points()[point]) == 0;
}

// Whether exactly two edges meet a point. If one of them is a boundary edge, so is the other one, and the inside of an
// obstacle lies behind both.
bool TriangularExpansion::is_of_one_boundary(std::uint32_t point) const {
  return triangulation_.is_valid() &&
         triangulation_.edges_from(point).size() + triangulation_.edges_to(point).size() == 2;
}

}  // namespace arcway::internal
