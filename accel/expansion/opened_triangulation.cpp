#include "accel/expansion/opened_triangulation.h"

#include <algorithm>
#include <optional>

#include "accel/triangulation/free_space_sweep.h"
#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// Whether a box lies strictly to the right of the line from a to b.
bool lies_right_of(const Vec2& a, const Vec2& b, const Box& box) {
  return std::ranges::all_of(box.corners(), [&](const Vec2& corner) { return orientation(a, b, corner) < 0; });
}

}  // namespace

OpenedTriangulation::OpenedTriangulation(const FreeSpaceTriangulation& triangulation, const TriangleBlocks* blocks)
    : triangulation_(triangulation),
      blocks_(blocks),
      own_count_(triangulation.half_edges().size()),
      next_half_edge_(static_cast<std::uint32_t>(own_count_)) {}

Box OpenedTriangulation::box_of(std::uint32_t first) const {
  Box box;
  for (const Vec2& corner : positions_of(first)) box.extend(corner);
  return box;
}

bool OpenedTriangulation::may_meet(std::uint32_t first, const Box& box) const {
  if (!box_of(first).overlaps(box)) return false;
  const std::array<Vec2, 3> corners = positions_of(first);
  for (std::size_t j = 0; j < 3; ++j)
    if (lies_right_of(corners[j], corners[(j + 1) % 3], box)) return false;
  return true;
}

bool OpenedTriangulation::overlaps_any(const Box& box, std::span<const Box> boxes) {
  return std::ranges::any_of(boxes, [&](const Box& other) { return box.overlaps(other); });
}

const OpenedTriangulation::Side* OpenedTriangulation::find(const std::vector<Side>& sides, std::uint32_t from,
                                                           std::uint32_t to) {
  const auto side = std::ranges::lower_bound(sides, Side{from, to, 0});
  return side != sides.end() && side->from == from && side->to == to ? &*side : nullptr;
}

const OpenedTriangulation::HalfEdge& OpenedTriangulation::inside_half_edge(std::uint32_t h) const {
  const Opened& opened = *(std::ranges::upper_bound(opened_, h, {}, &Opened::first_half_edge) - 1);
  return opened.inside->half_edges[h - opened.first_half_edge];
}

// An edge of the obstacle is one of the map, or a chain of such that lie on it. Those that the map has dropped, because
// they cross others, are missing.
OpenedTriangulation::Pieces OpenedTriangulation::pieces_of(const World& world, ObstacleId obstacle) const {
  Pieces pieces;
  const auto at = [&](std::uint32_t point) -> const Vec2& { return triangulation_.points()[point]; };
  const auto [first, last] = world.vertices_of(obstacle);
  for (VertexId v = first; v < last; ++v) {
    const std::uint32_t from = triangulation_.point_at(world.vertex(v)),
                        to = triangulation_.point_at(world.vertex(world.next(v)));
    const std::uint32_t low = std::min(from, to), high = std::max(from, to);
    for (std::uint32_t point = low; point < high;) {
      const auto edges = triangulation_.edges_from(point);
      const auto next = std::ranges::find_if(edges, [&](const PlanarMap::Edge& edge) {
        return edge.high == high || (edge.high < high && orientation(at(low), at(high), at(edge.high)) == 0);
      });
      if (next == edges.end()) {  // dropped: go on at the next point on the edge
        do ++point;
        while (point < high && orientation(at(low), at(high), at(point)) != 0);
        continue;
      }
      pieces.emplace_back(from < to ? next->low : next->high, from < to ? next->high : next->low);
      point = next->high;
    }
  }
  return pieces;
}

// Sides of the triangulation's own triangles at the boundary, on either side of some pieces.
std::vector<OpenedTriangulation::Side> OpenedTriangulation::sides_around(const Pieces& pieces, const Box& box) const {
  std::vector<std::uint32_t> points;
  for (const auto& [from, to] : pieces) points.insert(points.end(), {from, to});
  std::ranges::sort(points);
  const auto is_of_these = [&](std::uint32_t point) { return std::ranges::binary_search(points, point); };
  std::vector<Side> sides;
  visit_near({&box, 1}, [&](std::uint32_t first) {
    if (first >= own_count_ || !box_of(first).overlaps(box)) return;
    const Corners corners = corners_of(first);
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t from = corners[j], to = corners[(j + 1) % 3];
      if (half_edge(Triangulation::next(first + j)).left == kNone && is_of_these(from) && is_of_these(to))
        sides.push_back({from, to, first + j});
    }
  });
  std::ranges::sort(sides);
  return sides;
}

