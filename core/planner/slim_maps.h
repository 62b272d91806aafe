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

/// Roadmaps of a world for slimmer bodies. Where a body has next to no room, the path of a slimmer one is far easier to
/// find, and shows where that of the real one is. Made when first asked for. Thread-safe.
class SlimMaps {
 public:
  /// Shares of the width by which bodies are narrower; they are shorter by half the share. If the first body has no
  /// path, the real one hardly has one. Measured on 15 driven worlds with 2 mm of room which trees of the real body do
  /// not solve: trees of the first body solve 13, of the second one 11. A path of the second one is made free more
  /// often.
  static constexpr std::array kSlimmer{0.1, 0.03};

  /// @param map  of the real body; must outlive this.
  /// @param rows  of the reduced graph.
  SlimMaps(const Roadmap& map, std::shared_ptr<const VisibilityRows> rows) : map_(map), rows_(std::move(rows)) {}

  /// The roadmap for a body of kSlimmer, with turns of the smallest radius; null if the clock is over before it is
  /// made. Its graph is lazy, so that this takes O(vertices).
  [[nodiscard]] const Roadmap* operator()(std::size_t i, const StopClock& clock) const;

 private:
  const Roadmap& map_;
  std::shared_ptr<const VisibilityRows> rows_;
  std::array<LateValue<Roadmap>, kSlimmer.size()> maps_;
};

}  // namespace arcway::internal
