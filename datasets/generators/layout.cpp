#include "datasets/generators/layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"

namespace arcway::internal::detail {

void check_vertices(const char* kind, std::size_t vertices) {
  if (vertices >= 100 && vertices <= 10'000'000) return;
  throw std::invalid_argument(std::string(kind) + ": vertices is " + std::to_string(vertices) +
                              ", must be from 100 to 10000000");
}

std::size_t square_columns(std::size_t count, double cell_width, double cell_height) {
  const double columns = std::floor(std::sqrt(static_cast<double>(count) * cell_height / cell_width) + 0.5);
  return std::max<std::size_t>(1, static_cast<std::size_t>(columns));
}

std::optional<std::vector<Vec2>> scatter_discs(Random& random, const std::vector<double>& radii, double side,
                                               double gap) {
  // A grid of cells as wide as two discs.
  const double largest = *std::max_element(radii.begin(), radii.end());
  double covered = 0.0;
  for (const double r : radii) covered += kPi * (r + 0.5 * gap) * (r + 0.5 * gap);
  if (covered > 0.55 * side * side || 2.0 * (largest + gap) >= side) return std::nullopt;

  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  // Not many more cells than discs.
  const double most = 2.0 * std::sqrt(static_cast<double>(radii.size())) + 1.0;
  const auto columns = static_cast<std::size_t>(std::clamp(side / (2.0 * largest + gap), 1.0, most));
  const double cell = side / static_cast<double>(columns);
  std::vector<std::vector<std::size_t>> cells(columns * columns);
  const auto index = [&](double x) { return std::min(columns - 1, static_cast<std::size_t>(x / cell)); };

  std::vector<Vec2> centers(radii.size());
  std::size_t tries_left = 60 * radii.size() + 20000;
  for (const std::size_t i : order) {
    const double low = radii[i] + gap, high = side - low;
    const auto fits = [&](const Vec2& c) {
      const std::size_t cx = index(c.x()), cy = index(c.y());
      for (std::size_t y = cy - std::min<std::size_t>(cy, 1); y <= std::min(cy + 1, columns - 1); ++y)
        for (std::size_t x = cx - std::min<std::size_t>(cx, 1); x <= std::min(cx + 1, columns - 1); ++x)
          for (const std::size_t j : cells[y * columns + x]) {
            const double dx = centers[j].x() - c.x(), dy = centers[j].y() - c.y();
            const double reach = radii[i] + radii[j] + gap;
            if (dx * dx + dy * dy < reach * reach) return false;
          }
      return true;
    };
    do {
      if (tries_left-- == 0) return std::nullopt;
      const double x = random.uniform(low, high), y = random.uniform(low, high);
      centers[i] = {x, y};
    } while (!fits(centers[i]));
    cells[index(centers[i].y()) * columns + index(centers[i].x())].push_back(i);
  }
  return centers;
}

}  // namespace arcway::internal::detail
