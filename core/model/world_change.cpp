#include "arcway/world_change.h"

#include <algorithm>

namespace arcway {

WorldChange::WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed) {
  vertex_after.assign(before.vertices().size(), kNone);
  const auto move_region = [&](ObstacleId old, ObstacleId now) {
    const VertexId to = after.vertices_of(now).first;
    const auto [first, last] = before.vertices_of(old);
    for (VertexId v = first; v < last; ++v) vertex_after[v] = v - first + to;
  };
  ObstacleId now = 0;
  for (ObstacleId o = 0; o < before.obstacle_count(); ++o) {
    if (std::binary_search(removed.begin(), removed.end(), o)) {
      removed_boxes.push_back(before.box_of(o));
    } else {
      move_region(o, now++);
    }
  }
  const auto obstacles = static_cast<ObstacleId>(after.obstacle_count());
  first_added =
      now < after.region_count() ? after.vertices_of(now).first : static_cast<VertexId>(after.vertices().size());
  for (; now < obstacles; ++now) added_boxes.push_back(after.box_of(now));
  end_added = after.has_bounds() ? after.vertices_of(obstacles).first : static_cast<VertexId>(after.vertices().size());
  if (before.has_bounds()) move_region(static_cast<ObstacleId>(before.obstacle_count()), obstacles);
}

}  // namespace arcway
