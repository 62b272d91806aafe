#include "core/refine/chain_terms.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace arcway::internal {

namespace {

// A segment's length, the squares of the speeds at its beginning and end, and of its limit.
enum TimedNumber { kSegment, kFrom, kTo, kLimit, kTimedNumbers };
struct Timed {
  double value = 0.0;
  Eigen::Matrix<double, kTimedNumbers, 1> gradient = Eigen::Matrix<double, kTimedNumbers, 1>::Zero();
  Eigen::Matrix<double, kTimedNumbers, kTimedNumbers> hessian =
      Eigen::Matrix<double, kTimedNumbers, kTimedNumbers>::Zero();
};

double time_alone(double length, double from, double to, double limit, double a) {
  const double holding = length - (2.0 * limit - from - to) / (2.0 * a);
  const double peak = holding >= 0.0 ? limit : a * length + 0.5 * (from + to);
  const double time = (2.0 * std::sqrt(peak) - std::sqrt(from) - std::sqrt(to)) / a;
  return holding >= 0.0 ? time + holding / std::sqrt(limit) : time;
}

Timed time_of(double length, double from, double to, double limit, double a) {
  Timed t;
  auto& g = t.gradient;
  auto& h = t.hessian;
  const double holding = length - (2.0 * limit - from - to) / (2.0 * a);
  if (holding >= 0.0) {
    const double slowness = 1.0 / std::sqrt(limit), cube = slowness / limit;
    t.value = (2.0 * std::sqrt(limit) - std::sqrt(from) - std::sqrt(to)) / a + holding * slowness;
    g[kSegment] = slowness;
    g[kFrom] = g[kTo] = slowness / (2.0 * a);
    g[kLimit] = -0.5 * holding * cube;
    h(kSegment, kLimit) = -0.5 * cube;
    h(kFrom, kLimit) = h(kTo, kLimit) = -0.25 * cube / a;
    h(kLimit, kLimit) = 0.5 * cube / a + 0.75 * holding * cube / limit;
  } else {
    const double peak = a * length + 0.5 * (from + to);
    const double slowness = 1.0 / std::sqrt(peak);
    t.value = (2.0 * std::sqrt(peak) - std::sqrt(from) - std::sqrt(to)) / a;
    g[kSegment] = slowness;
    g[kFrom] = g[kTo] = slowness / (2.0 * a);
    const Eigen::Vector4d rise(a, 0.5, 0.5, 0.0);
    h = -0.5 * slowness / (peak * a) * rise * rise.transpose();
  }
  for (const auto& [number, square] : {std::pair(kFrom, from), std::pair(kTo, to)}) {
    if (!(square > 0.0)) continue;
    const double slowness = 1.0 / std::sqrt(square);
    g[number] -= slowness / (2.0 * a);
    h(number, number) += 0.25 * slowness / (square * a);
  }
  h.triangularView<Eigen::StrictlyLower>() = h.transpose();
  return t;
}

}  // namespace

ChainSpeeds::Square ChainSpeeds::square_by_table(double radius) const {
  const auto above = std::ranges::upper_bound(table, radius, {}, &std::pair<double, double>::first);
  if (above == table.begin()) return {above->second * above->second, 0.0, 0.0};
  const auto below = above - 1;
  const double slope = (above->second - below->second) / (above->first - below->first);
  const double speed = below->second + slope * (radius - below->first);
  return {speed * speed, 2.0 * speed * slope, 2.0 * slope * slope};
}

namespace {

// The radius from which on turns are as fast as a table lets them be, if it ascends until there; else 0.
double widest_by(const TurnSpeedTable& law, double top_speed) {
  const auto& entries = law.entries;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const auto& [from, slow] = entries[i - 1];
    const auto& [to, fast] = entries[i];
    if (!(fast > slow)) return 0.0;
    if (fast >= top_speed) return from + (to - from) * ((top_speed - slow) / (fast - slow));
  }
  return entries.size() > 1 ? entries.back().first : 0.0;
}

}  // namespace

bool has_chain_speeds(const Vehicle& vehicle) {
  const TurnSpeedLaw& law = vehicle.parameters().turn_speed;
  if (!(vehicle.turn_speed(vehicle.min_turning_radius()) < vehicle.max_speed())) return false;
  const auto* table = std::get_if<TurnSpeedTable>(&law);
  return table ? widest_by(*table, vehicle.max_speed()) > vehicle.min_turning_radius()
               : std::holds_alternative<LateralAccelerationLimit>(law);
}

