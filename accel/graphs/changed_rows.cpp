#include "accel/graphs/changed_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "accel/base/shared_pages.h"
#include "accel/expansion/change_visibility.h"
#include "accel/expansion/occupants.h"
#include "accel/expansion/opened_triangulation.h"
#include "accel/graphs/near_pairs.h"
#include "core/geometry/near_boxes.h"
#include "core/roadmap/slot_cache.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// Largest share of the vertices that obstacles removed and added since the triangulation was made may have; some are
// always allowed. Lines of sight pass all of these, so that more and more vertices seem to see each other. The mean of
// 300 changes among 10,004 vertices, each of another obstacle, is 0.7 ms with an eighth, 0.9 with a quarter and 1.9
// with half of them.
constexpr double kMostChanged = 0.25;
constexpr std::size_t kChangedAtLeast = 64;

// Ascending, each vertex once.
void sort_once(std::vector<VertexId>& vertices) {
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

// Adds the graph vertices of a world among some vertices.
void add_graph_vertices(const World& world, const World::VertexRange& range, std::vector<VertexId>& found) {
  for (VertexId v = range.first; v < range.last; ++v)
    if (world.is_graph_vertex(v)) found.push_back(v);
}

// Whether a region has vertices in a place that would be graph vertices if they were not covered.
bool has_covered_vertices(const World& world, ObstacleId region, const Box& place) {
  const auto [first, last] = world.vertices_of(region);
  for (VertexId v = first; v < last; ++v)
    if (place.contains(world.vertex(v)) && world.is_convex(v) && !world.is_graph_vertex(v)) return true;
  return false;
}

// How a world differs from one that was triangulated. Copies share what they have in common.
class Difference {
 public:
  explicit Difference(const LazyRows& base) : map({}, {}), triangles(base.neighbors().opened()) {}

  // Goes on to the world after a change. Returns false if the triangulation does not serve for it.
  bool follow(const LazyRows& base, const World& after, const WorldChange& change) {
    const VertexMap next(change);
    for (const World::VertexRange& range : change.removed_vertices)
      if (const VertexId first = map.before(range.first); first != kNone && !open(base.world(), first)) return false;
    map = map.then(next);
    occupants.follow(next);
    for (const World::VertexRange& range : change.added_vertices)
      occupants.add(triangles, range, after.box_of(after.obstacle_of(range.first)));
    const std::size_t vertices = base.world().vertices().size();
    const double most = std::max(kMostChanged * static_cast<double>(vertices), static_cast<double>(kChangedAtLeast));
    return static_cast<double>(triangles.opened_vertices() + occupants.vertex_count()) <= most;
  }

  // The graph vertices of the present world that are marked, ascending: those that were triangulated, and occupants.
  [[nodiscard]] std::vector<VertexId> seen_by(const ChangeVisibility& viewers, const World& world) const {
    std::vector<VertexId> seen;
    for (const std::uint32_t n : viewers.viewers().all()) {
      const VertexId v = map.after(triangles.triangulation().nodes()[n].vertex);
      if (v != kNone && world.is_graph_vertex(v)) seen.push_back(v);
    }
    for (const std::uint32_t number : viewers.occupants())
      add_graph_vertices(world, occupants.with_number(number).vertices, seen);
    sort_once(seen);
    return seen;
  }

  VertexMap map;                  // from the world that was triangulated
  OpenedTriangulation triangles;  // removed obstacles are opened
  Occupants occupants;            // added obstacles, and some that have vertices which removed ones covered
  MarkedNumbers touched;          // nodes whose rows may be others than in that world

 private:
  bool open(const World& world, VertexId first) {
    const ObstacleId removed = world.obstacle_of(first);
    if (!triangles.open(world, removed)) return false;
    const Box& place = world.box_of(removed);
    occupants.spread(triangles, place);
    for (const ObstacleId o : world.regions_meeting({&place, 1})) {
      if (o == removed || !has_covered_vertices(world, o, place)) continue;
      const auto [v, end] = world.vertices_of(o);
      if (const VertexId now = map.after(v); now != kNone) occupants.add(triangles, {now, now + (end - v)}, place);
    }
    return true;
  }
};

class ChangedRows final : public VisibilityRows, public std::enable_shared_from_this<ChangedRows> {
 public:
  ChangedRows(std::shared_ptr<const LazyRows> base, const World& world, Difference difference,
              std::shared_ptr<const VisibilityQuery> visibility)
      : base_(std::move(base)),
        world_(world),
        difference_(std::move(difference)),
        visibility_(std::move(visibility)),
        rows_(world.vertices().size()) {}

  [[nodiscard]] std::span<const VertexId> of(VertexId vertex) const override {
    return rows_.get(vertex, [&] { return std::make_unique<const std::vector<VertexId>>(find(vertex)); });
  }

  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& executor) const override {
    return lazy_pairs_within(world_, *this, length, wanted, executor);
  }

  [[nodiscard]] std::optional<Changed> changed(const World& after, const WorldChange& change,
                                               std::shared_ptr<const VisibilityQuery> visibility) const override;

 private:
  [[nodiscard]] bool is_touched(VertexId before) const;
  [[nodiscard]] std::vector<VertexId> find(VertexId vertex) const;
  void find_anew(VertexId vertex, std::vector<VertexId>& row) const;

  std::shared_ptr<const LazyRows> base_;
  World world_;
  Difference difference_;
  std::shared_ptr<const VisibilityQuery> visibility_;
  SlotCache<std::vector<VertexId>> rows_;
};

