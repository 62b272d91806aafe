#include "core/refine/chain_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

constexpr double kBelowLimits = 0.9;  // of the fastest speeds' squares: all limits are kept strictly

// Pushing: steps at most, weight of an overlap against that of a movement, and how free contacts become, in lengths of
// the body.
constexpr int kMostPushes = 8;
// Gaps that count as none, in lengths of the body, and how much smaller a step must make them. Closings from the start.
constexpr double kClosed = 1e-11, kLessOpen = 0.5;
constexpr double kRounding = 1e-15;  // of coordinates
constexpr int kMostClosings = 8;
// At the end, radii and lines that are larger than the least ones by no more than this are those [body lengths], and
// turns [rad]; by rounding.
constexpr double kNoRoom = 1e-4, kNoArc = 1e-4, kRoundedTurn = 1e-12;
constexpr double kHold = 1e10;  // weight of what keeps its value
constexpr double kPush = 1e4, kFree = 2e-4, kLeastShare = 1e-3;

}  // namespace

bool ChainSystem::begin(const Vehicle& vehicle, const ChainContacts::Bodies& bodies,
                        const ChainContacts::Around& around) {
  speeds = {speeds_of(vehicle), speeds_of(vehicle, Gear::kReverse)};
  tightest = SideRadii(vehicle);
  unit = bodies.body.length();
  closed_ = kClosed * unit + kRounding * (chain.start.position().norm() + chain.goal.position().norm());
  place_speeds();
  find_bounds(chain, speeds, bounds);
  unknowns.number(chain, tightest.smaller());
  if ((!chain.is_joined && !close()) || !contacts.find(chain, around, bodies)) return false;
  tensions.assign(chain.lines.size(), Vec2::Zero());
  return true;
}

// The fastest speeds, a little slower.
void ChainSystem::place_speeds() {
  const std::size_t n = chain.arcs.size();
  const double twice = 2.0 * speeds.forwards.acceleration;
  auto& u = squares_;
  u.assign(2 * n, 0.0);
  double square = chain.entry;
  for (std::size_t i = 0; i < n; ++i) {
    const ArcChain::Arc& arc = chain.arcs[i];
    const double limit = speeds.in(arc.gear).of(arc.radius);
    u[2 * i] = chain.stops_before(i) ? 0.0 : std::min(square + twice * chain.lines[i].length, limit);
    u[2 * i + 1] = chain.stops_behind(i) ? 0.0 : std::min(u[2 * i] + twice * chain.turn(i) * arc.radius, limit);
    square = u[2 * i + 1];
  }
  square = chain.exit;
  for (std::size_t i = n; i-- > 0;) {
    u[2 * i + 1] = std::min(u[2 * i + 1], square + twice * chain.lines[i + 1].length);
    square = u[2 * i] = std::min(u[2 * i], u[2 * i + 1] + twice * chain.turn(i) * chain.arcs[i].radius);
  }
  for (std::size_t i = 1; i < n; ++i)
    if (chain.lines[i].is_tied) u[2 * i - 1] = u[2 * i] = std::min(u[2 * i - 1], u[2 * i]);
  for (std::size_t i = 0; i < n; ++i) {
    chain.arcs[i].entry = kBelowLimits * u[2 * i];
    chain.arcs[i].exit = kBelowLimits * u[2 * i + 1];
  }
}

bool ChainSystem::move(double share) {
  trial = chain;
  move_by(step, share, trial);
  for (std::size_t i = 0; i < trial.arcs.size(); ++i) {
    const Numbers& at = unknowns.of_arc(i);
    const ArcChain::Arc& arc = trial.arcs[i];
    const auto is_fast = [](double square, int number) { return number == kGiven || square > 0.0; };
    if (!(arc.radius > 0.0 && is_fast(arc.entry, at[kEntry]) && is_fast(arc.exit, at[kExit]))) return false;
  }
  return (trial.is_joined ? trial.join() : close_by_factors(trial)) && trial.is_drivable();
}

void ChainSystem::move_by(std::span<const double> by, double share, ArcChain& to) const {
  const auto part = [&](int number) { return share * part_of(by, number); };
  for (std::size_t i = 0; i < to.arcs.size(); ++i) {
    const Numbers& at = unknowns.of_arc(i);
    ArcChain::Arc& arc = to.arcs[i];
    arc.center += Vec2(part(at[kCenterX]), part(at[kCenterY]));
    arc.radius += part(at[kRadius]);
    arc.entry += part(at[kEntry]);
    arc.exit += part(at[kExit]);
  }
  for (std::size_t i = 0; i < to.lines.size(); ++i) {
    to.lines[i].heading += part(unknowns.of_line(i)[kHeading]);
    to.lines[i].length += part(unknowns.of_line(i)[kLength]);
  }
}

bool ChainSystem::close() { return close_but_for({}) && chain.is_drivable(); }

bool ChainSystem::close_but_for(std::span<const Held> held) {
  for (ArcChain::Line& line : chain.lines) line.ahead = direction_of(line.heading);
  tensions.assign(chain.lines.size(), Vec2::Zero());
  for (int i = 0; i < kMostClosings; ++i) {
    matrix.reset(unknowns.size());
    unknowns.add_equations(chain, tensions, kStiffness, matrix);
    for (const auto& [number, other] : held) {
      const auto at = static_cast<std::size_t>(number);
      const double weight = kHold * unknowns.inverse_squares()[at];
      matrix.add(at, at, weight);
      if (other == kGiven) continue;
      matrix.add(static_cast<std::size_t>(other), static_cast<std::size_t>(other), weight);
      matrix.add(at, static_cast<std::size_t>(other), -weight);
    }
    if (!matrix.factorize(unknowns.inverse_squares(), 1.0, unknowns.equations())) return false;
    if (close_by_factors(chain)) return true;
  }
  return false;
}

