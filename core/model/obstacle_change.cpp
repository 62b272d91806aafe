#include "core/model/obstacle_change.h"

#include <map>
#include <utility>

#include "core/model/world_checks.h"

namespace arcway {

using namespace internal;
namespace {

std::vector<std::size_t> ring_sizes(const Polygon& polygon) {
  std::vector<std::size_t> sizes{polygon.outer.size()};
  for (const Ring& hole : polygon.holes) sizes.push_back(hole.size());
  return sizes;
}

std::vector<std::size_t> ring_sizes(const World& world, ObstacleId o) {
  std::vector<std::size_t> sizes;
  const std::span<const VertexId> starts = world.ring_starts(o);
  for (std::size_t r = 0; r < starts.size(); ++r)
    sizes.push_back((r + 1 < starts.size() ? starts[r + 1] : world.vertices_of(o).last) - starts[r]);
  return sizes;
}

}  // namespace

World::Data::Change::Change(const World& world, std::span<const ObstacleId> the_removed,
                            std::span<const Polygon> the_added)
    : removed(the_removed), added(the_added) {
  std::map<std::vector<std::size_t>, std::vector<ObstacleId>> places;  // of removed obstacles, descending
  if (!added.empty())
    for (auto o = removed.rbegin(); o != removed.rend(); ++o)
      if (world.keep_out_of(*o) == kNone) places[ring_sizes(world, *o)].push_back(*o);
  std::map<ObstacleId, std::size_t> in_place;
  std::vector<std::size_t> behind;
  for (std::size_t i = 0; i < added.size(); ++i) {
    const auto place = places.empty() ? places.end() : places.find(ring_sizes(added[i]));
    if (place == places.end() || place->second.empty()) {
      behind.push_back(i);
    } else {
      in_place.emplace(place->second.back(), i);
      place->second.pop_back();
    }
  }
  ObstacleId begin = 0;
  for (const ObstacleId o : removed) {
    add_run(o - begin, begin, kStay);
    if (const auto at = in_place.find(o); at != in_place.end()) add_run(1, o, at->second);
    begin = o + 1;
  }
  add_run(static_cast<ObstacleId>(world.obstacle_count()) - begin, begin, kStay);
  first_behind = obstacles;
  for (const std::size_t i : behind) add_run(1, kNone, i);

  std::vector<VertexRange> gone, come;
  for (const ObstacleId o : removed) gone.push_back(world.vertices_of(o));
  VertexId end = 0;
  for (const Run& run : runs) {
    if (run.added == kStay)
      end += world.vertices_of(run.before + (run.end - run.begin) - 1).last - world.vertices_of(run.before).first;
    for (std::size_t i = run.added; run.added != kStay && i < run.added + (run.end - run.begin); ++i) {
      const VertexId first = end;
      end += static_cast<VertexId>(vertex_count_of(added.subspan(i, 1)));
      come.push_back({first, end});
    }
  }
  map = VertexMap(std::move(gone), std::move(come));
}

void World::Data::Change::add_run(ObstacleId count, ObstacleId before, std::size_t first_added) {
  if (count == 0) return;
  const bool follows = !runs.empty() && before == kNone && runs.back().before == kNone &&
                       runs.back().added + (runs.back().end - runs.back().begin) == first_added;
  if (!follows) runs.push_back({obstacles, obstacles, before, first_added});
  runs.back().end = obstacles += count;
}

}  // namespace arcway
