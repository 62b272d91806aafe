#include "accel/graphs/changed_rows.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "accel/graphs/near_pairs.h"
#include "core/geometry/near_boxes.h"
#include "core/roadmap/slot_cache.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// Largest number of stale vertices. A stale row tests all of them: among 1,000, some 0.1 ms.
constexpr std::size_t kMostStale = 1024;

// Ascending, each vertex once.
void sort_once(std::vector<VertexId>& vertices) {
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

class ChangedRows final : public VisibilityRows, public std::enable_shared_from_this<ChangedRows> {
 public:
  // Many parameters because each is a part of it.
  ChangedRows(std::shared_ptr<const LazyRows> base, const World& world, VertexMap map, std::vector<VertexId> stale,
              std::shared_ptr<const VisibilityQuery> visibility)
      : base_(std::move(base)),
        world_(world),
        map_(std::move(map)),
        stale_(std::move(stale)),
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
                                               std::shared_ptr<const VisibilityQuery> visibility) const override {
    const VertexMap next(change);
    std::optional<Changed> rows = change_rows(base_, after, map_.then(next), std::move(visibility));
    if (!rows) return rows_made_anew(world_, after, next);
    // What was stale before may be as it was in the beginning.
    for (const VertexId v : stale_)
      if (const VertexId now = next.after(v); now != kNone && after.is_graph_vertex(now))
        rows->may_differ.push_back(now);
    sort_once(rows->may_differ);
    return rows;
  }

 private:
  [[nodiscard]] bool is_stale(VertexId v) const { return std::ranges::binary_search(stale_, v); }

  [[nodiscard]] std::vector<VertexId> find(VertexId vertex) const {
    std::vector<VertexId> row;
    if (!world_.is_graph_vertex(vertex)) return row;
    if (const VertexId before = map_.before(vertex); before != kNone)
      for (const VertexId v : base_->of(before))
        if (const VertexId now = map_.after(v); now != kNone && world_.is_graph_vertex(now)) row.push_back(now);
    if (is_stale(vertex)) find_stale(vertex, row);
    return row;
  }

  // Edges to vertices that are not stale are as before.
  void find_stale(VertexId vertex, std::vector<VertexId>& row) const {
    const Vec2& here = world_.vertex(vertex);
    std::erase_if(row, [this](VertexId v) { return is_stale(v); });
    std::vector<VertexId> candidates;
    std::vector<LineSegment> segments;
    for (const VertexId v : stale_) {
      if (!is_tangent(world_, vertex, world_.vertex(v)) || !is_tangent(world_, v, here)) continue;
      candidates.push_back(v);
      segments.push_back({here, world_.vertex(v)});
    }
    std::vector<std::uint8_t> visible(segments.size());
    visibility_->visible(segments, visible);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (visible[i]) row.push_back(candidates[i]);
    keep_nearest(world_, vertex, row);
  }

  std::shared_ptr<const LazyRows> base_;
  World world_;
  VertexMap map_;
  std::vector<VertexId> stale_;  // graph vertices, ascending
  std::shared_ptr<const VisibilityQuery> visibility_;
  SlotCache<std::vector<VertexId>> rows_;
};

// The boxes of obstacles that only one of two worlds has.
std::vector<Box> places_of(const World& before, const World& after, const VertexMap& map) {
  std::vector<Box> places;
  for (const World::VertexRange& range : map.removed())
    places.push_back(before.box_of(before.obstacle_of(range.first)));
  for (VertexId v = map.added().first; v < map.added().last; v = after.vertices_of(after.obstacle_of(v)).last)
    places.push_back(after.box_of(after.obstacle_of(v)));
  return places;
}

// Graph vertices that see one of the places, or lie there; nothing if that is not known.
// @param rows  of the world before the changes, or of the one after them.
// @param now  gives the vertex after the changes for a vertex of that world; kNone if there is none.
template <class Now>
std::optional<std::vector<VertexId>> find_stale(const LazyRows& rows, const World& after, std::span<const Box> places,
                                                const Now& now) {
  std::vector<VertexId> stale;
  if (places.empty()) return stale;
  const auto add = [&](VertexId v) {
    if (v != kNone && after.is_graph_vertex(v)) stale.push_back(v);
  };
  const std::optional<std::vector<VertexId>> viewers = rows.neighbors().viewers_of(places);
  if (!viewers) return std::nullopt;
  for (const VertexId v : *viewers) add(now(v));
  const NearBoxes near(places);
  for (const ObstacleId o : after.regions_meeting(places)) {
    const auto [first, last] = after.vertices_of(o);
    for (VertexId v = first; v < last; ++v)
      if (near.may_meet(Box{after.vertex(v), after.vertex(v)})) add(v);
  }
  sort_once(stale);
  return stale;
}

bool touch_themselves(const World& before, const World& after) {
  return !before.self_contacts().empty() || !after.self_contacts().empty();
}

}  // namespace

std::optional<VisibilityRows::Changed> change_rows(std::shared_ptr<const LazyRows> base, const World& after,
                                                   const VertexMap& map,
                                                   std::shared_ptr<const VisibilityQuery> visibility) {
  const World& before = base->world();
  if (touch_themselves(before, after)) return std::nullopt;
  const std::vector<Box> places = places_of(before, after, map);
  std::optional<std::vector<VertexId>> stale =
      find_stale(*base, after, places, [&](VertexId v) { return map.after(v); });
  if (!stale || stale->size() > kMostStale) return std::nullopt;
  return VisibilityRows::Changed{
      std::make_shared<const ChangedRows>(std::move(base), after, map, *stale, std::move(visibility)), *stale};
}

std::optional<VisibilityRows::Changed> rows_made_anew(const World& before, const World& after, const VertexMap& map) {
  if (touch_themselves(before, after)) return std::nullopt;
  auto rows = std::make_shared<const LazyRows>(after, SerialExecutor());
  // Who sees another vertex now, or no longer, sees a place in both worlds: up to there nothing differs.
  std::optional<std::vector<VertexId>> stale =
      find_stale(*rows, after, places_of(before, after, map), [](VertexId v) { return v; });
  if (!stale) stale.emplace(after.convex_vertices().begin(), after.convex_vertices().end());
  return VisibilityRows::Changed{std::move(rows), *std::move(stale)};
}

}  // namespace arcway::internal
