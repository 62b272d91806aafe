#pragma once

#include <string>

#include "arcway/export.h"
#include "arcway/vec2.h"
#include "arcway/world.h"

namespace arcway {

/// The bottleneck between two poses: the narrowest gap of the widest route, and the width that the vehicle needs.
struct ARCWAY_API Bottleneck {
  double width = 0.0;           ///< of the gap [m]; 0: no route at all, as obstacles meet or one surrounds a pose
  double needed = 0.0;          ///< least width through which the body might pass: a disc in it does [m]
  double needed_to_turn = 0.0;  ///< swept width of the tightest turn, (7), with the safety margin [m]
  ObstacleId obstacle_a = 0, obstacle_b = 0;  ///< on both sides of the gap; may be the same one
  Vec2 on_a{0.0, 0.0}, on_b{0.0, 0.0};        ///< the points where they are nearest to each other
  /// Whether the bottleneck proves that no path exists.
  [[nodiscard]] bool too_narrow() const { return width < needed; }
  /// In words, as "the widest route narrows to 0.52 m between obstacle 3 at (1, 2) and the bounds at (1, 2.52)".
  [[nodiscard]] std::string text(const World& world) const;
};

}  // namespace arcway
