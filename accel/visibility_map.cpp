#include "accel/visibility_map.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "accel/region_locator.h"
#include "accel/wedge/sight_map.h"
#include "accel/wedge/sight_trace.h"
#include "accel/wedge/wedge_walk.h"
#include "core/geometry/crossing_point.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"
#include "core/graph/visibility_graph.h"
#include "core/query/blocking.h"
#include "core/shortest_text.h"

namespace arcway {

namespace {

using End = SightTrace::End;
using Kind = SightTrace::End::Kind;

// What is seen through an edge between two directions, both towards sites.
struct View {
  std::uint32_t right, left;  // ends of the edge
  std::uint32_t door;         // kNone: a wall
  std::uint32_t low, high;    // sites that limit the directions
};

// Where the line from p through `through` meets a wall, rounded.
Vec2 meet(const Vec2& p, const Vec2& through, const LineSegment& wall) {
  if (through == wall.a || through == wall.b) return through;
  if (orientation(wall.a, wall.b, p) == 0) return p;
  return crossing_point(wall, {p, through});
}

}  // namespace

struct VisibilityMap::Data {
  Data(const World& of, const Executor& executor)
      : world(of), map(listed(world, executor)), trace(map), locator(world), node_of(world.vertices().size(), kNone) {
    for (std::uint32_t n = 0; n < map.nodes().size(); ++n) node_of[map.nodes()[n].vertex] = n;
  }

  static SightMap listed(const World& world, const Executor& executor) {
    SightMap map(world, executor);
    map.list_left_edges();
    return map;
  }

  [[nodiscard]] std::vector<std::uint32_t> triangles_at(const Vec2& p) const {
    std::vector<std::uint32_t> triangles;
    trace.triangles_at(p, triangles);
    return triangles;
  }

  // Segments of one point are lines of sight as well unless it lies inside a region.
  [[nodiscard]] bool is_visible(const LineSegment& segment) const {
    if (locator.containing(segment.a) != kNone) return false;
    if (segment.a == segment.b) return true;
    if (std::vector<std::uint32_t> triangles = triangles_at(segment.a); !triangles.empty())
      return is_reached(segment.a, segment.b, triangles);
    if (locator.containing(segment.b) != kNone) return false;
    if (std::vector<std::uint32_t> triangles = triangles_at(segment.b); !triangles.empty())
      return is_reached(segment.b, segment.a, triangles);
    for (VertexId e = 0; e < world.edges().size(); ++e)
      if (blocks(world, e, segment)) return false;
    return true;
  }

  [[nodiscard]] bool is_reached(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles) const {
    const Kind kind = trace.trace(p, q, triangles, false).kind;
    return (kind == Kind::kReached || kind == Kind::kFrame) && (map.is_whole() || !map.is_blocked_by_broken({p, q}));
  }

  static void require_range(const char* what, const Vec2& p) {
    if (!is_in_range(p))
      throw std::invalid_argument(std::string(what) + ": " + shortest_text(p) + ", coordinates must be 0 or from " +
                                  shortest_text(kMinMagnitude) + " to " + shortest_text(kMaxMagnitude) +
                                  " in magnitude");
  }

  void require_near(const char* what, const Vec2& p) const {
    if (!map.is_whole())
      throw std::domain_error(std::string(what) + ": edges of " + std::to_string(map.broken_count()) +
                              " regions of the world cross, or touch themselves within");
    if (!world.has_bounds() && !world.box().empty() && !Box{map.sites().front(), map.sites().back()}.contains(p))
      throw std::domain_error(std::string(what) + ": " + shortest_text(p) + " is further from the map than its size");
  }

  // The edges of the triangles at p that are seen from there, counter-clockwise from +x.
  [[nodiscard]] std::vector<View> views_from(const Vec2& p, std::span<const std::uint32_t> triangles) const {
    std::vector<View> views;
    for (const std::uint32_t t : triangles)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t right = trace.corner(t, k), left = trace.corner(t, (k + 1) % 3);
        if (orientation(map.sites()[right], map.sites()[left], p) > 0)
          views.push_back({right, left, trace.door_out(t, k), right, left});
      }
    std::sort(views.begin(), views.end(), [&](const View& a, const View& b) {
      return precedes_about(p, map.sites()[a.right], map.sites()[b.right]);
    });
    return views;
  }

