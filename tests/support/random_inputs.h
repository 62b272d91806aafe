#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "arcway/angle.h"
#include "arcway/polygon.h"
#include "arcway/vec2.h"

namespace arcway::internal::test {

/// Seeded random numbers and points, by splitmix64. They are the same on every platform, unlike those of <random>.
class RandomInputs {
 public:
  explicit RandomInputs(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// In [low, high], both included.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  Vec2 point(double low, double high) {
    const double x = uniform(low, high);
    return {x, uniform(low, high)};
  }
  /// Whole coordinates: many coincidences and collinear triples if the range is small.
  Vec2 grid_point(std::int64_t low, std::int64_t high) {
    const auto x = static_cast<double>(integer(low, high));
    return {x, static_cast<double>(integer(low, high))};
  }

 private:
  std::uint64_t state_;
};

/// A simple counter-clockwise ring around `center`, star-shaped, radii in [inner, outer].
inline Ring random_star(RandomInputs& random, const Vec2& center, double inner, double outer, std::size_t vertices) {
  Ring ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = kTwoPi * (static_cast<double>(i) + random.uniform(0.0, 0.8)) / static_cast<double>(vertices);
    ring.push_back(center + random.uniform(inner, outer) * direction_of(angle));
  }
  return ring;
}

inline Ring square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

inline Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace arcway::internal::test
