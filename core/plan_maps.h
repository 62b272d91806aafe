#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "core/search/narrow_places.h"
#include "core/search/search_map.h"

namespace arcway {

/// What paths with turns of some radii are looked for on.
struct PlanMaps {
  PlanMaps(SearchMap map, bool gap_circles) : plain(std::move(map)) {
    if (gap_circles && plain.world.vertices().size() <= kNarrowVertices) narrow.emplace(plain);
  }
  PlanMaps(const PlanMaps&) = delete;  // `narrow` refers to `plain`

  /// The graph with circles in narrow places is lazy: where there is no path, a search checks all that the start
  /// reaches, seconds on larger maps.
  static constexpr std::size_t kNarrowVertices = 50'000;

  SearchMap plain;
  std::optional<NarrowPlaces> narrow;
};

}  // namespace arcway
