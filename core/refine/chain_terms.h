#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>

#include "arcway/vehicle.h"
#include "core/refine/arc_chain.h"

namespace arcway::internal {

/// The numbers that a term of one arc or of one line depends on, as indices into the following.
///   Of an arc: its center and radius, the headings at its beginning and end, the squares of the speeds there.
///   Of a line: center and radius of the circle before it, its heading and length, the squares of the speeds at its
///   ends. The circle before the first line is the start, with radius 0.
enum LocalNumber { kCenterX, kCenterY, kRadius, kHeading, kNextHeading, kEntry, kExit, kLocalNumbers };
inline constexpr int kLength = kNextHeading;  ///< of a line

/// A smooth function of the numbers of one arc or line, with its derivatives there.
struct Term {
  using Gradient = Eigen::Matrix<double, kLocalNumbers, 1>;
  using Hessian = Eigen::Matrix<double, kLocalNumbers, kLocalNumbers>;

  double value = 0.0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  /// Sets a second derivative, and its mirror image.
  void curve(int a, int b, double second) { hessian(a, b) = hessian(b, a) = second; }
};

/// How fast the vehicle is on lines and in turns. Turns are driven by a lateral acceleration, or by a table.
struct ChainSpeeds {
  double acceleration;  ///< [m/s^2]
  double lateral;       ///< lateral acceleration of turns; with a table, on the radius of their top speed [m/s^2]
  double top;           ///< square of the top speed [m^2/s^2]
  double turn_top;      ///< square of the top speed in turns [m^2/s^2]
  /// Pairs (radius [m], speed [m/s]), linear in between. Both ascend up to the top speed or to the end. Empty: no
  /// table.
  std::span<const std::pair<double, double>> table = {};

  /// Radius from which on turns have their top speed [m].
  [[nodiscard]] double widest() const { return turn_top / lateral; }
  /// The square of the speed on a circle, with its first and second derivative by the radius.
  struct Square {
    double value, slope, curvature;
  };
  [[nodiscard]] Square square(double radius) const {
    if (!(radius < widest())) return {turn_top, 0.0, 0.0};
    if (table.empty()) return {lateral * radius, lateral, 0.0};
    return square_by_table(radius);
  }
  [[nodiscard]] double of(double radius) const { return square(radius).value; }

 private:
  [[nodiscard]] Square square_by_table(double radius) const;
};
/// Whether a vehicle drives turns by a lateral acceleration, or by a table that ascends up to the top speed or to its
/// end, and the tightest ones slower than lines.
bool has_chain_speeds(const Vehicle& vehicle);
/// Whether a vehicle drives all turns at one speed in each gear, or has such speeds.
bool has_gear_speeds(const Vehicle& vehicle);
/// The speeds of a vehicle that has them, in a gear. It must outlive the use.
ChainSpeeds speeds_of(const Vehicle& vehicle, Gear gear = Gear::kForward);

/// The speeds in both gears.
struct GearSpeeds {
  ChainSpeeds forwards{}, backwards{};
  /// In the gear of an arc or line.
  [[nodiscard]] const ChainSpeeds& in(double gear) const { return gear < 0.0 ? backwards : forwards; }
};

/// The time through an arc or a line [s], between the speeds at its ends, which need not be as high as they may. It is
/// smooth where the top speed is just reached. Speeds at start and goal are given and do not count as numbers.
Term arc_time(const ArcChain& chain, std::size_t arc, const ChainSpeeds& speeds);
Term line_time(const ArcChain& chain, std::size_t line, const ChainSpeeds& speeds);
/// Only the values of these times [s].
double arc_time_alone(const ArcChain& chain, std::size_t arc, const ChainSpeeds& speeds);
double line_time_alone(const ArcChain& chain, std::size_t line, const ChainSpeeds& speeds);

/// The squares of the speeds at the ends of a line: those of the arcs beside it, or of start and goal.
double entry_of_line(const ArcChain& chain, std::size_t line);
double exit_of_line(const ArcChain& chain, std::size_t line);

}  // namespace arcway::internal
