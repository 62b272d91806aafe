#include "arcway/accel/visibility_map.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "accel/expansion/bucket_index.h"
#include "accel/expansion/contact_edges.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/line_of_sight_trace.h"
#include "accel/expansion/tangent_cone_expansion.h"
#include "accel/expansion/triangular_expansion.h"
#include "accel/location/region_locator.h"
#include "core/collision/blocking.h"
#include "core/geometry/crossing_point.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"
#include "core/model/pose_text.h"

namespace arcway {

using namespace internal;

namespace {

using End = LineOfSightTrace::End;
using Kind = LineOfSightTrace::End::Kind;

// Where the line from p through `through` meets an edge, rounded.
Vec2 meet(const Vec2& p, const Vec2& through, const LineSegment& edge) {
  if (through == edge.a || through == edge.b) return through;
  if (orientation(edge.a, edge.b, p) == 0) return p;
  return crossing_point(edge, {p, through});
}

}  // namespace

struct VisibilityMap::Data {
  Data(const World& of, const Executor& executor)
      : world(of),
        triangulation(listed(world, executor)),
        trace(triangulation),
        locator(world),
        expansion(triangulation, trace),
        node_of(world.vertices().size(), kNone) {
    for (std::uint32_t n = 0; n < triangulation.nodes().size(); ++n) node_of[triangulation.nodes()[n].vertex] = n;
    const auto point_count = static_cast<std::uint32_t>(triangulation.points().size());
    std::vector<std::uint32_t> points;
    for (VertexId v = 0; v < world.vertices().size(); ++v)
      points.push_back(world.is_covered(v) ? point_count : triangulation.point_at(world.vertex(v)));
    vertices = BucketIndex(std::move(points), point_count);
    through_contacts = both_ways(edges_through_contacts(world, triangulation));
  }

  static FreeSpaceTriangulation listed(const World& world, const Executor& executor) {
    FreeSpaceTriangulation triangulation(world, executor);
    triangulation.list_left_edges();
    return triangulation;
  }

  [[nodiscard]] std::vector<std::uint32_t> triangles_at(const Vec2& p) const {
    std::vector<std::uint32_t> triangles;
    trace.triangles_at(p, triangles);
    return triangles;
  }

  // A segment of one point is a line of sight unless the point lies inside a region.
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
    return (kind == Kind::kReached || kind == Kind::kFrame) &&
           (triangulation.is_valid() || !triangulation.is_blocked_by_invalid({p, q}));
  }

  static void require_range(const char* what, const Vec2& p) {
    if (!is_in_range(p))
      throw std::invalid_argument(std::string(what) + ": " + shortest_text(p) + ", coordinates must be 0 or from " +
                                  shortest_text(kMinMagnitude) + " to " + shortest_text(kMaxMagnitude) +
                                  " in magnitude");
  }

  void require_vertex(const char* what, VertexId vertex) const {
    if (vertex >= node_of.size())
      throw std::out_of_range(std::string(what) + ": vertex " + std::to_string(vertex) + ", the world has " +
                              std::to_string(node_of.size()));
  }

  void require_near(const char* what, const Vec2& p) const {
    if (!triangulation.is_valid())
      throw std::domain_error(std::string(what) + ": edges of " + std::to_string(triangulation.invalid_count()) +
                              " regions of the world cross");
    if (!world.has_bounds() && !world.box().empty() &&
        !Box{triangulation.points().front(), triangulation.points().back()}.contains(p))
      throw std::domain_error(std::string(what) + ": " + shortest_text(p) + " is further from the map than its size");
  }

  [[nodiscard]] LineSegment edge_of(std::uint32_t right, std::uint32_t left) const {
    return {triangulation.points()[right], triangulation.points()[left]};
  }

