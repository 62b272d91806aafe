#include "accel/graphs/changed_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "accel/graphs/near_pairs.h"
#include "core/geometry/near_boxes.h"
#include "core/roadmap/slot_cache.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// Largest number of vertices that see the changed places, summed up: at most that, and by the square root of the number
// of graph vertices. A change, and a row that is not as before, take time by this number, new rows by that of vertices.
// Where another obstacle moves each time, that is after 50 obstacles among 10,000 vertices. With half as many, changes
// would take a fifth longer in all: each takes less, but new rows come twice as often.
constexpr double kMostSeen = 32768.0, kMostSeenByRoot = 200.0;

// Ascending, each vertex once.
void sort_once(std::vector<VertexId>& vertices) {
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

bool is_same(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }

// The box of an obstacle that was removed or added, and who sees it.
struct Place {
  explicit Place(const Box& the_box)
      : box(the_box), center(0.5 * (box.min + box.max)), radius(0.5 * (box.max - box.min).norm()) {
    radius +=
        1e-9 * radius + 1e-12 * box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();  // no less by rounding
  }

  Box box;
  Vec2 center;  // of a disc around the box
  double radius;
  std::vector<VertexId> viewers;  // vertices of the world before all changes, ascending: see TangentNeighbors
  std::vector<Vec2> viewers_at;   // their positions, which are not looked up in a large map
};
// Those of removed obstacles come first.
struct Places {
  [[nodiscard]] std::span<const std::shared_ptr<const Place>> left_by_obstacles() const {
    return std::span(all).first(removed);
  }

  std::vector<std::shared_ptr<const Place>> all;
  std::size_t removed = 0;
};

// Whether some line from a point may meet both places. False only if none does.
bool may_see_along_line(const Vec2& from, const Place& one, const Place& other) {
  if (&one == &other) return true;
  const Vec2 to_one = one.center - from, to_other = other.center - from;
  const double near = to_one.norm(), far = to_other.norm();
  // Up to 30 degrees of a disc to each side of its center, sines of angles are no less than that of their sum.
  if (near <= 2.0 * one.radius || far <= 2.0 * other.radius) return true;
  return to_one.dot(to_other) > 0.0 &&
         std::abs(cross(to_one, to_other)) <= (1.0 + 1e-9) * (one.radius * far + other.radius * near);
}

// The boxes of obstacles that only one of two worlds has, those of the first world first.
std::vector<Box> boxes_of(const World& before, const World& after, const VertexMap& map) {
  std::vector<Box> boxes;
  for (const World::VertexRange& range : map.removed()) boxes.push_back(before.box_of(before.obstacle_of(range.first)));
  for (const World::VertexRange& range : map.added()) boxes.push_back(after.box_of(after.obstacle_of(range.first)));
  return boxes;
}

// Graph vertices that lie in one of some boxes, ascending.
std::vector<VertexId> vertices_in(const World& world, std::span<const Box> boxes) {
  std::vector<VertexId> found;
  if (boxes.empty()) return found;
  const NearBoxes near(boxes);
  for (const ObstacleId o : world.regions_meeting(boxes)) {
    const auto [first, last] = world.vertices_of(o);
    for (VertexId v = first; v < last; ++v)
      if (world.is_graph_vertex(v) && near.may_meet(Box{world.vertex(v), world.vertex(v)})) found.push_back(v);
  }
  sort_once(found);
  return found;
}

// Places with those who see them; nothing if that is not known, or if these are many.
// @param known  some that were found before.
std::optional<Places> find_places(const LazyRows& rows, std::span<const Box> boxes, std::size_t removed,
                                  const Places& known) {
  const auto vertices = static_cast<double>(rows.world().convex_vertices().size());
  const double most = std::min(kMostSeen, kMostSeenByRoot * std::sqrt(vertices));
  Places places{{}, removed};
  std::size_t seen = 0;
  for (const Box& box : boxes) {
    const auto same = std::ranges::find_if(known.all, [&](const auto& place) { return is_same(place->box, box); });
    if (same != known.all.end()) {
      places.all.push_back(*same);
    } else {
      std::optional<std::vector<VertexId>> viewers = rows.neighbors().viewers_of({&box, 1});
      if (!viewers) return std::nullopt;
      auto place = std::make_shared<Place>(box);
      place->viewers = *std::move(viewers);
      sort_once(place->viewers);
      for (const VertexId v : place->viewers) place->viewers_at.push_back(rows.world().vertex(v));
      places.all.push_back(std::move(place));
    }
    seen += places.all.back()->viewers.size();
    if (static_cast<double>(seen) > most) return std::nullopt;
  }
  return places;
}

// Adds graph vertices that may see a place of some before or after a step, in the worlds of which obstacles have left
// other places. A line of sight that is new since all changes meets a place left by an obstacle first. Its vertex sees
// that place in the world before all changes.
struct Onlookers {
  void add(const Place& seen, std::span<const Place* const> behind) {
    for (std::size_t i = 0; i < seen.viewers.size(); ++i) {
      const Vec2& from = seen.viewers_at[i];
      if (std::ranges::none_of(behind, [&](const Place* q) { return may_see_along_line(from, seen, *q); })) continue;
      const VertexId v = map.after(seen.viewers[i]);
      if (v != kNone && after.is_graph_vertex(v)) found.push_back(v);
    }
  }

  const World& after;
  const VertexMap& map;
  std::vector<VertexId> found;
};

class ChangedRows final : public VisibilityRows, public std::enable_shared_from_this<ChangedRows> {
 public:
  // Many parameters because each is a part of it.
  ChangedRows(std::shared_ptr<const LazyRows> base, const World& world, VertexMap map, Places places,
              std::shared_ptr<const VisibilityQuery> visibility)
      : base_(std::move(base)),
        world_(world),
        map_(std::move(map)),
        places_(std::move(places)),
        boxes_(boxes_in(places_)),
        near_(boxes_),
        inside_(vertices_in(world_, boxes_)),
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

  /// Graph vertices that see a place or lie in one, ascending.
  [[nodiscard]] std::vector<VertexId> onlookers() const {
    Onlookers onlookers{world_, map_, inside_};
    for (const auto& place : places_.all) onlookers.add(*place, std::array{place.get()});
    sort_once(onlookers.found);
    return std::move(onlookers.found);
  }

 private:
  static std::vector<Box> boxes_in(const Places& places) {
    std::vector<Box> boxes;
    for (const auto& place : places.all) boxes.push_back(place->box);
    return boxes;
  }
  [[nodiscard]] std::vector<VertexId> find(VertexId vertex) const;
  [[nodiscard]] std::vector<const Place*> seen_by(VertexId vertex) const;
  [[nodiscard]] std::vector<VertexId> behind(VertexId vertex, std::span<const Place* const> seen) const;

  std::shared_ptr<const LazyRows> base_;
  World world_;
  VertexMap map_;
  Places places_;
  std::vector<Box> boxes_;  // of these
  NearBoxes near_;
  std::vector<VertexId> inside_;
  std::shared_ptr<const VisibilityQuery> visibility_;
  SlotCache<std::vector<VertexId>> rows_;
};

// The places that a graph vertex sees in the world before the changes. What lies in one sees it.
std::vector<const Place*> ChangedRows::seen_by(VertexId vertex) const {
  std::vector<const Place*> seen;
  const VertexId before = map_.before(vertex);
  for (const auto& place : places_.all)
    if (place->box.contains(world_.vertex(vertex)) ||
        (before != kNone && std::ranges::binary_search(place->viewers, before)))
      seen.push_back(place.get());
  return seen;
}

// The graph vertices that may be joined to another one by an edge that was not there before the changes. Such an edge
// meets a place left by an obstacle, or ends in a place.
// @param seen  by that vertex.
std::vector<VertexId> ChangedRows::behind(VertexId vertex, std::span<const Place* const> seen) const {
  const Vec2& here = world_.vertex(vertex);
  std::vector<VertexId> found;
  for (std::size_t p = 0; p < places_.all.size(); ++p) {
    const Place& place = *places_.all[p];
    if (p >= places_.removed && !place.box.contains(here)) continue;
    if (std::ranges::none_of(seen, [&](const Place* s) { return may_see_along_line(here, *s, place); })) continue;
    for (std::size_t i = 0; i < place.viewers.size(); ++i) {
      const Vec2 along = place.viewers_at[i] - here;
      if (std::abs(cross(along, place.center - here)) > (1.0 + 1e-9) * place.radius * along.norm()) continue;
      const VertexId v = map_.after(place.viewers[i]);
      if (v != kNone && v != vertex && world_.is_graph_vertex(v)) found.push_back(v);
    }
  }
  for (const VertexId v : inside_)
    if (v != vertex) found.push_back(v);
  return found;
}

// Edges that meet no place are as before.
std::vector<VertexId> ChangedRows::find(VertexId vertex) const {
  std::vector<VertexId> row;
  if (!world_.is_graph_vertex(vertex)) return row;
  const Vec2& here = world_.vertex(vertex);
  const std::vector<const Place*> seen = seen_by(vertex);
  if (const VertexId before = map_.before(vertex); before != kNone)
    for (const VertexId v : base_->of(before))
      if (const VertexId now = map_.after(v); now != kNone && world_.is_graph_vertex(now)) row.push_back(now);
  if (seen.empty()) return row;
  std::vector<VertexId> doubtful = behind(vertex, seen), candidates;
  std::erase_if(row, [&](VertexId v) {
    const bool meets = near_.may_meet(here, world_.vertex(v));
    if (meets) doubtful.push_back(v);
    return meets;
  });
  sort_once(doubtful);
  std::vector<LineSegment> segments;
  for (const VertexId v : doubtful) {
    const Vec2& there = world_.vertex(v);
    if (!near_.may_meet(here, there) || !is_tangent(world_, vertex, there) || !is_tangent(world_, v, here)) continue;
    candidates.push_back(v);
    segments.push_back({here, there});
  }
  std::vector<std::uint8_t> visible(segments.size());
  visibility_->visible(segments, visible);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (visible[i]) row.push_back(candidates[i]);
  keep_nearest(world_, vertex, row);
  return row;
}

bool touch_themselves(const World& before, const World& after) {
  return !before.self_contacts().empty() || !after.self_contacts().empty();
}

// See change_rows.
std::shared_ptr<const ChangedRows> rows_after(const std::shared_ptr<const LazyRows>& base, const World& after,
                                              const VertexMap& map, const Places& known,
                                              std::shared_ptr<const VisibilityQuery> visibility) {
  if (touch_themselves(base->world(), after)) return nullptr;
  std::optional<Places> places = find_places(*base, boxes_of(base->world(), after, map), map.removed().size(), known);
  if (!places) return nullptr;
  return std::make_shared<const ChangedRows>(base, after, map, *std::move(places), std::move(visibility));
}

std::optional<VisibilityRows::Changed> ChangedRows::changed(const World& after, const WorldChange& change,
                                                            std::shared_ptr<const VisibilityQuery> visibility) const {
  const VertexMap next(change), map = map_.then(next);
  const std::shared_ptr<const ChangedRows> rows = rows_after(base_, after, map, places_, std::move(visibility));
  if (!rows) return rows_made_anew(world_, after, next);
  std::vector<Box> boxes = change.removed_boxes;
  boxes.insert(boxes.end(), change.added_boxes.begin(), change.added_boxes.end());
  std::vector<const Place*> changed;
  for (const Places* places : {&places_, &rows->places_})
    for (const auto& place : places->all)
      if (std::ranges::any_of(boxes, [&](const Box& box) { return is_same(box, place->box); }))
        changed.push_back(place.get());
  // An obstacle that is gone again is no place, but may have covered vertices.
  Onlookers onlookers{after, map, vertices_in(after, boxes)};
  onlookers.found.insert(onlookers.found.end(), rows->inside_.begin(), rows->inside_.end());
  for (const Place* place : changed) onlookers.add(*place, std::array{place});
  const auto left_after = rows->places_.left_by_obstacles();
  for (const auto& place : left_after) onlookers.add(*place, changed);
  for (const auto& place : places_.left_by_obstacles())
    if (std::ranges::find(left_after, place) == left_after.end()) onlookers.add(*place, changed);
  sort_once(onlookers.found);
  return Changed{rows, std::move(onlookers.found)};
}

}  // namespace

