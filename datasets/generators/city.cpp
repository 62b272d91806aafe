#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/generators/layout.h"

namespace arcway::internal::detail {
namespace {

constexpr double kBlock = 60.0;  // between two crossings [m]
constexpr double kHalfStreet = 4.5;
constexpr double kVerticesPerBlock = 22.4;  // measured

// A block between four streets. Its plots are drawn on the unit square and mapped to it line by line, so that what is
// disjoint there is disjoint here.
struct Block {
  std::array<Vec2, 4> corners;  // counter-clockwise
  [[nodiscard]] Vec2 at(double u, double v) const {
    return (1.0 - v) * ((1.0 - u) * corners[0] + u * corners[1]) + v * ((1.0 - u) * corners[3] + u * corners[2]);
  }
  [[nodiscard]] Ring map(const Ring& ring) const {
    Ring mapped;
    mapped.reserve(ring.size());
    for (const Vec2& p : ring) mapped.push_back(at(p.x(), p.y()));
    return mapped;
  }
};

// A box, an L or a T that fills the plot.
Ring house(Random& random, const Box& plot) {
  const double x0 = plot.min.x(), y0 = plot.min.y(), x1 = plot.max.x(), y1 = plot.max.y();
  const double u = x0 + random.uniform(0.35, 0.65) * (x1 - x0), v = y0 + random.uniform(0.35, 0.65) * (y1 - y0);
  switch (random.below(6)) {
    case 0:
      return {{x0, y0}, {x1, y0}, {x1, v}, {u, v}, {u, y1}, {x0, y1}};
    case 1:
      return {{x0, y0}, {u, y0}, {u, v}, {x1, v}, {x1, y1}, {x0, y1}};
    case 2: {
      const double a = x0 + 0.3 * (x1 - x0), b = x0 + 0.7 * (x1 - x0);
      return {{x0, y0}, {x1, y0}, {x1, v}, {b, v}, {b, y1}, {a, y1}, {a, v}, {x0, v}};
    }
    default:
      return box_ring(x0, y0, x1, y1);
  }
}

void add_houses(Layout& layout, const Block& block) {
  Random& random = layout.random;
  const std::size_t columns = 2 + random.below(2), rows = 2;
  const double width = 1.0 / static_cast<double>(columns), height = 1.0 / static_cast<double>(rows);
  for (std::size_t i = 0; i < columns; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      Box plot;
      plot.min = Vec2(static_cast<double>(i) * width, static_cast<double>(j) * height).array() + 0.03;
      plot.max = Vec2(static_cast<double>(i + 1) * width, static_cast<double>(j + 1) * height).array() - 0.03;
      const double setback = random.uniform(0.0, 0.06);
      plot.min.array() += setback;
      layout.add(block.map(house(random, plot)));
    }
  }
}

// One building round a courtyard, its street corners cut.
void add_courtyard(Layout& layout, const Block& block) {
  Random& random = layout.random;
  const double c = random.uniform(0.06, 0.15), d = random.uniform(0.22, 0.3);
  Ring outer{{c, 0}, {1 - c, 0}, {1, c}, {1, 1 - c}, {1 - c, 1}, {c, 1}, {0, 1 - c}, {0, c}};
  Ring yard = box_ring(d, d, 1.0 - d, 1.0 - d);
  std::reverse(yard.begin(), yard.end());
  layout.add(block.map(outer), {block.map(yard)});
}

// A pond in a park.
void add_pond(Layout& layout, const Block& block) {
  Random& random = layout.random;
  constexpr std::size_t kVertices = 24;
  const double phase = random.uniform(), squeeze = random.uniform(0.6, 1.0);
  Ring ring;
  for (std::size_t i = 0; i < kVertices; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(kVertices);
    const double wave = unit_vector_at(2.0 * turn + phase - std::floor(2.0 * turn + phase)).x();
    const Vec2 p = (0.36 + 0.06 * wave) * unit_vector_at(turn);
    ring.push_back({0.5 + p.x(), 0.5 + squeeze * p.y()});
  }
  layout.add(block.map(ring));
}

}  // namespace

void lay_out_city(Layout& layout) {
  Random& random = layout.random;
  const double blocks = static_cast<double>(layout.wanted) / kVerticesPerBlock;
  const auto columns = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(std::sqrt(blocks))));
  const auto rows =
      std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(blocks / static_cast<double>(columns))));
  // Crossings a few meters off their places, so that no two streets are parallel.
  std::vector<Vec2> crossings;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const double dx = random.uniform(-6.0, 6.0), dy = random.uniform(-6.0, 6.0);
      crossings.emplace_back(kBlock * (static_cast<double>(i) + 0.25) + dx,
                             kBlock * (static_cast<double>(j) + 0.25) + dy);
    }
  }
  const double width = kBlock * (static_cast<double>(columns) + 0.5),
               height = kBlock * (static_cast<double>(rows) + 0.5);
  layout.set_bounds(box_ring(0.0, 0.0, width, height));

  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      if (layout.missing() < 16) break;  // open ground
      const std::size_t c = j * (columns + 1) + i;
      const Block whole{{crossings[c], crossings[c + 1], crossings[c + columns + 2], crossings[c + columns + 1]}};
      constexpr double kInset = kHalfStreet / (kBlock - 12.0);  // share of the narrowest block
      const Block block{{whole.at(kInset, kInset), whole.at(1 - kInset, kInset), whole.at(1 - kInset, 1 - kInset),
                         whole.at(kInset, 1 - kInset)}};
      switch (random.below(8)) {
        case 0:
          add_pond(layout, block);
          break;
        case 1:
        case 2:
          add_courtyard(layout, block);
          break;
        default:
          add_houses(layout, block);
      }
    }
  }
  layout.map.start = Pose{4.0, 4.0, 0.0};
  layout.map.goal = Pose{width - 4.0, height - 4.0, 0.0};
}

}  // namespace arcway::internal::detail
