#include <algorithm>

#include "arcway/angle.h"
#include "datasets/generators/layout.h"

namespace arcway::internal::detail {

void lay_out_warehouse(Layout& layout) {
  constexpr double kRack = 12.0, kDepth = 2.4;       // back to back
  constexpr double kAisle = 3.6, kCrossAisle = 6.0;  // between the long sides, between the ends
  constexpr double kMargin = 6.0;
  constexpr double kPalletLength = 1.2, kPalletWidth = 0.8;
  Random& random = layout.random;

  const std::size_t obstacles = (layout.wanted - 4) / 4;
  const std::size_t pallets = obstacles / 12, racks = obstacles - pallets;
  const std::size_t slots = racks + racks / 20;  // one in twenty is missing
  const std::size_t columns = square_columns(slots, kRack + kCrossAisle, kDepth + kAisle);
  const std::size_t rows = (slots + columns - 1) / columns;
  Selection rack_slots(racks, rows * columns), pallet_slots(pallets, rows * columns);
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < rows; ++row) {
      const double left = kMargin + static_cast<double>(column) * (kRack + kCrossAisle);
      const double bottom = kMargin + static_cast<double>(row) * (kDepth + kAisle);
      if (rack_slots.take(random)) {
        const double length = random.below(4) == 0 ? random.uniform(0.5, 1.0) * kRack : kRack;
        layout.add(box_ring(left, bottom, left + length, bottom + kDepth));
      }
      // At the end of a rack, clear of the aisles beside it.
      if (pallet_slots.take(random)) {
        const Vec2 center(left + kRack + 1.2, bottom + 0.5 * kDepth + random.uniform(-0.3, 0.3));
        layout.add(rectangle_ring(center, random.unit_vector(), 0.5 * kPalletLength, 0.5 * kPalletWidth));
      }
    }
  }
  const double width = 2.0 * kMargin + static_cast<double>(columns) * (kRack + kCrossAisle) - kCrossAisle;
  const double height = 2.0 * kMargin + static_cast<double>(rows) * (kDepth + kAisle) - kAisle;
  layout.set_bounds(box_ring(0.0, 0.0, width, height));
  layout.map.start = Pose{0.5 * kMargin, 0.5 * kMargin, 0.5 * kPi};
  layout.map.goal = Pose{width - 0.5 * kMargin, height - 0.5 * kMargin, 0.5 * kPi};
}

}  // namespace arcway::internal::detail
