#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/world.h"
#include "arcway/zone.h"

namespace arcway {

/// The zones of a world, and which of its obstacles stand for keep-outs.
struct World::Zones {
  /// Null without zones.
  /// @param keep_outs  by zone: the key of its obstacle, internal::kNone for none; or empty.
  static std::shared_ptr<const Zones> of(std::vector<Zone> zones, std::span<const std::uint32_t> keep_outs);

  /// An obstacle that stands for a keep-out.
  struct Closed {
    ObstacleKey obstacle;
    std::uint32_t zone;
  };

  std::vector<Zone> all;
  std::vector<Closed> closed;  ///< ascending by obstacle
};

}  // namespace arcway