  // Follows a view to the walls: on_site for each site inside of it, on_wall for each view of a wall, from right to
  // left.
  template <class OnSite, class OnWall>
  void look(const Vec2& p, const View& view, const OnSite& on_site, const OnWall& on_wall) const {
    std::vector<View> stack{view};
    while (!stack.empty()) {
      const View v = stack.back();
      stack.pop_back();
      if (v.door == kNone) {
        on_wall(v);
        continue;
      }
      const SightMap::Door& triangle = map.doors()[v.door];
      const int low = orientation(p, map.sites()[v.low], triangle.apex);
      const int high = orientation(p, map.sites()[v.high], triangle.apex);
      const bool inside = low > 0 && high < 0;
      if (inside) on_site(triangle.site);
      if (high < 0) stack.push_back({triangle.site, v.left, triangle.left, inside ? triangle.site : v.low, v.high});
      if (low > 0) stack.push_back({v.right, triangle.site, triangle.right, v.low, inside ? triangle.site : v.high});
    }
  }

  [[nodiscard]] LineSegment wall_of(std::uint32_t right, std::uint32_t left) const {
    return {map.sites()[right], map.sites()[left]};
  }

  // Along edges that run straight away from p, to the first site with a node.
  void append_along_edges(const Vec2& p, std::span<const std::uint32_t> triangles,
                          std::vector<std::uint32_t>& sites) const {
    std::vector<std::uint32_t> starts;
    if (const std::uint32_t site = trace.site_at(p, triangles); site != kNone) {
      for (const PlanarMap::Edge& edge : map.edges_from(site))
        if (!map.is_covered(edge)) starts.push_back(edge.high);
      for (const std::uint32_t e : map.edges_to(site))
        if (!map.is_covered(map.edge(e))) starts.push_back(map.edge(e).low);
    } else {
      for (const std::uint32_t t : triangles)
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t a = trace.corner(t, k), b = trace.corner(t, (k + 1) % 3);
          if (orientation(map.sites()[a], map.sites()[b], p) == 0) starts.insert(starts.end(), {a, b});
        }
    }
    for (const std::uint32_t site : starts) append_straight_on(p, site, sites);
  }

  // The first site with a node from a site on, along edges that lead straight away from p.
  void append_straight_on(const Vec2& p, std::uint32_t site, std::vector<std::uint32_t>& sites) const {
    while (site != kNone && map.first_node_at(site) == kNone) site = trace.next_along_edge(p, site);
    if (site != kNone) sites.push_back(site);
  }

  // The convex vertices that may be tangent and seen: all that are, and some others.
  [[nodiscard]] std::vector<VertexId> candidates_from(const Vec2& p) const {
    const std::vector<std::uint32_t> triangles = triangles_at(p);
    if (triangles.empty()) return {world.convex_vertices().begin(), world.convex_vertices().end()};
    std::vector<std::uint32_t> sites;
    for (const View& view : views_from(p, triangles)) {
      sites.insert(sites.end(), {view.right, view.left});
      look(
          p, view, [&](std::uint32_t site) { sites.push_back(site); }, [](const View&) {});
    }
    append_along_edges(p, triangles, sites);
    // From within a piece that was left out, an edge goes on behind the end of it.
    if (!map.is_whole())
      for (std::size_t i = 0, seen = sites.size(); i < seen; ++i) append_straight_on(p, sites[i], sites);
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    std::vector<VertexId> found;
    const std::span<const SightMap::Node> nodes = map.nodes();
    for (const std::uint32_t site : sites)
      for (std::uint32_t n = map.first_node_at(site); n != kNone; n = nodes[n].sibling)
        found.push_back(nodes[n].vertex);
    return found;
  }

  World world;
  SightMap map;
  SightTrace trace;
  RegionLocator locator;
  std::vector<std::uint32_t> node_of;  // by vertex
};

