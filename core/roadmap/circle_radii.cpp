#include "core/roadmap/circle_radii.h"

#include <algorithm>
#include <cmath>

namespace arcway::internal {

namespace {

// Radii from a first one on, spread over as large a ratio as is left up to the last of some others.
std::vector<double> spread_from(double first, const std::vector<double>& others) {
  if (others.empty() || others.front() >= first) return others;
  const double last = std::max(first, others.back());
  const double ratio = std::log(others.back() / others.front());
  const double share = ratio > 0.0 ? std::log(last / first) / ratio : 0.0;
  std::vector<double> radii;
  for (const double radius : others) radii.push_back(first * std::pow(radius / others.front(), share));
  return radii;
}

}  // namespace

CircleRadii::CircleRadii(const Vehicle& vehicle, const std::vector<double>& tighter)
    : left_(spread_from(vehicle.min_turning_radius(Side::kLeft), tighter)),
      right_(spread_from(vehicle.min_turning_radius(Side::kRight), tighter)) {}

CircleRadii CircleRadii::first(std::size_t count) const {
  CircleRadii radii = *this;
  radii.left_.resize(count);
  radii.right_.resize(count);
  return radii;
}

std::size_t CircleRadii::tightest(const Footprint& grown_body) const {
  std::size_t count = 1;
  while (count < size() && !lead_round_vertices(grown_body, (*this)[count - 1])) ++count;
  return count;
}

bool lead_round_vertices(const Footprint& grown_body, const SideRadii& radii) {
  return radii.left > grown_body.left && radii.right > grown_body.right;
}

}  // namespace arcway::internal