  // Vertices seen from a point of some triangles, ascending.
  void find_vertices_seen(const Vec2& p, std::uint32_t own, TriangularExpansion::Scratch& scratch,
                          std::vector<VertexId>& found) const {
    expansion.find_points(p, own, scratch);
    found.clear();
    for (const std::uint32_t point : scratch.points)
      if (triangulation.is_valid() || !triangulation.is_blocked_by_invalid({p, triangulation.points()[point]}))
        for (const VertexId v : vertices.of(point)) found.push_back(v);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  void find_vertices_seen(std::uint32_t point, TriangularExpansion::Scratch& scratch,
                          std::vector<VertexId>& found) const {
    scratch.triangles.clear();
    for (const std::uint32_t corner : trace.corners_at(point)) scratch.triangles.push_back(corner - corner % 3);
    find_vertices_seen(triangulation.points()[point], point, scratch, found);
  }

  [[nodiscard]] std::vector<VertexId> vertices_seen(VertexId vertex) const {
    std::vector<VertexId> found;
    TriangularExpansion::Scratch scratch;
    if (!world.is_covered(vertex)) find_vertices_seen(triangulation.point_at(world.vertex(vertex)), scratch, found);
    return found;
  }

  [[nodiscard]] std::vector<VertexId> vertices_seen(const Vec2& p) const {
    std::vector<VertexId> found;
    if (locator.containing(p) != kNone) return found;
    TriangularExpansion::Scratch scratch;
    trace.triangles_at(p, scratch.triangles);
    if (!scratch.triangles.empty()) {
      find_vertices_seen(p, trace.point_at(p, scratch.triangles), scratch, found);
    } else {
      for (VertexId v = 0; v < world.vertices().size(); ++v)
        if (!world.is_covered(v) && world.vertex(v) != p && is_visible({world.vertex(v), p})) found.push_back(v);
    }
    return found;
  }

  // Points with vertices, ordered so that neighbors in the plane follow each other.
  [[nodiscard]] std::vector<std::uint32_t> points_by_tile() const {
    std::vector<std::uint32_t> points;
    std::vector<std::uint8_t> listed(triangulation.points().size(), 0);
    const auto list = [&](std::uint32_t point) {
      if (listed[point] == 0 && !vertices.of(point).empty()) points.push_back(point);
      listed[point] = 1;
    };
    for (const FreeSpaceTriangulation::HalfEdge& half_edge : triangulation.half_edges()) list(half_edge.point);
    for (std::uint32_t point = 0; point < listed.size(); ++point) list(point);  // points that no triangle meets
    return points;
  }

  World world;
  FreeSpaceTriangulation triangulation;
  LineOfSightTrace trace;
  RegionLocator locator;
  TriangularExpansion expansion;
  std::vector<std::uint32_t> node_of;  // by vertex
  BucketIndex vertices;                // vertices that are not covered, by point
  EdgeList through_contacts;           // of the reduced graph
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
  const LineSegment edge = d.edge_of(end.right, end.left);
  if (end.kind == Kind::kCorner) return RayHit{edge.a, edge};
  return RayHit{meet(from, towards, edge), edge};
}

std::vector<VertexId> VisibilityMap::visible_from(VertexId vertex) const {
  data_->require_vertex("visible vertices", vertex);
  return data_->vertices_seen(vertex);
}

std::vector<VertexId> VisibilityMap::visible_from(const Vec2& point) const {
  Data::require_range("visible vertices", point);
  return data_->vertices_seen(point);
}

std::vector<VertexId> VisibilityMap::tangents_from(VertexId vertex) const {
  data_->require_vertex("tangents", vertex);
  std::vector<VertexId> found = tangent_neighbors(data_->triangulation, data_->node_of[vertex]);
  add_missing(data_->through_contacts, vertex, found);
  return found;
}

std::vector<VertexId> VisibilityMap::tangents_from(const Vec2& point) const {
  Data::require_range("tangents", point);
  const Data& d = *data_;
  std::vector<VertexId> found = d.vertices_seen(point);
  keep_tangents(d.world, point, found);
  return found;
}

std::vector<VisibilityMap::VisibleEdge> VisibilityMap::visibility_polygon(const Vec2& point) const {
  const Data& d = *data_;
  Data::require_range("visibility polygon", point);
  d.require_near("visibility polygon", point);
  std::vector<VisibleEdge> edges;
  TriangularExpansion::Scratch scratch;
  d.trace.triangles_at(point, scratch.triangles);
  d.expansion.find_boundary(point, scratch);
  for (const TriangularExpansion::View& seen : scratch.boundary) {
    const LineSegment edge = d.edge_of(seen.right, seen.left);
    const Vec2 &low = d.triangulation.points()[seen.low], &high = d.triangulation.points()[seen.high];
    edges.push_back({edge, meet(point, low, edge), meet(point, high, edge), low, high,
                     d.trace.is_frame(seen.right) && d.trace.is_frame(seen.left)});
  }
  return edges;
}

VisibilityGraph build_full_visibility_graph_by_expansion(const World& world, const Executor& executor) {
  constexpr std::size_t kPointsPerRange = 64;
  const VisibilityMap::Data triangulation(world, executor);
  const std::vector<std::uint32_t> points = triangulation.points_by_tile();
  std::vector<EdgeList> parts((points.size() + kPointsPerRange - 1) / kPointsPerRange);
  executor.begin_stage("lines of sight");
  executor.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    TriangularExpansion::Scratch scratch;
    std::vector<VertexId> seen;
    for (std::size_t part = begin; part < end; ++part)
      for (std::size_t i = part * kPointsPerRange; i < std::min(points.size(), (part + 1) * kPointsPerRange); ++i) {
        triangulation.find_vertices_seen(points[i], scratch, seen);
        for (const VertexId u : triangulation.vertices.of(points[i]))
          for (const VertexId v : seen)
            if (v > u) parts[part].emplace_back(u, v);
      }
  });
  return graph_of(world.vertices().size(), parts, executor);
}

}  // namespace arcway
