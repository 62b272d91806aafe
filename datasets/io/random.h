#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "arcway/vec2.h"

namespace arcway::internal {

/// xoshiro256** seeded by splitmix64 [Blackman and Vigna 2018]. The same numbers on every platform: the standard
/// engines are portable, the standard distributions are not. All draws use +, -, *, / and sqrt only, which IEEE 754
/// rounds correctly (the library is compiled without contraction).
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9E3779B97F4A7C15u;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
      z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
      word = z ^ (z >> 31);
    }
  }

  std::uint64_t next() {
    const std::uint64_t result = rotate(state_[1] * 5, 7) * 9;
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotate(state_[3], 45);
    return result;
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in [low, high); may round to high.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in [0, count), count > 0, without bias.
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t limit = UINT64_MAX - UINT64_MAX % count;
    std::uint64_t value = next();
    while (value >= limit) value = next();
    return value % count;
  }
  /// A uniform direction, by rejection from the disc.
  Vec2 unit_vector() {
    while (true) {
      const double x = uniform(-1.0, 1.0), y = uniform(-1.0, 1.0);
      const double squared = x * x + y * y;
      if (squared > 1.0 || squared < 1e-4) continue;
      const double norm = std::sqrt(squared);
      return {x / norm, y / norm};
    }
  }

 private:
  static std::uint64_t rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
  std::array<std::uint64_t, 4> state_{};
};

/// The point of the unit circle at `turns` full turns from +x, 0 <= turns <= 1, within 1e-15; bit-identical
/// on all platforms, which std::cos is not.
inline Vec2 unit_vector_at(double turns) {
  const double quarters = turns * 4.0;
  const double whole = std::floor(quarters + 0.5);
  const double angle = (quarters - whole) * 1.5707963267948966;  // |angle| <= pi/4
  const double z = angle * angle;
  double sine = 0.0, cosine = 0.0;
  for (int k = 10; k >= 1; --k) {  // Taylor, from the smallest term
    sine = (1.0 + sine) * (-z / ((2.0 * k) * (2.0 * k + 1.0)));
    cosine = (1.0 + cosine) * (-z / ((2.0 * k - 1.0) * (2.0 * k)));
  }
  const double c = 1.0 + cosine, s = angle * (1.0 + sine);
  switch (static_cast<int>(whole) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace arcway::internal
