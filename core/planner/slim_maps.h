#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "core/attach/search_map.h"
#include "core/base/late_value.h"
#include "core/base/stop_clock.h"
#include "core/roadmap/visibility_rows.h"

namespace arcway {

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
  SlimMaps(const SearchMap& map, std::shared_ptr<const VisibilityRows> rows) : map_(map), rows_(std::move(rows)) {}

  /// The map for a body of kSlimmer, with turns of the smallest radius; nullptr if the clock is over before it is
  /// there. Its graph is lazy: this takes O(vertices).
  [[nodiscard]] const SearchMap* operator()(std::size_t i, const StopClock& clock) const;

 private:
  const SearchMap& map_;
  std::shared_ptr<const VisibilityRows> rows_;
  std::array<LateValue<SearchMap>, kSlimmer.size()> maps_;
};

}  // namespace arcway
