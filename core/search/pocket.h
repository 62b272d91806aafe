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

/// All departures from which the graph leads to some given ones, those included: what lies in their pocket, found
/// backwards. A goal that is hemmed in has few of them, however large the map.
/// @return nothing if there are more than `most`. O(most x links that arrive on a circle), after the first call of
///   CircleTable::links_to.
std::optional<std::vector<Departure>> departures_towards(const CircleTable& circles, std::vector<Departure> ends,
                                                         std::size_t most);

}  // namespace arcway::internal
