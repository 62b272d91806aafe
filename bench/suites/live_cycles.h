#pragma once

#include <cstddef>

namespace arcway::internal::bench {

/// Number of cycles of each drive of `Live` (`--live-cycles`); 0: that of the study.
inline std::size_t& live_cycles() {
  static std::size_t cycles = 0;
  return cycles;
}

}  // namespace arcway::internal::bench
