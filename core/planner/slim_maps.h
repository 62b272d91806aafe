#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "arcway/stop_clock.h"
#include "arcway/visibility_rows.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"

namespace arcway::internal {

/// Maps of a world for slimmer bodies. Where a body has next to no room, the way of a slimmer one is far easier to
/// find, and shows where that of the real one is. Made when first asked for. Thread-safe.
class SlimMaps {
 public:
  /// Shares of the width by which bodies are narrower; they are shorter by half the share. What the first one has no
  /// path for, the real one will hardly have. Of 15 driven worlds with 2 mm of room that trees of the real body do not
  /// solve, trees of the first body solve 13, of the second one 11; but the nearer path is made free more often.
  static constexpr std::array kSlimmer{0.1, 0.03};

  /// @param map   of the real body; must outlive this.
  /// @param rows  of the reduced graph.
  SlimMaps(const Roadmap& map, std::shared_ptr<const VisibilityRows> rows) : map_(map), rows_(std::move(rows)) {}

  /// The map for a body of kSlimmer, with turns of the smallest radius; nullptr if the clock is over before it is
  /// there. Its graph is lazy: this takes O(vertices).
  [[nodiscard]] const Roadmap* operator()(std::size_t i, const StopClock& clock) const;

 private:
  const Roadmap& map_;
  std::shared_ptr<const VisibilityRows> rows_;
  std::array<LateValue<Roadmap>, kSlimmer.size()> maps_;
};

}  // namespace arcway::internal
