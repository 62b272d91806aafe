#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "arcway/zone.h"

namespace arcway::internal {

// How pictures show zones: each role has a color and a pattern of its own.

std::string_view zone_color(const Zone& zone);

// A <pattern> of this id, in meters, at so many pixels a meter. Arrows show the heading of a one-way zone, lines
// others.
std::string zone_pattern(const Zone& zone, const std::string& id, double scale);

// "school 2 m/s", "dock for van", "lane 1.57 ± 0.1 rad", "hall 0.5 m, 10 s/m", "zone 3".
std::string legend_text(const Zone& zone, std::size_t index);

}  // namespace arcway::internal
