#include "arcway/world_change.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/model/pose_text.h"
#include "core/model/vertex_map.h"
#include "core/model/world_history.h"

namespace arcway {

using namespace internal;

namespace {

// Whether a region of one world is a region of another one: the same rings, in the same order and turned alike.
bool is_same_region(const World& before, ObstacleId old, const World& after, ObstacleId now) {
  const auto [first, last] = before.vertices_of(old);
  const auto [to, end] = after.vertices_of(now);
  if (last - first != end - to) return false;
  for (VertexId i = 0; i < last - first; ++i)
    if (before.vertex(first + i) != after.vertex(to + i) || before.next(first + i) - first != after.next(to + i) - to)
      return false;
  return true;
}

std::string region_with_vertices(const World& world, ObstacleId region) {
  if (region >= world.region_count()) return "missing";
  const auto [first, last] = world.vertices_of(region);
  return (region == world.obstacle_count() ? "the bounds" : "obstacle " + std::to_string(region)) + " of " +
         std::to_string(last - first) + " vertices from " + shortest_text(world.vertex(first));
}

constexpr const char* kNextStep = "; make the world after by World::changed";

}  // namespace

WorldChange WorldChange::unchecked(const World& before, const World& after, std::span<const ObstacleId> removed) {
  WorldChange change;
  change.vertices_before = before.vertices().size();
  for (const ObstacleId o : removed) {
    change.removed_boxes.push_back(before.box_of(o));
    change.removed_vertices.push_back(before.vertices_of(o));
  }
  if (after.history().follows_at_once(before.history())) {
    change.added_vertices = after.history().last_change().added();
  } else {
    for (auto o = static_cast<ObstacleId>(before.obstacle_count() - removed.size()); o < after.obstacle_count(); ++o)
      change.added_vertices.push_back(after.vertices_of(o));
  }
  for (const World::VertexRange& range : change.added_vertices)
    change.added_boxes.push_back(after.box_of(after.obstacle_of(range.first)));
  return change;
}

WorldChange::WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed) {
  if (before.has_bounds() != after.has_bounds())
    throw std::invalid_argument(std::string("world change: only the world ") +
                                (before.has_bounds() ? "before" : "after") + " has bounds" + kNextStep);
  const auto require_same = [&](ObstacleId old, ObstacleId now) {
    if (now >= after.region_count() || !is_same_region(before, old, after, now))
      throw std::invalid_argument("world change: before it, " + region_with_vertices(before, old) +
                                  ", which is not removed; in its place after it, " + region_with_vertices(after, now) +
                                  kNextStep);
  };
  std::vector<ObstacleId> gone;
  for (ObstacleId o = 0; o < before.obstacle_count(); ++o)
    if (std::binary_search(removed.begin(), removed.end(), o)) gone.push_back(o);
  const WorldChange change = unchecked(before, after, gone);
  const VertexMap map(change);
  ObstacleId now = 0;
  for (ObstacleId o = 0; o < before.obstacle_count(); ++o) {
    if (std::binary_search(gone.begin(), gone.end(), o)) continue;
    while (now < after.obstacle_count() && map.is_added(after.vertices_of(now).first)) ++now;
    require_same(o, now++);
  }
  if (before.has_bounds())
    require_same(static_cast<ObstacleId>(before.obstacle_count()), static_cast<ObstacleId>(after.obstacle_count()));
  *this = change;
}

VertexId WorldChange::vertex_after(VertexId before) const { return VertexMap(*this).after(before); }

}  // namespace arcway
