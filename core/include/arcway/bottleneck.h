#pragma once

#include <string>

#include "arcway/export.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway {

/// The narrowest place of the widest way between two poses, and what the vehicle takes.
struct ARCWAY_API Bottleneck {
  double width = 0.0;           ///< 0: obstacles that meet, or one that lies all around a pose, leave no way at all [m]
  double needed = 0.0;          ///< see widest_hopeless_gap [m]
  double needed_to_turn = 0.0;  ///< swept width of the tightest turn, (7), with the safety margin [m]
  ObstacleId obstacle_a = 0, obstacle_b = 0;  ///< on both sides; may be the same
  Vec2 on_a{0.0, 0.0}, on_b{0.0, 0.0};        ///< where they are nearest to each other
  [[nodiscard]] bool too_narrow() const { return width < needed; }
  /// "the widest way narrows to 0.52 m between obstacle 3 at (1, 2) and the bounds at (1, 2.52)".
  [[nodiscard]] std::string text(const World& world) const;
};

}  // namespace arcway
