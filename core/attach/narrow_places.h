#pragma once

#include <optional>

#include "arcway/stop_clock.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"

namespace arcway::internal {

/// A map with added circles in its narrow places, see find_gap_circles. If it has such places, but one radius and v_mc
/// is the same on wider turns, circles four times as wide go round all vertices as well. Made when first asked for.
/// Thread-safe.
class NarrowPlaces {
 public:
  /// @param map  must outlive this.
  explicit NarrowPlaces(const Roadmap& map) : map_(map) {}

  /// The same map but for the graph, which is lazy and has all straights of the map's own and more. The map itself if
  /// it has no narrow place, or if the clock is over before they are known. The first call takes as long as GapMap.
  [[nodiscard]] const Roadmap& map(const StopClock& clock = {}) const;

 private:
  const Roadmap& map_;
  LateValue<std::optional<Roadmap>> detailed_;  // nothing where there is no narrow place
};

}  // namespace arcway::internal