// @param before  in the world that was triangulated; kNone: there is no such vertex.
bool ChangedRows::is_touched(VertexId before) const {
  const std::uint32_t node = before == kNone ? kNone : base_->neighbors().node_of(before);
  return node == kNone || difference_.touched.has(node);
}

std::vector<VertexId> ChangedRows::find(VertexId vertex) const {
  std::vector<VertexId> row;
  if (!world_.is_graph_vertex(vertex)) return row;
  const VertexId before = difference_.map.before(vertex);
  if (before != kNone)
    for (const VertexId v : base_->of(before))
      if (const VertexId now = difference_.map.after(v); now != kNone && world_.is_graph_vertex(now))
        row.push_back(now);
  if (is_touched(before)) find_anew(vertex, row);
  return row;
}

// Edges that were there before the changes remain unless they meet an added obstacle. Others lead to what may be seen
// where removed obstacles hide nothing.
// @param row  edges that were there before the changes, ascending; then those that are there now.
void ChangedRows::find_anew(VertexId vertex, std::vector<VertexId>& row) const {
  const Vec2& here = world_.vertex(vertex);
  ChangeVisibility viewers(difference_.triangles, &difference_.occupants);
  viewers.mark_neighbors(world_, vertex);
  const std::vector<VertexId> seen = difference_.seen_by(viewers, world_);
  std::vector<Box> boxes;
  for (const std::uint32_t number : viewers.occupants()) boxes.push_back(difference_.occupants.with_number(number).box);
  const NearBoxes near(boxes);
  std::vector<VertexId> candidates;
  std::vector<LineSegment> segments;
  const auto ask = [&](VertexId v) {
    candidates.push_back(v);
    segments.push_back({here, world_.vertex(v)});
  };
  for (const VertexId v : seen) {
    const Vec2& there = world_.vertex(v);
    if (v != vertex && !std::ranges::binary_search(row, v) && is_tangent(world_, vertex, there) &&
        is_tangent(world_, v, here))
      ask(v);
  }
  std::erase_if(row, [&](VertexId v) {
    const bool may_be_blocked = near.may_meet(here, world_.vertex(v));
    if (may_be_blocked) ask(v);
    return may_be_blocked;
  });
  std::vector<std::uint8_t> visible(segments.size());
  visibility_->visible(segments, visible);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (visible[i]) row.push_back(candidates[i]);
  keep_nearest(world_, vertex, row);
}

bool touch_themselves(const World& before, const World& after) {
  return !before.self_contacts().empty() || !after.self_contacts().empty();
}

// All places that a change leaves or takes.
std::vector<Box> boxes_of(const WorldChange& change) {
  std::vector<Box> boxes = change.removed_boxes;
  boxes.insert(boxes.end(), change.added_boxes.begin(), change.added_boxes.end());
  return boxes;
}

// New lazy rows. Who sees another vertex now, or no longer, sees a place in both worlds: up to there nothing differs.
VisibilityRows::Changed rows_made_anew(const World& after, const WorldChange& change) {
  auto rows = std::make_shared<const LazyRows>(after, SerialExecutor());
  const std::vector<Box> boxes = boxes_of(change);
  std::vector<VertexId> differ;
  if (rows->neighbors().cover(boxes)) {
    const OpenedTriangulation triangles = rows->neighbors().opened();
    ChangeVisibility viewers(triangles);
    viewers.mark_viewers(boxes);
    for (const std::uint32_t n : viewers.viewers().all()) differ.push_back(triangles.triangulation().nodes()[n].vertex);
    sort_once(differ);
  } else {
    differ.assign(after.convex_vertices().begin(), after.convex_vertices().end());
  }
  return {std::move(rows), std::move(differ)};
}

// Rows of a world after a change.
// @param before  how the world before the change differs from that of the base.
std::optional<VisibilityRows::Changed> rows_after(const std::shared_ptr<const LazyRows>& base, Difference difference,
                                                  const World& after, const WorldChange& change,
                                                  std::shared_ptr<const VisibilityQuery> visibility) {
  const std::vector<Box> boxes = boxes_of(change);
  if (!base->neighbors().cover(boxes) || !difference.follow(*base, after, change)) return rows_made_anew(after, change);
  ChangeVisibility viewers(difference.triangles, &difference.occupants);
  viewers.mark_viewers(boxes);
  difference.touched.mark_all_of(viewers.viewers());
  std::vector<VertexId> differ = difference.seen_by(viewers, after);
  auto rows = std::make_shared<const ChangedRows>(base, after, std::move(difference), std::move(visibility));
  return VisibilityRows::Changed{std::move(rows), std::move(differ)};
}

std::optional<VisibilityRows::Changed> ChangedRows::changed(const World& after, const WorldChange& change,
                                                            std::shared_ptr<const VisibilityQuery> visibility) const {
  if (touch_themselves(world_, after)) return std::nullopt;
  return rows_after(base_, difference_, after, change, std::move(visibility));
}

}  // namespace

std::optional<VisibilityRows::Changed> change_rows(const std::shared_ptr<const LazyRows>& base, const World& after,
                                                   const WorldChange& change,
                                                   std::shared_ptr<const VisibilityQuery> visibility) {
  if (touch_themselves(base->world(), after)) return std::nullopt;
  return rows_after(base, Difference(*base), after, change, std::move(visibility));
}

}  // namespace arcway::internal
