#include "datasets/pictures/viridis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arcway::internal {
namespace {

// At even steps.
constexpr std::array<std::array<double, 3>, kViridisSteps> kViridis = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

}  // namespace

std::string viridis(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(kViridis.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  std::string color = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    constexpr const char* kDigits = "0123456789abcdef";
    const auto value = static_cast<unsigned>(
        std::lround(std::lerp(kViridis[i][c], kViridis[i + 1][c], place - static_cast<double>(i))));
    color += kDigits[value / 16];
    color += kDigits[value % 16];
  }
  return color;
}

}  // namespace arcway::internal
