#include <algorithm>
#include <cmath>

#include "arcway/angle.h"
#include "datasets/generators/layout.h"

namespace arcway::internal::detail {

void lay_out_corridor(Layout& layout) {
  constexpr double kPitch = 5.0;    // from wall to wall; at least 4.5 m are free
  constexpr double kStep = 2.0;     // along a wall, from corner to corner
  constexpr double kSlit = 0.4;     // at the closed end: to see through, not to drive through
  constexpr double kOpening = 5.0;  // at the open one
  Random& random = layout.random;

  const std::size_t vertices = layout.wanted - 4;
  const auto walls = std::max<std::size_t>(
      2, static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices) * kStep / (2.0 * kPitch))));
  const double length = kStep * static_cast<double>(vertices / (2 * walls) - 1);
  const double width = kSlit + length + kOpening;
  for (std::size_t i = 0; i < walls; ++i) {
    // Vertices of each side; the first walls take the remainder.
    const std::size_t corners = vertices / (2 * walls) + (i < vertices / 2 % walls ? 1 : 0);
    const double left = i % 2 == 0 ? kSlit : kOpening, y = kPitch * static_cast<double>(i + 1);
    const auto x = [&](std::size_t k) {
      return left + length * (static_cast<double>(k) / static_cast<double>(corners - 1));
    };
    Ring ring;
    for (std::size_t k = 0; k < corners; ++k) ring.emplace_back(x(k), y - random.uniform(0.1, 0.25));
    for (std::size_t k = corners; k-- > 0;) ring.emplace_back(x(k), y + random.uniform(0.1, 0.25));
    layout.add(std::move(ring));
  }
  const double height = kPitch * static_cast<double>(walls + 1);
  layout.set_bounds(box_ring(0.0, 0.0, width, height));
  // The last corridor is entered on the side where the last wall is open.
  const bool from_left = (walls - 1) % 2 == 1;
  layout.map.start = Pose{kOpening, 0.5 * kPitch, 0.0};
  layout.map.goal =
      from_left ? Pose{width - kOpening, height - 0.5 * kPitch, 0.0} : Pose{kOpening, height - 0.5 * kPitch, kPi};
}

}  // namespace arcway::internal::detail