std::optional<VisibilityRows::Changed> change_rows(const std::shared_ptr<const LazyRows>& base, const World& after,
                                                   const VertexMap& map,
                                                   std::shared_ptr<const VisibilityQuery> visibility) {
  const std::shared_ptr<const ChangedRows> rows = rows_after(base, after, map, {}, std::move(visibility));
  if (!rows) return std::nullopt;
  return VisibilityRows::Changed{rows, rows->onlookers()};
}

std::optional<VisibilityRows::Changed> rows_made_anew(const World& before, const World& after, const VertexMap& map) {
  if (touch_themselves(before, after)) return std::nullopt;
  auto rows = std::make_shared<const LazyRows>(after, SerialExecutor());
  // Who sees another vertex now, or no longer, sees a place in both worlds: up to there nothing differs.
  const std::vector<Box> boxes = boxes_of(before, after, map);
  std::vector<VertexId> differ;
  if (const auto viewers = rows->neighbors().viewers_of(boxes)) {
    differ = vertices_in(after, boxes);
    for (const VertexId v : *viewers)
      if (after.is_graph_vertex(v)) differ.push_back(v);
    sort_once(differ);
  } else {
    differ.assign(after.convex_vertices().begin(), after.convex_vertices().end());
  }
  return VisibilityRows::Changed{std::move(rows), std::move(differ)};
}

}  // namespace arcway::internal
