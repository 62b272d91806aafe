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
constexpr double kPush = 1e4, kFree = 2e-4, kLeastShare = 1e-3;

}  // namespace

bool ChainSystem::begin(const Vehicle& vehicle, const ChainContacts::Bodies& bodies,
                        const ChainContacts::Around& around) {
  speeds = speeds_of(vehicle);
  tightest = SideRadii(vehicle);
  unit = bodies.body.length();
  place_speeds();
  find_bounds(chain, speeds, bounds);
  if (!contacts.find(chain, around, bodies)) return false;
  unknowns.number(chain, tightest.smaller());
  tensions.assign(chain.lines.size(), Vec2::Zero());
  return true;
}

// The fastest speeds, a little slower.
void ChainSystem::place_speeds() {
  const std::size_t n = chain.arcs.size();
  const double twice = 2.0 * speeds.acceleration;
  auto& u = squares_;
  u.assign(2 * n, 0.0);
  double square = chain.entry;
  for (std::size_t i = 0; i < n; ++i) {
    const double limit = speeds.of(chain.arcs[i].radius);
    u[2 * i] = std::min(square + twice * chain.lines[i].length, limit);
    square = u[2 * i + 1] = std::min(u[2 * i] + twice * chain.turn(i) * chain.arcs[i].radius, limit);
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
  const auto part = [&](int number) { return share * part_of(step, number); };
  for (std::size_t i = 0; i < trial.arcs.size(); ++i) {
    const Numbers& at = unknowns.of_arc(i);
    ArcChain::Arc& arc = trial.arcs[i];
    arc.center += Vec2(part(at[kCenterX]), part(at[kCenterY]));
    arc.radius += part(at[kRadius]);
    arc.entry += part(at[kEntry]);
    arc.exit += part(at[kExit]);
    if (!(arc.radius > 0.0 && arc.entry > 0.0 && arc.exit > 0.0)) return false;
  }
  for (std::size_t i = 0; i < trial.lines.size(); ++i) {
    trial.lines[i].heading += part(unknowns.of_line(i)[kHeading]);
    trial.lines[i].length += part(unknowns.of_line(i)[kLength]);
  }
  return trial.join() && trial.is_forwards();
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