bool ChainSystem::settle() {
  held_.clear();
  const double least = kNoRoom * unit;
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    if (chain.arcs[i].radius < tightest.on(chain.arcs[i].sign) + least)
      held_.push_back({unknowns.of_arc(i)[kRadius], kGiven});
    if (chain.turn(i) < kNoArc) hold_turn(i);
  }
  for (std::size_t i = 0; i < chain.lines.size(); ++i)
    if (!chain.lines[i].is_tied && chain.lines[i].length < least)
      held_.push_back({unknowns.of_line(i)[kLength], kGiven});
  put_on_limits(least, kNoArc);
  if (!close_but_for(held_)) return false;
  put_on_limits(closed_, kRoundedTurn);
  for (std::size_t i = 0; i < chain.arcs.size(); ++i)
    if (chain.turn(i) < 0.0 || chain.arcs[i].radius < tightest.on(chain.arcs[i].sign)) return false;
  return std::ranges::all_of(chain.lines, [](const ArcChain::Line& line) { return line.length >= 0.0; });
}

void ChainSystem::hold_turn(std::size_t arc) {
  const int begin = unknowns.of_arc(arc)[kHeading], end = unknowns.of_arc(arc)[kNextHeading];
  if (begin != kGiven) {
    held_.push_back({begin, end});
  } else if (end != kGiven) {
    held_.push_back({end, kGiven});
  }
}

// Radii, lengths and turns that are the least ones but for this become these.
void ChainSystem::put_on_limits(double least, double least_turn) {
  for (ArcChain::Arc& arc : chain.arcs) {
    const double smallest = tightest.on(arc.sign);
    if (std::abs(arc.radius - smallest) < least) arc.radius = smallest;
  }
  for (ArcChain::Line& line : chain.lines)
    if (std::abs(line.length) < least) line.length = 0.0;
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    if (!(std::abs(chain.turn(i)) < least_turn)) continue;
    double &begin = chain.lines[i].heading, &end = chain.lines[i + 1].heading;
    if (unknowns.of_arc(i)[kNextHeading] != kGiven) {
      end = begin;
    } else if (unknowns.of_arc(i)[kHeading] != kGiven) {
      begin = end;
    }
  }
}

// Each step is that of the matrix if nothing but the gaps is to change.
bool ChainSystem::close_by_factors(ArcChain& open) {
  double most_before = kInfinity;
  while (true) {
    for (ArcChain::Line& line : open.lines) line.ahead = direction_of(line.heading);
    closing_.assign(unknowns.size(), 0.0);
    double most = 0.0;
    for (std::size_t i = 0; i < open.lines.size(); ++i) {
      const Vec2 gap = open.gap(i);
      unknowns.set_tension(i, -gap, closing_);
      most = std::max(most, gap.norm());
    }
    if (most <= closed_) return true;
    if (!(most < kLessOpen * most_before)) return false;
    most_before = most;
    matrix.solve(closing_);
    move_by(closing_, 1.0, open);
  }
}

double ChainSystem::movement() const {
  double most = 0.0;
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    // Where the headings at the arc's ends, weighted so, are its own.
    const auto place = [i](const ArcChain& of, double entry, double exit) -> Vec2 {
      const Vec2 ahead = (entry * of.lines[i].ahead + exit * of.lines[i + 1].ahead).normalized();
      return of.arcs[i].center - of.arcs[i].sign * of.arcs[i].radius * perpendicular(ahead);
    };
    const double turned = std::abs(trial.lines[i].heading - chain.lines[i].heading);
    for (const auto& [entry, exit] : {std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
      most = std::max(most, (place(trial, entry, exit) - place(chain, entry, exit)).norm() + unit * turned);
  }
  return most;
}

void resolve_overlaps(ChainSystem& system, const StopClock& clock) {
  const double wanted = kFree * system.unit;
  system.tensions.assign(system.chain.lines.size(), Vec2::Zero());
  for (int pushes = 0; pushes < kMostPushes && (pushes == 0 || !clock.is_over()); ++pushes) {
    system.matrix.reset(system.unknowns.size());
    system.right.assign(system.unknowns.size(), 0.0);
    double least = kInfinity;
    const auto push = [&](double value, const Numbers& numbers, const Term::Gradient& gradient) {
      least = std::min(least, value);
      if (value >= wanted) return;
      add(numbers, gradient * gradient.transpose(), kPush, system.matrix);
      add(numbers, gradient, kPush * (wanted - value), system.right);
    };
    for (const Bound& bound : system.bounds) {
      if (bound.limit != Limit::kTightest) continue;
      const auto [value, gradient] = system.value(bound, system.chain);
      push(value, system.numbers_of(bound), gradient);
    }
    for (std::size_t i = 0; i < system.contacts.size(); ++i) {
      const ChainContacts::Place place = system.contacts.look_around(system.chain, i);
      if (place.distance < wanted)
        push(place.distance, system.numbers_at(place), system.contacts.term(system.chain, i, place).gradient);
    }
    if (least >= 0.0) return;
    system.unknowns.add_equations(system.chain, system.tensions, ChainSystem::kStiffness, system.matrix);
    system.step = system.right;
    if (!system.matrix.factorize(system.unknowns.inverse_squares(), 1.0, system.unknowns.equations())) return;
    system.matrix.solve(system.step);
    double share = 1.0;
    while (share > kLeastShare && !system.move(share)) share *= 0.5;
    if (!(share > kLeastShare)) return;
    std::swap(system.chain, system.trial);
  }
}

}  // namespace arcway::internal
