#pragma once

#include <limits>

namespace arcway::internal {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace arcway::internal