// The triangles between closed rings of pieces.
std::shared_ptr<const OpenedTriangulation::Inside> OpenedTriangulation::inside_of(const Pieces& pieces,
                                                                                  std::uint32_t first_half_edge) const {
  std::vector<std::uint32_t> points;  // of the triangulation, ascending
  for (const auto& [from, to] : pieces) points.push_back(from);
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> positions;
  positions.reserve(points.size());
  for (const std::uint32_t point : points) positions.push_back(triangulation_.points()[point]);
  const auto place_of = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, point) - points.begin());
  };
  Pieces edges;
  for (const auto& [from, to] : pieces) edges.emplace_back(place_of(from), place_of(to));
  const std::optional<FreeSpace> space = triangulate_free_space(make_map_inside(positions, edges), SerialExecutor());
  if (!space) return nullptr;
  const Triangulation& t = space->triangulation;
  auto inside = std::make_shared<Inside>();
  const auto corner = [&](std::uint32_t h) { return points[t.corners[h] - 2]; };  // two corners of the frame precede
  for (std::uint32_t h = 0; h < t.corners.size(); ++h) {
    const auto number = [&](std::uint32_t twin) { return twin == kNone ? kNone : first_half_edge + twin; };
    const std::uint32_t next = Triangulation::next(h), previous = Triangulation::previous(h), apex = corner(previous);
    inside->half_edges.push_back({triangulation_.points()[apex], number(t.twins[previous]), number(t.twins[next]), apex,
                                  triangulation_.first_node_at(apex)});
    if (t.twins[h] == kNone) inside->rim.push_back({corner(h), corner(next), first_half_edge + h});
  }
  std::ranges::sort(inside->rim);
  return inside;
}

void OpenedTriangulation::join(std::uint32_t side, std::uint32_t other) {
  joints_.add(side, other);
  joints_.add(other, side);
}

// Joins the triangles on both sides of pieces that are boundaries without an inside.
bool OpenedTriangulation::join_both_sides(const Pieces& pieces, const std::vector<Side>& around) {
  for (const auto& [from, to] : pieces) {
    const Side *const left = find(around, from, to), *const right = find(around, to, from);
    if (!left || !right) continue;
    const std::uint32_t other = joined_to(left->number);
    if (other == right->number) continue;  // it was an edge of another obstacle, too
    if (other != kNone || joined_to(right->number) != kNone) return false;
    join(left->number, right->number);
  }
  return true;
}

// Joins an inside to the triangles around it: those of the triangulation, and insides of neighbors.
bool OpenedTriangulation::join_rim(const Opened& opened, const std::vector<Side>& around) {
  std::vector<const Inside*> neighbors;
  for (const Opened& other : opened_)
    if (other.box.overlaps(opened.box)) neighbors.push_back(other.inside.get());
  for (const Side& side : opened.inside->rim) {
    const Side* other = find(around, side.to, side.from);
    for (auto neighbor = neighbors.begin(); !other && neighbor != neighbors.end(); ++neighbor)
      other = find((*neighbor)->rim, side.to, side.from);
    if (!other) continue;  // an obstacle is there
    if (joined_to(other->number) != kNone) return false;
    join(side.number, other->number);
  }
  return true;
}

// Whether no side of an inside at which an obstacle is lies in another opened obstacle.
bool OpenedTriangulation::is_apart(const World& world, const Opened& one, const Opened& other) const {
  const auto lies_in_other = [&](std::uint32_t point) {
    return world.locate(triangulation_.points()[point], other.obstacle) != PointLocation::kOutside;
  };
  return std::ranges::none_of(one.inside->rim, [&](const Side& side) {
    return joined_to(side.number) == kNone && lies_in_other(side.from) && lies_in_other(side.to);
  });
}

// The edges of an obstacle some of which the map has dropped are boundaries without an inside.
bool OpenedTriangulation::open(const World& world, ObstacleId obstacle) {
  Opened opened{obstacle, world.box_of(obstacle), next_half_edge_, std::make_shared<const Inside>()};
  const Pieces pieces = pieces_of(world, obstacle);
  const std::vector<Side> around = sides_around(pieces, opened.box);
  if (triangulation_.is_valid(obstacle)) {
    opened.inside = inside_of(pieces, opened.first_half_edge);
    if (!opened.inside || !join_rim(opened, around)) return false;
    for (const Opened& other : opened_)
      if (other.box.overlaps(opened.box) && !(is_apart(world, opened, other) && is_apart(world, other, opened)))
        return false;
  } else if (!join_both_sides(pieces, around)) {
    return false;
  }
  const auto [first, last] = world.vertices_of(obstacle);
  opened_vertices_ += last - first;
  next_half_edge_ += static_cast<std::uint32_t>(opened.inside->half_edges.size());
  opened_.push_back(std::move(opened));
  return true;
}

}  // namespace arcway::internal