bool has_gear_speeds(const Vehicle& vehicle) {
  return std::holds_alternative<ConstantTurnSpeed>(vehicle.parameters().turn_speed) || has_chain_speeds(vehicle);
}

ChainSpeeds speeds_of(const Vehicle& vehicle, Gear gear) {
  const double fastest = gear == Gear::kForward ? vehicle.max_speed() : vehicle.max_reverse_speed();
  const double top = fastest * fastest;
  const TurnSpeedLaw& law = vehicle.parameters().turn_speed;
  if (const auto* table = std::get_if<TurnSpeedTable>(&law)) {
    const auto& [tightest, slowest] = table->entries.front();
    const double widest = fastest > slowest ? widest_by(*table, fastest) : tightest;
    const double turn_top = std::min(vehicle.turn_speed(widest), fastest);
    return {vehicle.max_acceleration(), turn_top * turn_top / widest, top, turn_top * turn_top, table->entries};
  }
  if (const auto* constant = std::get_if<ConstantTurnSpeed>(&law)) {
    const double turn_top = std::min(constant->speed * constant->speed, top);
    return {vehicle.max_acceleration(), turn_top / vehicle.min_turning_radius(), top, turn_top};
  }
  return {vehicle.max_acceleration(), std::get<LateralAccelerationLimit>(law).lateral_acceleration, top, top};
}

double entry_of_line(const ArcChain& chain, std::size_t line) {
  return line > 0 ? chain.arcs[line - 1].exit : chain.entry;
}
double exit_of_line(const ArcChain& chain, std::size_t line) {
  return line < chain.arcs.size() ? chain.arcs[line].entry : chain.exit;
}

double arc_time_alone(const ArcChain& chain, std::size_t arc, const ChainSpeeds& speeds) {
  const ArcChain::Arc& a = chain.arcs[arc];
  return time_alone(a.radius * chain.turn(arc), a.entry, a.exit, speeds.of(a.radius), speeds.acceleration);
}

double line_time_alone(const ArcChain& chain, std::size_t line, const ChainSpeeds& speeds) {
  return time_alone(chain.lines[line].length, entry_of_line(chain, line), exit_of_line(chain, line), speeds.top,
                    speeds.acceleration);
}

Term arc_time(const ArcChain& chain, std::size_t arc, const ChainSpeeds& speeds) {
  const ArcChain::Arc& a = chain.arcs[arc];
  const double turn = chain.turn(arc);
  const ChainSpeeds::Square limit = speeds.square(a.radius);
  const Timed timed = time_of(a.radius * turn, a.entry, a.exit, limit.value, speeds.acceleration);
  Eigen::Matrix<double, kTimedNumbers, kLocalNumbers> map = Eigen::Matrix<double, kTimedNumbers, kLocalNumbers>::Zero();
  map(kSegment, kRadius) = turn;
  map(kSegment, kHeading) = -a.turning() * a.radius;
  map(kSegment, kNextHeading) = a.turning() * a.radius;
  map(kFrom, kEntry) = map(kTo, kExit) = 1.0;
  map(kLimit, kRadius) = limit.slope;
  Term term;
  term.value = timed.value;
  term.gradient.noalias() = map.transpose() * timed.gradient;
  term.hessian.noalias() = map.transpose() * timed.hessian * map;
  term.hessian(kRadius, kRadius) += timed.gradient[kLimit] * limit.curvature;
  const double by_length = a.turning() * timed.gradient[kSegment];
  term.hessian(kRadius, kNextHeading) += by_length;
  term.hessian(kNextHeading, kRadius) += by_length;
  term.hessian(kRadius, kHeading) -= by_length;
  term.hessian(kHeading, kRadius) -= by_length;
  return term;
}

Term line_time(const ArcChain& chain, std::size_t line, const ChainSpeeds& speeds) {
  const Timed timed = time_of(chain.lines[line].length, entry_of_line(chain, line), exit_of_line(chain, line),
                              speeds.top, speeds.acceleration);
  Term term;
  term.value = timed.value;
  constexpr int kNumbers[] = {kLength, kEntry, kExit};
  constexpr int kTimed[] = {kSegment, kFrom, kTo};
  for (int i = 0; i < 3; ++i) {
    term.gradient[kNumbers[i]] = timed.gradient[kTimed[i]];
    for (int k = 0; k < 3; ++k) term.hessian(kNumbers[i], kNumbers[k]) = timed.hessian(kTimed[i], kTimed[k]);
  }
  return term;
}

}  // namespace arcway::internal
