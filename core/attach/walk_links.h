#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "arcway/angle.h"
#include "core/roadmap/feasible_graph.h"

namespace arcway::internal {

/// The index of the first link at or ahead of a heading, in the circle's turning direction. Precondition: `links` is
/// not empty.
inline std::size_t first_ahead(std::span<const FeasibleGraph::Link> links, double heading, Side side) {
  const bool left = side == Side::kLeft;
  const double from = wrap_positive(left ? heading - kNoTurn : heading + kNoTurn);
  const auto first = std::partition_point(links.begin(), links.end(), [&](const FeasibleGraph::Link& link) {
    return left ? link.heading < from : link.heading <= from;
  });
  const auto count = static_cast<std::size_t>(first - links.begin());
  if (left) return count < links.size() ? count : 0;
  return count > 0 ? count - 1 : links.size() - 1;
}

/// Calls visit(index, link, turn) for the links that leave a circle, in turning direction from a heading, until a call
/// returns false. `turn` is the angle from the heading [rad].
template <class Visitor>
void walk_links(std::span<const FeasibleGraph::Link> links, Side side, double heading, Visitor&& visit) {
  if (links.empty()) return;
  const std::size_t count = links.size();
  for (std::size_t step = 0, at = first_ahead(links, heading, side); step < count; ++step) {
    if (!visit(static_cast<std::uint32_t>(at), links[at], turn_between(heading, links[at].heading, side))) return;
    at = side == Side::kLeft ? (at + 1) % count : (at + count - 1) % count;
  }
}

}  // namespace arcway::internal
