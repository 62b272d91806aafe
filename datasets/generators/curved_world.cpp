#include "arcway/datasets/curved_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "arcway/angle.h"
#include "datasets/generators/layout.h"

namespace arcway {

using namespace internal;
namespace {

constexpr double kTightestBend = 2.0;  // radius where a pond bends outwards [m]

std::vector<Vec2> draw(Random& random, double radius) {
  std::vector<Vec2> pond;
  const std::size_t points = 6 + random.below(5);
  for (std::size_t i = 0; i < points; ++i) {
    const double turn = (static_cast<double>(i) + random.uniform(0.0, 0.4)) / static_cast<double>(points);
    pond.push_back(radius * random.uniform(0.65, 1.0) * unit_vector_at(turn));
  }
  return pond;
}

// Smallest radius of curvature where the curve turns left, at samples.
double tightest_bend(const ClosedSpline& spline) {
  constexpr int kSamples = 32;
  double tightest = std::numeric_limits<double>::infinity();
  for (const CubicBezier& piece : spline.pieces()) {
    for (int i = 0; i < kSamples; ++i) {
      const double u = i / static_cast<double>(kSamples);
      const Vec2 d = piece.derivative(u);
      const double bend = cross(d, piece.second_derivative(u)), speed = d.norm();
      if (bend > 0.0) tightest = std::min(tightest, speed * speed * speed / bend);
    }
  }
  return tightest;
}

}  // namespace

CurvedWorld generate_curved_world(const CurvedWorldParameters& parameters) {
  constexpr double kGap = 3.0, kRoomAround = 14.0;  // between two ponds, round all of them
  if (parameters.curves < 1 || parameters.curves > 100'000) {
    throw std::invalid_argument("curved world: curves is " + std::to_string(parameters.curves) +
                                ", must be from 1 to 100000");
  }
  Random random(parameters.seed);
  std::vector<std::vector<Vec2>> ponds(parameters.curves);
  std::vector<double> radii;
  double area = 0.0;
  for (std::vector<Vec2>& pond : ponds) {
    const double radius = random.uniform(5.0, 14.0);
    do {
      pond = draw(random, radius);
    } while (tightest_bend(ClosedSpline(pond)) < kTightestBend);
    radii.push_back(1.15 * radius);  // between its points the curve swings out a little
    area += (radii.back() + 0.5 * kGap) * (radii.back() + 0.5 * kGap);
  }
  double side = std::sqrt(kPi * area / 0.5);
  std::optional<std::vector<Vec2>> centers;
  while (!(centers = detail::scatter_discs(random, radii, side, kGap))) side *= 1.1;

  CurvedWorld world;
  for (std::size_t i = 0; i < ponds.size(); ++i) {
    for (Vec2& p : ponds[i]) p += (*centers)[i] + Vec2(kRoomAround, kRoomAround);
    const ClosedSpline spline(ponds[i]);
    world.curves.push_back({i, 0, {spline.pieces().begin(), spline.pieces().end()}});
    world.polygons.emplace_back();
  }
  side += 2.0 * kRoomAround;
  world.bounds = detail::box_ring(0.0, 0.0, side, side);
  return world;
}

}  // namespace arcway
