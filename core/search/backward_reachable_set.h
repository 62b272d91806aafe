#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/attach/circle_table.h"

namespace arcway::internal {

/// A departure: where a path leaves a circle of the graph.
struct Departure {
  std::uint32_t circle;
  double heading;  ///< [rad]
};

/// Whether a path that arrives on a departure's circle at a heading can turn as far as the departure.
bool leads_to(const CircleTable& circles, double arrival, const Departure& departure);

/// The backward-reachable set: all departures from which the graph leads to given ones, those included. It is small for
/// a goal in a dead end, however large the map.
/// @param ends  the given departures.
/// @return nothing if the set has more than `most`. O(most x links that arrive on a circle), after the first call of
///   CircleTable::links_to.
std::optional<std::vector<Departure>> backward_reachable_set(const CircleTable& circles, std::vector<Departure> ends,
                                                             std::size_t most);

}  // namespace arcway::internal
