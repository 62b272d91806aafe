#include <algorithm>
#include <cmath>

#include "datasets/generators/layout.h"

namespace arcway::internal::detail {

void lay_out_coastline(Layout& layout) {
  constexpr double kFirstWave = 0.35;  // amplitude of the coarsest wave, as a share of the radius
  constexpr double kDecay = 0.56;      // factor of the amplitude when the wave length is halved
  Random& random = layout.random;
  const std::size_t n = layout.wanted - 4;
  const double radius = 60.0 * std::sqrt(static_cast<double>(n) / 1000.0);

  // Noise at every scale down to two vertices, linear between random values. The amplitudes add up to less than 0.8,
  // so that the radius stays positive; as a function of the angle it makes a simple ring.
  std::vector<double> reach(n, 1.0);
  double amplitude = kFirstWave;
  for (std::size_t waves = 3; waves <= n / 2; waves *= 2, amplitude *= kDecay) {
    std::vector<double> values(waves);
    for (double& value : values) value = random.uniform(-amplitude, amplitude);
    for (std::size_t i = 0; i < n; ++i) {
      const double place = static_cast<double>(i) * static_cast<double>(waves) / static_cast<double>(n);
      const double cell = std::floor(place), t = place - cell;
      const std::size_t k = std::min(static_cast<std::size_t>(cell), waves - 1);
      reach[i] += (1.0 - t) * values[k] + t * values[k + 1 < waves ? k + 1 : 0];
    }
  }
  Box box;
  Ring ring;
  ring.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    ring.push_back(radius * reach[i] * unit_vector_at(static_cast<double>(i) / static_cast<double>(n)));
    box.extend(ring.back());
  }
  constexpr double kWater = 10.0;  // between the island's box and the bounds
  const Vec2 offset = Vec2(kWater, kWater) - box.min, extent = box.max - box.min + Vec2(2.0 * kWater, 2.0 * kWater);
  for (Vec2& p : ring) p += offset;
  layout.add(std::move(ring));
  layout.set_bounds(box_ring(0.0, 0.0, extent.x(), extent.y()));
  layout.map.start = Pose{0.5 * kWater, 0.5 * kWater, 0.0};
  layout.map.goal = Pose{extent.x() - 0.5 * kWater, extent.y() - 0.5 * kWater, 0.0};
}

}  // namespace arcway::internal::detail
