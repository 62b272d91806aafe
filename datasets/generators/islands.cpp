#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "datasets/generators/layout.h"

namespace arcway::internal::detail {
namespace {

constexpr std::size_t kFewest = 24, kMost = 72;  // vertices of an island

// A smooth closed curve about the origin, star-shaped, at most `radius` from it.
Ring island(Random& random, double radius, std::size_t vertices) {
  constexpr std::size_t kWaves = 4;
  double amplitude[kWaves], phase[kWaves], sum = 1.0;
  for (std::size_t k = 0; k < kWaves; ++k) {
    amplitude[k] = random.uniform(0.0, 0.5) / static_cast<double>(k + 1);
    phase[k] = random.uniform();
    sum += amplitude[k];
  }
  Ring ring;
  ring.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(vertices);
    double reach = 1.0;
    for (std::size_t k = 0; k < kWaves; ++k) {
      const double wave = static_cast<double>(k + 1) * turn + phase[k];
      reach += amplitude[k] * unit_vector_at(wave - std::floor(wave)).x();
    }
    ring.push_back(radius * std::max(0.1, reach) / sum * unit_vector_at(turn));
  }
  return ring;
}

}  // namespace

void lay_out_islands(Layout& layout) {
  constexpr double kGap = 3.0;
  Random& random = layout.random;
  std::vector<Ring> rings;
  std::vector<double> radii;
  double area = 0.0;
  for (std::size_t left = layout.wanted - 4; left > 0;) {
    const std::size_t vertices =
        left <= kMost ? left : std::min(left - kFewest, kFewest + random.below(kMost - kFewest));
    left -= vertices;
    const double u = random.uniform();
    radii.push_back(4.0 + 16.0 * u * u);  // many small ones
    rings.push_back(island(random, radii.back(), vertices));
    area += (radii.back() + 0.5 * kGap) * (radii.back() + 0.5 * kGap);
  }
  std::optional<std::vector<Vec2>> centers;
  double side = std::sqrt(kPi * area / 0.5);
  const double room = 8.0;  // for start and goal in the corners
  while (!(centers = scatter_discs(random, radii, side, kGap))) side *= 1.1;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (Vec2& p : rings[i]) p += (*centers)[i] + Vec2(room, room);
    layout.add(std::move(rings[i]));
  }
  side += 2.0 * room;
  layout.set_bounds(box_ring(0.0, 0.0, side, side));
  layout.map.start = Pose{0.5 * room, 0.5 * room, 0.0};
  layout.map.goal = Pose{side - 0.5 * room, side - 0.5 * room, 0.0};
}

}  // namespace arcway::internal::detail
