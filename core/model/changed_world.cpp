#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/model/obstacle_change.h"
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

void require_removed(std::span<const ObstacleId> removed, std::size_t obstacles) {
  for (std::size_t i = 0; i < removed.size(); ++i) {
    if (removed[i] >= obstacles)
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + ": the world has " +
                                  std::to_string(obstacles));
    if (i > 0 && removed[i] <= removed[i - 1])
      throw std::invalid_argument("removed obstacle " + std::to_string(removed[i]) + " follows " +
                                  std::to_string(removed[i - 1]) + ": they must ascend");
  }
}

}  // namespace

std::shared_ptr<const World::Data> World::Data::shared(std::unique_ptr<Data> data) {
  return {data.release(), [](Data* gone) {
            const std::shared_ptr<Origin> receiver = std::move(gone->origin);
            receiver->spare.give(std::unique_ptr<Data>(gone));
          }};
}

void World::Data::begin_history() {
  history = WorldHistory(next_stamp(), history);
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
  std::vector<ObstacleId> others;
  for (const VertexRange& added : history.map().added()) others.push_back(obstacle_of[added.first]);
  if (has_bounds) others.push_back(obstacle_count());
  for (const Box& place : places) {
    origin->obstacles.visit_overlaps(place, [&](std::uint32_t o) {
      const VertexId now = history.map().after(origin->first_vertex[o]);
      if (now != kNone) found.push_back(obstacle_of[now]);
      return true;
    });
    for (const ObstacleId o : others)
      if (boxes[o].overlaps(place)) found.push_back(o);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void World::Data::append_others(const Data& other, std::vector<Box>& places) const {
  for (const VertexRange& range : other.history.map().removed())
    if (const VertexId v = history.map().after(range.first); v != kNone) places.push_back(boxes[obstacle_of[v]]);
  std::vector<std::uint64_t> known;
  for (const VertexRange& range : other.history.map().added())
    known.push_back(other.stamps[other.obstacle_of[range.first]]);
  std::ranges::sort(known);
  for (const VertexRange& range : history.map().added())
    if (const ObstacleId o = obstacle_of[range.first]; !std::ranges::binary_search(known, stamps[o]))
      places.push_back(boxes[o]);
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

World::Data World::Data::region_after(const Data& old, const Change& change, ObstacleId o) {
  const Change::Run& run = change.run_of(o);
  Data region;
  if (run.added == Change::kStay) {
    const ObstacleId before = run.before + (o - run.begin);
    region.copy_regions(old, before, before + 1);
  } else {
    region.add_obstacles(change.added.subspan(run.added + (o - run.begin), 1), o);
  }
  return region;
}

void World::Data::overwrite(ObstacleId o, const Data& region) {
  const VertexId first = region_starts[o];
  const auto moved = [&](VertexId v) { return v + first; };
  std::ranges::copy(region.vertices, vertices.begin() + first);
  std::ranges::copy(region.edges, edges.begin() + first);
  std::copy(region.convex.begin(), region.convex.end(), convex.begin() + first);
  std::copy(region.covered.begin(), region.covered.end(), covered.begin() + first);
  std::ranges::transform(region.next, next.begin() + first, moved);
  std::ranges::transform(region.previous, previous.begin() + first, moved);
  boxes[o] = region.boxes[0];
  stamps[o] = region.stamps[0];
}

bool World::Data::has_rings_of(ObstacleId o, const Data& region) const {
  const auto mine = std::span(ring_starts).subspan(region_rings[o], region_rings[o + 1] - region_rings[o]);
  const auto is_same = [&](VertexId at, VertexId other) { return at == region_starts[o] + other; };
  return region_starts[o + 1] - region_starts[o] == region.vertices.size() &&
         std::ranges::equal(mine, region.ring_starts, is_same);
}

void World::Data::overwrite_others(const Data& old, const Change& change) {
  const VertexMap after = old.history.map().then(change.map);
  const VertexId aligned = history.map().aligned_with(after);
  const auto whole = std::ranges::upper_bound(region_starts, aligned) - region_starts.begin() - 1;
  const bool are_as_many = obstacle_count() == change.obstacles && static_cast<std::size_t>(whole) == boxes.size();
  auto same = std::min({static_cast<ObstacleId>(whole), obstacle_count(), change.obstacles});
  ObstacleId first_other = same;
  for (const VertexRange& range : history.map().added_in_either(after)) {
    if (range.first >= region_starts[same]) break;
    const ObstacleId o = obstacle_of[range.first];
    const Change::Run& run = change.run_of(o);
    if (run.added == Change::kStay && stamps[o] == old.stamps[run.before + (o - run.begin)]) continue;
    first_other = std::min(first_other, o);
    const Data region = region_after(old, change, o);
    if (!has_rings_of(o, region) || !region.contacts.empty()) {
      same = o;
      break;
    }
    overwrite(o, region);
  }
  keys.resize(std::min<std::size_t>(keys.size(), first_other));
  if (!are_as_many || same < change.obstacles) truncate(same);
}

std::unique_ptr<World::Data> World::Data::begin_change(const Data& old, const Change& change,
                                                       std::vector<Box>& places) {
  std::unique_ptr<Data> data = old.origin->spare.take();
  const bool is_of_use = data && data->contacts.empty() && old.contacts.empty();
  if (is_of_use) {
    data->append_others(old, places);
    old.append_others(*data, places);
  }
  if (is_of_use && are_few(places.size(), old.obstacle_count())) {
    data->overwrite_others(old, change);
  } else {
    places.clear();
    if (!data) data = std::make_unique<Data>();
    data->contacts.clear();
    data->contacts_by_vertex.clear();
    data->keys.clear();
    data->truncate(0);
    data->history = WorldHistory();
  }
  data->origin = old.origin;
  data->graph_vertices = std::make_unique<GraphVertices>();
  return data;
}

void World::Data::append_rest(const Data& old, const Change& change) {
  const auto same = static_cast<ObstacleId>(boxes.size());
  for (const Change::Run& run : change.runs) {
    const ObstacleId begin = std::max(run.begin, same), skipped = begin - run.begin;
    if (begin >= run.end) continue;
    if (run.added == Change::kStay) {
      copy_regions(old, run.before + skipped, run.before + (run.end - run.begin));
    } else {
      add_obstacles(change.added.subspan(run.added + skipped, run.end - begin), begin);
    }
  }
  if (old.has_bounds && !has_bounds) {
    has_bounds = true;
    copy_regions(old, old.obstacle_count(), old.obstacle_count() + 1);
  }
  sort_contacts();
}

void World::Data::add_obstacles(std::span<const Polygon> polygons, ObstacleId id) {
  const auto first = static_cast<VertexId>(vertices.size());
  Touches touches;
  for (const Polygon& polygon : polygons) add_region(polygon, require_region(polygon, id++, false), false, touches);
  connect(first, std::move(touches));
  covered.resize(vertices.size());
  derive_edges();
}

Box World::Data::box_without(std::span<const ObstacleId> removed) const {
  const auto is_inside = [&](ObstacleId o) {
    return (boxes[o].min.array() > box.min.array()).all() && (boxes[o].max.array() < box.max.array()).all();
  };
  if (std::ranges::all_of(removed, is_inside)) return box;
  Box left;
  for (ObstacleId o = 0; o < boxes.size(); ++o)
    if (!std::ranges::binary_search(removed, o)) left.extend(boxes[o]);
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

void World::Data::take_keys(const Data& from, const Change& change) {
  const bool are_ids = !from.next_key && change.first_behind == from.obstacle_count();
  next_key.reset();
  if (are_ids) keys.clear();
  if (are_ids) return;
  keys.reserve(change.obstacles);
  const ObstacleKey unused = from.next_key.value_or(from.obstacle_count());
  for (const Change::Run& run : change.runs)
    for (auto o = std::max(static_cast<ObstacleId>(keys.size()), run.begin); o < run.end; ++o)
      keys.push_back(run.before == kNone ? unused + (o - change.first_behind)
                                         : from.key_of(run.before + (o - run.begin)));
  next_key = unused + (change.obstacles - change.first_behind);
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
  history = WorldHistory(next_stamp(), old.history, change, origin->convex);
  const std::vector<VertexId> flipped = update_covered(places, old, change);
  history.flip(flipped);
  graph_vertex_count = old.graph_vertex_count - old.count_graph_vertices(change.removed());
  graph_vertex_count += count_graph_vertices(change.added());
  for (const VertexId v : flipped) {
    if (!convex[v] || change.is_added(v)) continue;
    if (covered[v])
      --graph_vertex_count;
    else
      ++graph_vertex_count;
  }
  if (!are_few(history.map().added().size(), obstacle_count())) begin_history();
}

World World::with_obstacles_changed(std::span<const ObstacleId> removed, const std::vector<Polygon>& added) const {
  const Data& old = *data_;
  require_removed(removed, obstacle_count());
  old.index_obstacles();
  const Data::Change change(*this, removed, added);
  std::vector<Box> places;
  std::unique_ptr<Data> data = Data::begin_change(old, change, places);
  data->reserve(old.vertices.size() + vertex_count_of(added));
  data->append_rest(old, change);
  require_vertex_count(data->vertices.size(), static_cast<ObstacleId>(data->boxes.size()));
  data->box = old.box_without(removed);
  for (const ObstacleId o : removed) places.push_back(old.boxes[o]);
  for (const VertexRange& range : change.map.added()) {
    places.push_back(data->boxes[data->obstacle_of[range.first]]);
    data->box.extend(places.back());
  }
  data->take_keys(old, change);
  data->follow(old, change.map, places);
  World world = *this;
  world.data_ = Data::shared(std::move(data));
  return world;
}

}  // namespace arcway
