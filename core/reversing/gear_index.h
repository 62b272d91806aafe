#pragma once

#include <cstddef>

#include "arcway/path.h"

namespace arcway::internal {

/// Place of what belongs to a gear in an array for both.
constexpr std::size_t gear_index(Gear gear) { return gear == Gear::kForward ? 0 : 1; }

}  // namespace arcway::internal
