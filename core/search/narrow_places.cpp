#include "core/search/narrow_places.h"

#include <utility>

#include "core/passage/gap_circles.h"

namespace arcway {

const SearchMap& NarrowPlaces::map() const {
  std::call_once(once_, [this] {
    const ExtraCircles extra = find_gap_circles(map_.world, map_.vehicle, map_.radii.front());
    if (extra.round.empty() && extra.gates.empty()) return;
    SearchMap detailed = map_;
    detailed.graph = FeasibleGraph(map_.graph, map_.vehicle, extra);
    detailed_ = std::move(detailed);
  });
  return detailed_ ? *detailed_ : map_;
}

}  // namespace arcway
