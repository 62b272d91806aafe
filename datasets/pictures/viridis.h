#pragma once

#include <cstddef>
#include <string>

namespace arcway::internal {

// Steps of Viridis that a gradient needs to look like it.
inline constexpr std::size_t kViridisSteps = 5;

// "#rrggbb" of a share from 0 to 1, from dark to bright: it is told apart in gray and by color-blind people.
std::string viridis(double share);

}  // namespace arcway::internal
