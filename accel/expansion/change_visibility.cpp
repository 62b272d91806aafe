#include "accel/expansion/change_visibility.h"

#include <algorithm>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

// Number of triangles to see, as a multiple of the half-edges, beyond which all nodes are marked. Of 466
// changes among 150 obstacles that cover 15 % of the map, 336 see fewer, 259 of them less than a quarter.
constexpr std::size_t kMostSteps = 4;

}  // namespace

ChangeVisibility::Source::Source(const Box& the_place, std::uint32_t the_number)
    : place(the_place), corners(place.corners()), corner_count(place.min == place.max ? 1 : 4), number(the_number) {}

void ChangeVisibility::mark_viewers(std::span<const Box> places) {
  std::vector<Source> sources;
  for (const Box& place : places) sources.emplace_back(place, static_cast<std::uint32_t>(sources.size()));
  mark_from(sources);
}

void ChangeVisibility::mark_neighbors(const World& world, VertexId vertex) {
  Source source(Box{world.vertex(vertex), world.vertex(vertex)}, 0);
  source.beside = {world.vertex(world.previous(vertex)), world.vertex(world.next(vertex))};
  source.is_vertex = true;
  mark_from({&source, 1});
}

void ChangeVisibility::mark_from(std::span<const Source> sources) {
  std::vector<Box> places;
  for (const Source& source : sources) places.push_back(source.place);
  const BoxTree tree(places);
  const auto meets_any = [&](const Box& box) { return !tree.visit_overlaps(box, [](std::uint32_t) { return false; }); };
  known_.clear();
  opened_.visit_near(places, [&](std::uint32_t first) {
    if (gives_up_) return;
    tree.visit_overlaps(opened_.box_of(first), [&](std::uint32_t i) {
      if (opened_.may_meet(first, places[i])) expand_out_of(first, sources[i]);
      return !gives_up_;
    });
  });
  if (gives_up_) return;
  opened_.visit_boundary_near(places, [&](const PlanarMap::Edge& boundary, const Box& box) {
    if (meets_any(box)) follow_boundary(boundary);
  });
}

std::vector<std::uint32_t> ChangeVisibility::occupants() const {
  std::vector<std::uint32_t> seen = seen_occupants_;
  std::ranges::sort(seen);
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  return seen;
}

// Expands from a place out of a triangle that meets it.
void ChangeVisibility::expand_out_of(std::uint32_t first, const Source& source) {
  const OpenedTriangulation::Corners corners = opened_.corners_of(first);
  for (const std::uint32_t corner : corners) mark(triangulation_.first_node_at(corner));
  if (occupants_) see(occupants_->in_triangle(first));
  for (std::uint32_t j = 0; j < 3; ++j)
    if (const std::uint32_t half_edge = opened_.beyond(first + j); half_edge != kNone)
      expand(source, {half_edge, corners[j], corners[(j + 1) % 3]});
}

// Cones from a wide place overlap: where vertices that hide nothing split them, and as those out of its sides pass the
// same gap with the same bounds. There each is followed once.
void ChangeVisibility::expand(const Source& source, const Range& range) {
  stack_.push_back(range);
  while (!stack_.empty()) {
    auto [half_edge, low, high] = stack_.back();
    stack_.pop_back();
    while (half_edge != kNone && may_enter(source, half_edge)) {
      if (++steps_ > kMostSteps * triangulation_.half_edges().size()) {  // marking all nodes is cheaper from here on
        give_up();
        return;
      }
      if (occupants_) see(occupants_->in_triangle(half_edge - half_edge % 3));
      const FreeSpaceTriangulation::HalfEdge& triangle = opened_.half_edge(half_edge);
      if (all_pass(source, low, triangle.point, 1)) {
        half_edge = opened_.left_of(half_edge);
        continue;
      }
      if (all_pass(source, high, triangle.point, -1)) {
        half_edge = opened_.right_of(half_edge);
        continue;
      }
      mark(triangle.node);
      const Range right{opened_.right_of(half_edge), low, triangle.point};
      const Range left{opened_.left_of(half_edge), triangle.point, high};
      if (is_new(source, right)) stack_.push_back(right);
      if (!is_new(source, left)) break;
      half_edge = left.half_edge;
      low = left.low;
    }
  }
}

// Cones out of a point do not overlap.
bool ChangeVisibility::is_new(const Source& source, const Range& range) {
  if (range.half_edge == kNone) return false;
  return source.corner_count == 1 || known_.insert({source.number, range.half_edge, range.low, range.high}).second;
}

void ChangeVisibility::give_up() {
  for (std::uint32_t n = 0; n < triangulation_.nodes().size(); ++n) seen_.mark(n);
  if (occupants_) seen_occupants_ = occupants_->numbers();
  stack_.clear();
  gives_up_ = true;
}

// Marks nodes on lines of sight that run along boundary edges all the way: from an edge at a place straight on, both
// ways.
void ChangeVisibility::follow_boundary(const PlanarMap::Edge& boundary) {
  follow<Sense::kRight>(boundary);
  follow<Sense::kLeft>(boundary);
}

// The first node on the way may be one of a removed obstacle.
template <Sense kSense>
void ChangeVisibility::follow(const PlanarMap::Edge& boundary) {
  for (const PlanarMap::Edge* edge = &boundary; edge; edge = straight_on<kSense>(triangulation_, *edge)) {
    if (occupants_) see(occupants_->at_point(edge->low));
    mark(triangulation_.first_node_at(end_of<kSense>(*edge)));
  }
}

void ChangeVisibility::mark(std::uint32_t first_node) {
  for (std::uint32_t n = first_node; n != kNone; n = triangulation_.nodes()[n].sibling) seen_.mark(n);
}

void ChangeVisibility::see(std::span<const SharedTable::Item> occupants) {
  for (const SharedTable::Item& item : occupants) seen_occupants_.push_back(item.number);
}

bool ChangeVisibility::is_opposite(const Source& source, const Vec2& point) {
  return orientation(source.beside[0], source.corners[0], point) < 0 &&
         orientation(source.corners[0], source.beside[1], point) < 0;
}

bool ChangeVisibility::may_enter(const Source& source, std::uint32_t half_edge) const {
  const std::uint32_t first = half_edge - half_edge % 3;
  if (opened_.may_meet(first, source.place)) return false;
  const std::array<Vec2, 3> corners = opened_.positions_of(first);
  const Vec2 &left = corners[half_edge % 3], &right = corners[(half_edge % 3 + 1) % 3];
  if (source.is_vertex) return !is_opposite(source, left) || !is_opposite(source, right);
  return std::any_of(source.corners.begin(), source.corners.begin() + source.corner_count,
                     [&](const Vec2& corner) { return orientation(left, right, corner) <= 0; });
}

// Whether a point lies to the right (side 1) or to the left (-1) of the rays from all of a source through another
// point. Then no ray that passes that point on its other side reaches it.
bool ChangeVisibility::all_pass(const Source& source, std::uint32_t through, std::uint32_t point, int side) const {
  return std::all_of(source.corners.begin(), source.corners.begin() + source.corner_count, [&](const Vec2& corner) {
    return orientation(corner, triangulation_.points()[through], triangulation_.points()[point]) * side < 0;
  });
}

}  // namespace arcway::internal
