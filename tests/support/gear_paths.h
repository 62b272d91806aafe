#pragma once

#include <cstddef>

#include "arcway/path.h"
#include "core/motion/gear_words.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// A path with some changes of gear, in no world: the shortest such word between random poses of a square.
inline Path random_gear_path(RandomInputs& random, double radius, double side) {
  for (;;) {
    const Pose from{random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(-3.0, 3.0)};
    const Pose to{random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(-3.0, 3.0)};
    const GearWords words(from, to, radius);
    Path shortest;
    for (std::size_t word = 0; word < kGearWords; ++word)
      if (const auto path = words.path(word); path && cusps_of(*path) > 0)
        if (shortest.empty() || length_of(*path) < length_of(shortest)) shortest = *path;
    if (!shortest.empty()) return shortest;
  }
}

}  // namespace arcway::internal::test
