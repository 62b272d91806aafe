#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/attach/circle_table.h"

namespace arcway::internal {

/// Where a path leaves a circle of the graph.
struct Departure {
  std::uint32_t circle;
  double heading;
};

/// Whether who arrives on a departure's circle at a heading can turn as far as the departure.
bool leads_to(const CircleTable& circles, double arrival, const Departure& departure);

/// All departures from which the graph leads to some given ones, those included: the set is found
/// backwards. A goal that is in a dead end has few of them, however large the map.
/// @return nothing if there are more than `most`. O(most x links that arrive on a circle), after the first call of
///   CircleTable::links_to.
std::optional<std::vector<Departure>> backward_reachable_set(const CircleTable& circles, std::vector<Departure> ends,
                                                             std::size_t most);

}  // namespace arcway::internal
