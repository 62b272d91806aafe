#pragma once

#include <optional>

#include "core/attach/search_map.h"
#include "core/base/late_value.h"
#include "core/base/stop_clock.h"

namespace [[gnu::visibility("default")]] arcway {

/// A map with extra circles in its narrow places, see find_gap_circles. If it has such places, but one radius and v_mc
/// is the same on wider turns, circles four times as wide go round all vertices as well. Made when first asked for.
/// Thread-safe.
class NarrowPlaces {
 public:
  /// @param map  must outlive this.
  explicit NarrowPlaces(const SearchMap& map) : map_(map) {}

  /// The same map but for the graph, which is lazy and has all straights of the map's own and more. The map itself if
  /// it has no narrow place, or if the clock is over before they are known. The first call takes as long as GapMap.
  [[nodiscard]] const SearchMap& map(const StopClock& clock = {}) const;

 private:
  const SearchMap& map_;
  LateValue<std::optional<SearchMap>> detailed_;  // nothing where there is no narrow place
};

}  // namespace arcway
