#include "core/refine/chain_bounds.h"

namespace arcway::internal {

namespace {

BoundValue line_bound(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds) {
  const std::size_t i = bound.index;
  BoundValue result{chain.lines[i].length, Term::Gradient::Zero()};
  result.gradient[kLength] = 1.0;
  if (bound.limit == Limit::kLineLength) return result;
  const double share = (bound.limit == Limit::kLineSpeedUp ? -0.5 : 0.5) / speeds.acceleration;
  result.value += share * (exit_of_line(chain, i) - entry_of_line(chain, i));
  result.gradient[kExit] = share;
  result.gradient[kEntry] = -share;
  return result;
}

// The radius of an arc, or that of full speed, beyond the one that the square of a speed needs.
BoundValue speed_bound(const ArcChain::Arc& arc, bool is_slow, LocalNumber end, const ChainSpeeds& speeds) {
  const double square = end == kEntry ? arc.entry : arc.exit;
  BoundValue result{speeds.widest() - square / speeds.lateral, Term::Gradient::Zero()};
  if (is_slow) {
    const ChainSpeeds::Square limit = speeds.square(arc.radius);
    result.value =
        speeds.table.empty() ? arc.radius - square / speeds.lateral : (limit.value - square) / speeds.lateral;
    result.gradient[kRadius] = speeds.table.empty() ? 1.0 : limit.slope / speeds.lateral;
  }
  result.gradient[end] = -1.0 / speeds.lateral;
  return result;
}

}  // namespace

void find_bounds(const ArcChain& chain, const GearSpeeds& speeds, std::vector<Bound>& bounds) {
  bounds.clear();
  const auto n = static_cast<std::uint32_t>(chain.arcs.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool is_slow = chain.arcs[i].radius < speeds.in(chain.arcs[i].gear).widest();
    for (const Limit limit :
         {Limit::kTurn, Limit::kTightest, Limit::kWidest, Limit::kEntry, Limit::kExit, Limit::kSpeedUp, Limit::kBrake})
      bounds.push_back({limit, i, is_slow});
  }
  for (std::uint32_t i = 0; i <= n; ++i) {
    if (chain.lines[i].is_tied) continue;
    bounds.push_back({Limit::kLineLength, i, false});
    if (exit_of_line(chain, i) > 0.0) bounds.push_back({Limit::kLineSpeedUp, i, false});
    if (entry_of_line(chain, i) > 0.0) bounds.push_back({Limit::kLineBrake, i, false});
  }
}

BoundValue value_of(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds, const SideRadii& tightest) {
  if (bound.is_of_line()) return line_bound(bound, chain, speeds);
  const ArcChain::Arc& arc = chain.arcs[bound.index];
  const double turn = chain.turn(bound.index);
  BoundValue result{0.0, Term::Gradient::Zero()};
  auto& [value, g] = result;
  switch (bound.limit) {
    case Limit::kTurn:
      value = turn;
      g[kHeading] = -arc.turning();
      g[kNextHeading] = arc.turning();
      return result;
    case Limit::kTightest:
      value = arc.radius - tightest.on(arc.sign);
      g[kRadius] = 1.0;
      return result;
    case Limit::kWidest:
      g[kRadius] = bound.is_slow ? -1.0 : 1.0;
      value = g[kRadius] * (arc.radius - speeds.widest());
      return result;
    case Limit::kEntry:
      return speed_bound(arc, bound.is_slow, kEntry, speeds);
    case Limit::kExit:
      return speed_bound(arc, bound.is_slow, kExit, speeds);
    default:
      break;
  }
  const double share = (bound.limit == Limit::kSpeedUp ? -0.5 : 0.5) / speeds.acceleration;
  value = arc.radius * turn + share * (arc.exit - arc.entry);
  g[kRadius] = turn;
  g[kHeading] = -arc.turning() * arc.radius;
  g[kNextHeading] = arc.turning() * arc.radius;
  g[kExit] = share;
  g[kEntry] = -share;
  return result;
}

double speed_curvature(const Bound& bound, const ArcChain& chain, const ChainSpeeds& speeds) {
  if (!bound.is_slow) return 0.0;
  return speeds.square(chain.arcs[bound.index].radius).curvature / speeds.lateral;
}

Term::Hessian length_curvature(const ArcChain& chain, std::size_t arc) {
  Term term;
  term.curve(kRadius, kHeading, -chain.arcs[arc].turning());
  term.curve(kRadius, kNextHeading, chain.arcs[arc].turning());
  return term.hessian;
}

}  // namespace arcway::internal
