#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/model/vertex_map.h"
#include "core/model/world_data.h"

namespace arcway {

/// What becomes of the obstacles of a world: which stay, and where added ones go. See World::changed.
struct World::Data::Change {
  /// @param the_removed, the_added  must outlive this.
  Change(const World& world, std::span<const ObstacleId> the_removed, std::span<const Polygon> the_added);

  /// Obstacles that follow each other after the change.
  struct Run {
    ObstacleId begin, end;
    ObstacleId before;  // the first one of those in whose places they are; kNone: they follow all that were there
    std::size_t added;  // the first one among those added; kStay: they are those of before
  };
  static constexpr std::size_t kStay = static_cast<std::size_t>(-1);

  void add_run(ObstacleId count, ObstacleId before, std::size_t first_added);
  [[nodiscard]] const Run& run_of(ObstacleId o) const {
    return *(std::ranges::upper_bound(runs, o, {}, &Run::begin) - 1);
  }

  std::span<const ObstacleId> removed;
  std::span<const Polygon> added;
  std::vector<Run> runs;
  ObstacleId obstacles = 0;     // after the change
  ObstacleId first_behind = 0;  // of these: the first one that is in no other's place
  VertexMap map{{}, {}};
};

}  // namespace arcway
