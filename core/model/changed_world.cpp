#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/model/vertex_map.h"
#include "core/model/world_checks.h"
#include "core/model/world_data.h"

namespace arcway {

using namespace internal;
namespace {

// Share of the obstacles that may differ, beside some of any world, where a change takes the arrays of a world that is
// gone, or the index of regions of a world before. It looks again which vertices near these obstacles are covered, and
// at each added one whenever regions are looked up.
constexpr std::size_t kMostOthersOf = 8;
constexpr std::size_t kOthersOfAny = 64;

bool are_few(std::size_t obstacles, std::size_t of) { return obstacles * kMostOthersOf <= of + kOthersOfAny; }

}  // namespace

std::shared_ptr<const World::Data> World::Data::shared(std::unique_ptr<Data> data) {
  return {data.release(), [](Data* gone) {
            const std::shared_ptr<Origin> receiver = std::move(gone->origin);
            receiver->spare.give(std::unique_ptr<Data>(gone));
          }};
}

void World::Data::begin_history() {
  history = WorldHistory(next_stamp(), region_starts[obstacle_count()]);
  origin = std::make_shared<Origin>();
}

void World::Data::index_obstacles() const {
  std::call_once(origin->indexed, [this] {
    HugeVector<VertexId> all;
    for (VertexId v = 0; v < vertices.size(); ++v)
      if (convex[v]) all.push_back(v);
    origin->convex = std::make_shared<const HugeVector<VertexId>>(std::move(all));
    if (obstacle_count() == 0) return;
    origin->obstacles = BoxTree(std::span(boxes).first(obstacle_count()));
    origin->first_vertex.assign(region_starts.begin(), region_starts.begin() + obstacle_count());
  });
}

std::vector<ObstacleId> World::Data::regions_meeting(std::span<const Box> places) const {
  index_obstacles();
  std::vector<ObstacleId> found;
  const auto [first_added, end_added] = history.map().added();
  const ObstacleId first_other =
      first_added < end_added ? obstacle_of[first_added] : static_cast<ObstacleId>(obstacle_count());
  for (const Box& place : places) {
    origin->obstacles.visit_overlaps(place, [&](std::uint32_t o) {
      const VertexId now = history.map().after(origin->first_vertex[o]);
      if (now != kNone) found.push_back(obstacle_of[now]);
      return true;
    });
    for (ObstacleId o = first_other; o < boxes.size(); ++o)
      if (boxes[o].overlaps(place)) found.push_back(o);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::size_t World::Data::count_common(const Data& other, std::span<const ObstacleId> removed,
                                      const VertexMap& left) const {
  const VertexId vertices_in_common = left.common_with(history.map());
  std::size_t common =
      static_cast<std::size_t>(std::ranges::upper_bound(region_starts, vertices_in_common) - region_starts.begin() - 1);
  bool differs = false;
  visit_kept(removed, other.obstacle_count(), common, [&](ObstacleId begin, ObstacleId end) {
    if (differs) return;
    const auto range = std::span(other.stamps).subspan(begin, end - begin);
    const auto mine = std::span(stamps).first(obstacle_count()).subspan(common);
    const auto at = std::ranges::mismatch(range, mine).in1;
    common += static_cast<std::size_t>(at - range.begin());
    differs = at != range.end();
  });
  return common;
}

std::pair<ObstacleId, ObstacleId> World::Data::added_regions() const {
  const auto [first, last] = history.map().added();
  if (first == last) return {obstacle_count(), obstacle_count()};
  return {obstacle_of[first], obstacle_of[last - 1] + 1};
}

void World::Data::append_others(const Data& other, std::vector<Box>& places) const {
  for (const VertexRange& range : other.history.map().removed())
    if (const VertexId v = history.map().after(range.first); v != kNone) places.push_back(boxes[obstacle_of[v]]);
  const auto [theirs, their_end] = other.added_regions();
  std::vector<std::uint64_t> known(other.stamps.begin() + theirs, other.stamps.begin() + their_end);
  std::ranges::sort(known);
  const auto [mine, my_end] = added_regions();
  for (ObstacleId o = mine; o < my_end; ++o)
    if (!std::ranges::binary_search(known, stamps[o])) places.push_back(boxes[o]);
}

void World::Data::truncate(std::size_t regions) {
  const VertexId count = region_starts[regions];
  for (HugeVector<VertexId>* array : {&next, &previous, &obstacle_of}) array->resize(count);
  vertices.resize(count);
  edges.resize(count);
  convex.resize(count);
  covered.resize(count);
  region_starts.resize(regions + 1);
  region_rings.resize(regions + 1);
  ring_starts.resize(region_rings.back());
  boxes.resize(regions);
  stamps.resize(regions);
  has_bounds = false;
}

std::unique_ptr<World::Data> World::Data::begin_change(const Data& old, std::span<const ObstacleId> removed,
                                                       const VertexMap& left, std::vector<Box>& places) {
  std::unique_ptr<Data> data = old.origin->spare.take();
  const bool is_of_use = data && data->contacts.empty() && old.contacts.empty();
  if (is_of_use) {
    data->append_others(old, places);
    old.append_others(*data, places);
  }
  if (!is_of_use || !are_few(places.size(), old.obstacle_count())) {
    places.clear();
    if (!data) data = std::make_unique<Data>();
    data->contacts.clear();
    data->contacts_by_vertex.clear();
    data->truncate(0);
    data->history = WorldHistory();
  } else {
    data->truncate(data->count_common(old, removed, left));
  }
  data->origin = old.origin;
  return data;
}

Box World::Data::box_without(std::span<const ObstacleId> removed) const {
  const auto is_inside = [&](ObstacleId o) {
    return (boxes[o].min.array() > box.min.array()).all() && (boxes[o].max.array() < box.max.array()).all();
  };
  if (std::ranges::all_of(removed, is_inside)) return box;
  Box left;
  visit_kept(removed, static_cast<ObstacleId>(boxes.size()), 0, [&](ObstacleId begin, ObstacleId end) {
    for (ObstacleId o = begin; o < end; ++o) left.extend(boxes[o]);
  });
  return left;
}

void World::Data::copy_regions(const Data& from, ObstacleId begin, ObstacleId end) {
  const VertexId first = from.region_starts[begin], last = from.region_starts[end];
  const auto to = static_cast<VertexId>(vertices.size());
  const auto region = static_cast<ObstacleId>(boxes.size());
  const auto moved = [&](VertexId v) { return v - first + to; };
  const auto append = [&](const auto& source, auto& target) {
    target.insert(target.end(), source.begin() + first, source.begin() + last);
  };
  const auto append_moved = [&](const auto& source, auto& target, const auto& move) {
    target.resize(vertices.size());
    std::transform(source.begin() + first, source.begin() + last, target.begin() + to, move);
  };
  append(from.vertices, vertices);
  append(from.edges, edges);
  append(from.convex, convex);
  append(from.covered, covered);
  append_moved(from.next, next, moved);
  append_moved(from.previous, previous, moved);
  append_moved(from.obstacle_of, obstacle_of, [&](ObstacleId o) { return o - begin + region; });
  for (ObstacleId o = begin; o < end; ++o) {
    for (std::size_t r = from.region_rings[o]; r < from.region_rings[o + 1]; ++r)
      ring_starts.push_back(moved(from.ring_starts[r]));
    region_starts.push_back(moved(from.region_starts[o + 1]));
    region_rings.push_back(ring_starts.size());
    boxes.push_back(from.boxes[o]);
    stamps.push_back(from.stamps[o]);
    box.extend(from.boxes[o]);
  }
  for (auto c = std::ranges::lower_bound(from.contacts, first, {}, &SelfContact::edge);
       c != from.contacts.end() && c->edge < last; ++c)
    contacts.push_back({moved(c->edge), moved(c->vertex)});
}

void World::Data::take_keys(const Data& from, std::span<const ObstacleId> removed, std::size_t known) {
  const ObstacleId before = from.obstacle_count();
  next_key.reset();
  keys.resize(from.next_key || !removed.empty() ? std::min(keys.size(), known) : 0);
  if (!from.next_key && removed.empty()) return;
  keys.reserve(obstacle_count());
  visit_kept(removed, before, keys.size(), [&](ObstacleId begin, ObstacleId end) {
    for (ObstacleId o = begin; o < end; ++o) keys.push_back(from.key_of(o));
  });
  ObstacleKey unused = from.next_key.value_or(before);
  while (keys.size() < obstacle_count()) keys.push_back(unused++);
  next_key = unused;
}

std::vector<VertexId> World::Data::update_covered(const std::vector<Box>& places, const Data& old,
                                                  const VertexMap& change) {
  if (places.empty()) return {};
  const BoxTree tree(places);
  std::vector<ObstacleId> regions = regions_meeting(places);
  std::vector<VertexId> doubtful;
  for (const ObstacleId o : regions)
    for (VertexId v = region_starts[o]; v < region_starts[o + 1]; ++v)
      if (!tree.visit_overlaps(Box{vertices[v], vertices[v]}, [](std::uint32_t) { return false; }))
        doubtful.push_back(v);
  // What is outside of the bounds is covered by them, wherever their box is.
  if (has_bounds && (regions.empty() || !is_bounds(regions.back()))) regions.push_back(obstacle_count());
  mark_covered(doubtful, regions);
  std::erase_if(doubtful, [&](VertexId v) {
    const VertexId before = change.before(v);
    return before == kNone || covered[v] == old.covered[before];
  });
  return doubtful;
}

void World::Data::follow(const Data& old, const VertexMap& change, const std::vector<Box>& places) {
  const WorldHistory of_arrays = std::move(history);
  history = WorldHistory(old.history, change, {}, origin->convex);
  const std::vector<VertexId> flipped = update_covered(places, old, change);
  history = WorldHistory(old.history, change, flipped, origin->convex);
  list_convex_vertices(history.common_with(of_arrays), history.flipped_from(of_arrays));
  const auto [first, last] = added_regions();
  if (!are_few(last - first, obstacle_count())) begin_history();
}

World World::with_obstacles_changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const {
  const Data& old = *data_;
  const auto obstacles = static_cast<ObstacleId>(obstacle_count());
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (removed[i] >= obstacles)
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + ": the world has " +
                                  std::to_string(obstacles));
    if (i > 0 && removed[i] <= removed[i - 1])
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + " follows " +
                                  std::to_string(removed[i - 1]) + ": they must ascend");
  }
  old.index_obstacles();
  std::vector<VertexRange> gone;
  for (const ObstacleId o : removed) gone.push_back(vertices_of(o));
  const auto change_with = [&](VertexRange new_ones) { return VertexMap(gone, new_ones); };
  VertexId left = old.region_starts[obstacles];  // vertices of obstacles
  for (const VertexRange& range : gone) left -= range.last - range.first;
  std::vector<Box> places;
  std::unique_ptr<Data> data =
      Data::begin_change(old, removed, old.history.map().then(change_with({left, left})), places);
  data->reserve(old.vertices.size() + vertex_count_of(added));
  const std::size_t common = data->boxes.size();
  for (const ObstacleId o : removed) places.push_back(old.boxes[o]);
  Data::visit_kept(removed, obstacles, common,
                   [&](ObstacleId begin, ObstacleId end) { data->copy_regions(old, begin, end); });
  const auto first_added = static_cast<VertexId>(data->vertices.size());
  data->box = old.box_without(removed);
  Data::Touches touches;
  for (const Polygon& polygon : added) {
    const auto id = static_cast<ObstacleId>(data->boxes.size());
    data->add_region(polygon, require_region(polygon, id, false), false, touches);
    places.push_back(data->boxes.back());
  }
  const auto end_added = static_cast<VertexId>(data->vertices.size());
  data->connect(first_added, std::move(touches));
  data->covered.resize(end_added);
  data->derive_edges();
  if (old.has_bounds) {
    data->has_bounds = true;
    data->copy_regions(old, obstacles, obstacles + 1);
    data->sort_contacts();
  }
  require_vertex_count(data->vertices.size(), static_cast<ObstacleId>(data->boxes.size()));
  data->take_keys(old, removed, common);
  data->follow(old, change_with({first_added, end_added}), places);
  World world = *this;
  world.data_ = Data::shared(std::move(data));
  return world;
}

}  // namespace arcway
