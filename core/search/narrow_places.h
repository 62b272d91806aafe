#pragma once

#include <mutex>
#include <optional>

#include "core/search/search_map.h"

namespace [[gnu::visibility("default")]] arcway {

/// A map with extra circles in its narrow places, see find_gap_circles. If it has such places, but one radius and v_mc
/// is the same on wider turns, circles four times as wide go round all vertices as well. Made when first asked for.
/// Thread-safe.
class NarrowPlaces {
 public:
  /// @param map  must outlive this.
  explicit NarrowPlaces(const SearchMap& map) : map_(map) {}

  /// The same map but for the graph, which is lazy and has all straights of the map's own and more. The map itself if
  /// it has no narrow place. The first call takes as long as GapMap.
  [[nodiscard]] const SearchMap& map() const;

 private:
  const SearchMap& map_;
  mutable std::once_flag once_;
  mutable std::optional<SearchMap> detailed_;
};

}  // namespace arcway
