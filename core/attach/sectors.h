#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "arcway/angle.h"

namespace arcway::internal {

/// A set of headings as 64 equal sectors of the full turn: bit k is the sector of headings [k, k + 1) * 2 pi / 64.
using Sectors = std::uint64_t;

constexpr Sectors kAllSectors = ~Sectors{0};

/// The sectors of the headings from `low` to `high` >= low [rad], widened by rounding.
inline Sectors sectors_of(double low, double high) {
  constexpr double kPerRadian = 64.0 / kTwoPi, kRounding = 1e-6;
  const auto first = static_cast<std::int64_t>(std::floor(low * kPerRadian - kRounding));
  const auto last = static_cast<std::int64_t>(std::floor(high * kPerRadian + kRounding));
  if (last - first >= 63) return kAllSectors;
  return std::rotl((Sectors{2} << (last - first)) - 1, static_cast<int>(first & 63));
}

}  // namespace arcway::internal
