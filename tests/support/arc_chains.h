#pragma once

#include <cstddef>
#include <cstdint>

#include "core/refine/arc_chain.h"
#include "core/refine/chain_terms.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal::test {

/// Gives the parts of a chain any gears. Where the vehicle then stops, speeds are 0.
inline void set_random_gears(RandomInputs& random, ArcChain& chain) {
  const auto any = [&random] { return random.unit() < 0.5 ? 1.0 : -1.0; };
  for (ArcChain::Arc& arc : chain.arcs) arc.gear = any();
  for (std::size_t i = 0; i < chain.lines.size(); ++i) {
    ArcChain::Line& line = chain.lines[i];
    line.gear = any();
    // At the end of a path the vehicle may stop between a line and an arc, or not.
    if (!line.is_tied) continue;
    line.gear = chain.arcs[i - 1].gear == chain.arcs[i].gear ? chain.arcs[i].gear : 0.0;
  }
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    if (chain.stops_before(i)) chain.arcs[i].entry = 0.0;
    if (chain.stops_behind(i)) chain.arcs[i].exit = 0.0;
  }
}

/// A chain as far as times and bounds depend on it, with any speeds: nothing is placed.
inline ArcChain random_arcs(RandomInputs& random, std::int64_t most, bool in_both_gears = false) {
  ArcChain chain;
  const auto arcs = random.integer(1, most);
  for (std::int64_t i = 0; i <= arcs; ++i) {
    const bool is_tied = i > 0 && i < arcs && random.unit() < 0.4;
    chain.lines.push_back({0.0, is_tied ? 0.0 : random.uniform(0.2, 9.0), is_tied});
    if (i == arcs) break;
    const double sign = random.unit() < 0.5 ? 1.0 : -1.0;
    chain.arcs.push_back(
        {random.point(-9.0, 9.0), random.uniform(1.3, 14.0), sign, random.uniform(0.5, 9.0), random.uniform(0.5, 9.0)});
  }
  if (in_both_gears) set_random_gears(random, chain);
  chain.lines.front().heading = random.uniform(-4.0, 4.0);
  for (std::size_t i = 0; i < chain.arcs.size(); ++i)
    chain.lines[i + 1].heading = chain.lines[i].heading + chain.arcs[i].turning() * random.uniform(0.05, 3.0);
  return chain;
}

/// A line or an arc.
struct ChainPart {
  bool is_line;
  std::size_t index;
};

/// A number, by LocalNumber, of a part; nothing where it is given.
inline double* number_of(ArcChain& chain, const ChainPart& part, int number) {
  const std::size_t i = part.index;
  ArcChain::Arc* const arc = !part.is_line ? &chain.arcs[i] : i > 0 ? &chain.arcs[i - 1] : nullptr;
  if (number <= kRadius) return arc == nullptr ? nullptr : number == kRadius ? &arc->radius : &arc->center[number];
  if (number == kHeading) return &chain.lines[i].heading;
  if (number == kNextHeading) return part.is_line ? &chain.lines[i].length : &chain.lines[i + 1].heading;
  // Where the vehicle stops, the speed is given.
  const auto exit = [&](std::size_t of) { return chain.stops_behind(of) ? nullptr : &chain.arcs[of].exit; };
  const auto entry = [&](std::size_t of) { return chain.stops_before(of) ? nullptr : &chain.arcs[of].entry; };
  if (!part.is_line) return number == kEntry ? entry(i) : exit(i);
  if (number == kEntry) return i > 0 ? exit(i - 1) : nullptr;
  return i < chain.arcs.size() ? entry(i) : nullptr;
}

/// How far the equation of a line is from 0, by its heading.
inline Vec2 residual_of(const ArcChain& chain, std::size_t line) {
  const Vec2 ahead = direction_of(chain.lines[line].heading);
  return chain.behind(line) - chain.before(line) - chain.lines[line].gear * chain.lines[line].length * ahead -
         chain.offset(line) * perpendicular(ahead);
}

/// Where the reference point is on an arc, at the heading of a line.
inline Vec2 place_on(const ArcChain& chain, std::size_t arc, std::size_t line) {
  const ArcChain::Arc& a = chain.arcs[arc];
  return a.center - a.sign * a.radius * perpendicular(direction_of(chain.lines[line].heading));
}

/// The arcs and lines as segments, without tied lines.
inline Path path_of(const ArcChain& chain) {
  Path path;
  for (std::size_t i = 0; i < chain.lines.size(); ++i) {
    const ArcChain::Line& line = chain.lines[i];
    const Vec2 begin = i > 0 ? place_on(chain, i - 1, i) : chain.start.position();
    const auto gear = [](double of) { return of < 0.0 ? Gear::kReverse : Gear::kForward; };
    if (!line.is_tied) path.push_back({{begin.x(), begin.y(), line.heading}, line.length, 0.0, gear(line.gear)});
    if (i == chain.arcs.size()) break;
    const ArcChain::Arc& arc = chain.arcs[i];
    const Vec2 entry = place_on(chain, i, i);
    path.push_back(
        {{entry.x(), entry.y(), line.heading}, arc.radius * chain.turn(i), arc.sign / arc.radius, gear(arc.gear)});
  }
  return path;
}

}  // namespace arcway::internal::test