VisibilityMap::VisibilityMap(const World& world, const Executor& executor)
    : data_(std::make_unique<const Data>(world, executor)) {}
VisibilityMap::~VisibilityMap() = default;
VisibilityMap::VisibilityMap(VisibilityMap&&) noexcept = default;
VisibilityMap& VisibilityMap::operator=(VisibilityMap&&) noexcept = default;

bool VisibilityMap::visible(const LineSegment& segment) const {
  Data::require_range("line of sight", segment.a);
  Data::require_range("line of sight", segment.b);
  return data_->is_visible(segment);
}

std::optional<VisibilityMap::RayHit> VisibilityMap::first_hit(const Vec2& from, const Vec2& towards) const {
  const Data& d = *data_;
  Data::require_range("first hit", from);
  Data::require_range("first hit", towards);
  if (from == towards) throw std::invalid_argument("first hit: a ray needs two different points");
  d.require_near("first hit", from);
  if (d.world.vertices().empty()) return std::nullopt;
  const std::vector<std::uint32_t> triangles = d.triangles_at(from);
  const std::optional<End> found = triangles.empty() ? d.trace.trace_along_edges(from, towards, true)
                                                     : d.trace.trace(from, towards, triangles, true);
  if (!found) return RayHit{from, {from, from}};
  const End& end = *found;
  if (end.kind == Kind::kFrame) return std::nullopt;
  const LineSegment wall = d.wall_of(end.right, end.left);
  if (end.kind == Kind::kCorner) return RayHit{wall.a, wall};
  return RayHit{meet(from, towards, wall), wall};
}

std::vector<VertexId> VisibilityMap::tangents_from(VertexId vertex) const {
  if (vertex >= data_->node_of.size())
    throw std::out_of_range("tangents: vertex " + std::to_string(vertex) + ", the world has " +
                            std::to_string(data_->node_of.size()));
  return tangent_neighbours(data_->map, data_->node_of[vertex]);
}

std::vector<VertexId> VisibilityMap::tangents_from(const Vec2& point) const {
  Data::require_range("tangents", point);
  const Data& d = *data_;
  if (d.locator.containing(point) != kNone) return {};
  std::vector<VertexId> found = d.candidates_from(point);
  std::erase_if(found, [&](VertexId v) {
    return !is_tangent(d.world, v, point) || !d.is_visible({d.world.vertex(v), point});
  });
  // Of those in one direction the nearest, or all that are at its place.
  const auto place = [&](VertexId v) -> const Vec2& { return d.world.vertex(v); };
  const auto around = std::partition(found.begin(), found.end(), [&](VertexId v) { return place(v) == point; });
  std::sort(around, found.end(), [&](VertexId v, VertexId w) {
    if (precedes_about(point, place(v), place(w))) return true;
    return !precedes_about(point, place(w), place(v)) && on_open_segment(place(v), {point, place(w)});
  });
  const Vec2* nearest = &point;
  const auto is_behind = [&](VertexId v) {
    if (on_open_segment(*nearest, {point, place(v)})) return true;
    nearest = &place(v);
    return false;
  };
  found.erase(std::remove_if(around, found.end(), is_behind), found.end());
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<VisibilityMap::SeenWall> VisibilityMap::visibility_polygon(const Vec2& point) const {
  const Data& d = *data_;
  Data::require_range("visibility polygon", point);
  d.require_near("visibility polygon", point);
  std::vector<SeenWall> walls;
  for (const View& view : d.views_from(point, d.triangles_at(point)))
    d.look(
        point, view, [](std::uint32_t) {},
        [&](const View& seen) {
          const LineSegment wall = d.wall_of(seen.right, seen.left);
          const Vec2 &low = d.map.sites()[seen.low], &high = d.map.sites()[seen.high];
          walls.push_back({wall, meet(point, low, wall), meet(point, high, wall), low, high,
                           d.trace.is_frame(seen.right) && d.trace.is_frame(seen.left)});
        });
  return walls;
}

}  // namespace arcway
