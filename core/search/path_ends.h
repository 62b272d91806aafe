#pragma once

#include <cstddef>

namespace arcway::internal {

/// The two ends of a path, as indices of arrays. Searches that grow a tree from each end take them in turn.
inline constexpr std::size_t kStartEnd = 0, kGoalEnd = 1;

/// The end of a path that is not this one.
constexpr std::size_t other_end(std::size_t end) { return end == kStartEnd ? kGoalEnd : kStartEnd; }

}  // namespace arcway::internal
