#include "accel/expansion/triangular_expansion.h"

#include <algorithm>
#include <span>

#include "core/base/prefetch.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

void TriangularExpansion::find_walls(const Vec2& p, Scratch& scratch) const {
  scratch.walls.clear();
  find_views(p, scratch);
  for (const View& view : scratch.views) look_through(p, view, scratch);
}

// Lines of sight past sites follow each other without gaps as long as there is an open range beside them; where there
// is none, lines are followed by themselves.
void TriangularExpansion::find_sites(const Vec2& p, std::uint32_t own, Scratch& scratch) const {
  scratch.sites.clear();
  find_walls(p, scratch);
  for (const View& view : scratch.views) {
    scratch.sites.push_back(view.right);
    scratch.sites.push_back(view.left);
  }
  follow_lines_between_walls(p, scratch);
  if (own != kNone) follow_edges_between_obstacles(p, own, scratch);
}

// The edges of the triangles at p that are seen from there.
void TriangularExpansion::find_views(const Vec2& p, Scratch& scratch) const {
  scratch.views.clear();
  const std::span<const Vec2> at = map_.sites();
  for (const std::uint32_t t : scratch.triangles)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t right = trace_.corner(t, k), left = trace_.corner(t, (k + 1) % 3);
      if (orientation(at[right], at[left], p) > 0)
        scratch.views.push_back({right, left, trace_.door_out(t, k), right, left, at[right] - p, at[left] - p});
    }
  std::sort(scratch.views.begin(), scratch.views.end(),
            [&](const View& a, const View& b) { return precedes_about(p, at[a.right], at[b.right]); });
}

// To the walls, from right to left. A site on a limit is seen as well, along with what is within.
void TriangularExpansion::look_through(const Vec2& p, const View& view, Scratch& scratch) const {
  const SightMap::Door* const doors = map_.doors().data();
  std::vector<View>& postponed = scratch.postponed;
  postponed.clear();
  View v = view;
  while (true) {
    if (v.door != kNone) {
      const SightMap::Door& triangle = doors[v.door];
      will_need(doors + triangle.left);
      will_need(doors + triangle.right);
      const int low = side(p, v.low, v.to_low, triangle), high = side(p, v.high, v.to_high, triangle);
      if (low >= 0 && high <= 0) scratch.sites.push_back(triangle.site);
      if (low > 0 && high < 0) {
        const Vec2 middle = triangle.apex - p;
        postponed.push_back({triangle.site, v.left, triangle.left, triangle.site, v.high, middle, v.to_high});
        v.high = triangle.site;
        v.to_high = middle;
      }
      (low > 0 ? v.left : v.right) = triangle.site;
      v.door = low > 0 ? triangle.right : triangle.left;
      continue;
    }
    scratch.walls.push_back(v);
    if (postponed.empty()) return;
    v = postponed.back();
    postponed.pop_back();
  }
}

// Where one wall ends and the next one begins on the line between them, the line may go on.
void TriangularExpansion::follow_lines_between_walls(const Vec2& p, Scratch& scratch) const {
  const std::vector<View>& walls = scratch.walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const View &wall = walls[i], &next = walls[(i + 1) % walls.size()];
    const bool ends = is_on(p, wall.left, wall.high), begins = is_on(p, next.right, next.low);
    if (wall.high != next.low) {  // an obstacle at p is between them
      if (ends) trace_.append_sites_on(p, wall.left, scratch.sites);
      if (begins) trace_.append_sites_on(p, next.right, scratch.sites);
    } else if (ends && begins && !(wall.left == next.right && is_of_one_wall(wall.left))) {
      trace_.append_sites_on(p, wall.left, scratch.sites);
    }
  }
}

// Beside these there is no triangle.
void TriangularExpansion::follow_edges_between_obstacles(const Vec2& p, std::uint32_t own, Scratch& scratch) const {
  if (!scratch.triangles.empty() && is_of_one_wall(own)) return;
  const auto follow = [&](const PlanarMap::Edge& edge, std::uint32_t end) {
    const auto ends_at_it = [&](const View& v) { return v.right == end || v.left == end; };
    if (!map_.is_covered(edge) && std::ranges::none_of(scratch.views, ends_at_it))
      trace_.append_sites_on(p, end, scratch.sites);
  };
  for (const PlanarMap::Edge& edge : map_.edges_from(own)) follow(edge, edge.high);
  for (const std::uint32_t e : map_.edges_to(own)) follow(map_.edge(e), map_.edge(e).low);
}

// +1 if the apex of a triangle lies to the left of the line from p to a site.
int TriangularExpansion::side(const Vec2& p, std::uint32_t site, const Vec2& to_site,
                              const SightMap::Door& triangle) const {
  const double product = cross(to_site, triangle.apex - p);
  if (product > sure_) return 1;
  if (product < -sure_) return -1;
  return orientation(p, map_.sites()[site], triangle.apex);
}

// Whether a site lies on the line from p to the limit.
bool TriangularExpansion::is_on(const Vec2& p, std::uint32_t site, std::uint32_t limit) const {
  return site == limit || orientation(p, map_.sites()[limit], map_.sites()[site]) == 0;
}

// Whether two edges are all that meets a site: if one of them is a wall with free space beside it, so is the other one,
// and the inside of an obstacle is on their other side.
bool TriangularExpansion::is_of_one_wall(std::uint32_t site) const {
  return map_.is_whole() && map_.edges_from(site).size() + map_.edges_to(site).size() == 2;
}

}  // namespace arcway::internal
