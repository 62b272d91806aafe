#include <algorithm>

#include "arcway/angle.h"
#include "datasets/generators/layout.h"

namespace arcway::internal::detail {
namespace {

// A rectangle without its corners: 8 vertices.
Ring chamfered(const Vec2& center, const Vec2& along, double half_length, double half_width, double cut) {
  const Vec2 u = along, v(-along.y(), along.x());
  const double a = half_length, b = half_width, c = half_length - cut, d = half_width - cut;
  return {center - a * u - d * v, center - c * u - b * v, center + c * u - b * v, center + a * u - d * v,
          center + a * u + d * v, center + c * u + b * v, center - c * u + b * v, center - a * u + d * v};
}

}  // namespace

void lay_out_parking(Layout& layout) {
  constexpr std::size_t kBays = 20;                  // bays of one row
  constexpr double kBayWidth = 2.6, kBay = 5.0;      // m
  constexpr double kDrive = 6.5, kCross = 7.0;       // along the rows, at their ends
  constexpr double kCurb = 1.5;                      // at each end of a double row
  constexpr std::size_t kVertices = 8;               // vertices of a car or a curb
  constexpr std::size_t kSlots = 2 * kBays;          // bays of one block
  constexpr std::size_t kFull = kSlots * 4 / 5 + 2;  // obstacles in a block when four bays of five are taken
  const double block_width = static_cast<double>(kBays) * kBayWidth + 2.0 * kCurb, block_height = 2.0 * kBay;
  Random& random = layout.random;

  const std::size_t obstacles = (layout.wanted - 4) / kVertices;
  const std::size_t blocks = (obstacles + kFull - 1) / kFull;
  const std::size_t columns = square_columns(blocks, block_width + kCross, block_height + kDrive);
  const std::size_t rows = (blocks + columns - 1) / columns;
  const std::size_t curbs = 2 * rows * columns;
  Selection taken(obstacles > curbs ? obstacles - curbs : 0, rows * columns * kSlots);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double left = kCross + static_cast<double>(column) * (block_width + kCross);
      const double bottom = kDrive + static_cast<double>(row) * (block_height + kDrive);
      for (const double x : {left + 0.5 * kCurb, left + block_width - 0.5 * kCurb})
        layout.add(chamfered({x, bottom + kBay}, {0.0, 1.0}, kBay - 0.3, 0.5 * kCurb - 0.2, 0.45));
      for (std::size_t slot = 0; slot < kSlots; ++slot) {
        const bool upper = slot >= kBays;  // entered from above, nose down
        const Vec2 center(left + kCurb + (static_cast<double>(slot % kBays) + 0.5) * kBayWidth,
                          bottom + (upper ? 1.5 : 0.5) * kBay);
        if (taken.take(random)) {
          const double turn = 0.25 + random.uniform(-0.006, 0.006);
          const double x = random.uniform(-0.2, 0.2), y = random.uniform(-0.1, 0.1);
          const double length = random.uniform(3.6, 4.7), width = random.uniform(1.6, 1.9);
          layout.add(chamfered(center + Vec2(x, y), unit_vector_at(turn), 0.5 * length, 0.5 * width, 0.3));
        } else {  // the last free bay
          const double into = upper ? -1.0 : 1.0;
          layout.map.goal = Pose{center.x(), center.y() - 0.65 * into, 0.5 * kPi * into};
        }
      }
    }
  }
  layout.set_bounds(box_ring(0.0, 0.0, kCross + static_cast<double>(columns) * (block_width + kCross),
                             kDrive + static_cast<double>(rows) * (block_height + kDrive)));
  layout.map.start = Pose{0.5 * kCross, 0.5 * kDrive, 0.5 * kPi};
}

}  // namespace arcway::internal::detail
