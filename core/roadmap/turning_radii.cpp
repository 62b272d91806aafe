#include "arcway/turning_radii.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/roadmap/circle_radii.h"

namespace arcway {

using namespace internal;

namespace {

constexpr double kLeastRatio = 2.0;  // least ratio of a radius to the one before
constexpr double kMostRatios =
    4.0;  // largest number of radii beside the smallest one and one that leads around vertices
constexpr double kLeastLastRatio = 1.4;  // least ratio of the last radius to the one before; else it is left out
constexpr double kWidest = 1e6;          // largest radius [m]
constexpr double kRoundVertex = 1.5;     // radius that leads around a vertex, in half widths of the body

// The smallest radius with the speed of the fastest turns. Between its table's radii, or all along, v_mc rises or
// falls.
double fastest_radius(const Vehicle& vehicle, double smallest) {
  std::vector<double> radii{smallest};
  if (const auto* table = std::get_if<TurnSpeedTable>(&vehicle.parameters().turn_speed)) {
    for (const auto& [radius, speed] : table->entries)
      if (radius > smallest) radii.push_back(radius);
  } else {
    radii.push_back(kWidest);
  }
  const auto fastest =
      std::ranges::max_element(radii, {}, [&](double radius) { return vehicle.turn_speed(radius); });  // the first one
  if (fastest == radii.begin()) return smallest;
  const double top = vehicle.turn_speed(*fastest);
  double slower = *(fastest - 1);
  double radius = *fastest;
  while (radius > slower * (1.0 + 1e-9)) {
    const double middle = 0.5 * (slower + radius);
    (vehicle.turn_speed(middle) >= top ? radius : slower) = middle;
  }
  return radius;
}

}  // namespace

std::vector<double> turning_radii(const Vehicle& vehicle, const World& world) {
  const double smallest = vehicle.min_turning_radius();
  const double extent = world.box().empty() ? smallest : 0.5 * (world.box().max - world.box().min).norm();
  const double largest = std::min(fastest_radius(vehicle, smallest), extent);
  const double factor = std::max(kLeastRatio, std::pow(largest / smallest, 1.0 / kMostRatios));
  std::vector<double> radii{smallest};
  while (radii.back() * factor * kLeastLastRatio < largest) radii.push_back(radii.back() * factor);
  if (radii.back() * kLeastLastRatio < largest) radii.push_back(largest);
  const Footprint grown_body = vehicle.footprint(vehicle.safety_margin());
  if (const CircleRadii all(vehicle, radii); !lead_round_vertices(grown_body, all[all.size() - 1]))
    radii.push_back(kRoundVertex * std::max(grown_body.left, grown_body.right));
  return radii;
}

std::size_t tightest_radii(const Footprint& grown_body, std::span<const double> radii) {
  return CircleRadii(std::vector<double>(radii.begin(), radii.end())).tightest(grown_body);
}

}  // namespace arcway
