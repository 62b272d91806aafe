#include "core/search/pocket.h"

#include "core/geometry/angle.h"

namespace arcway {

bool leads_to(const FeasibleGraph& graph, double arrival, const Departure& departure) {
  const Side side = graph.circles()[departure.circle].side;
  const double reach = graph.free_headings(departure.circle).reach(arrival, side);
  return reach >= 0.0 && turn_between(arrival, departure.heading, side) <= reach;
}

std::optional<std::vector<Departure>> departures_towards(const FeasibleGraph& graph, std::vector<Departure> ends,
                                                         std::size_t most) {
  std::vector<bool> seen(graph.links().size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends.size() > most) return std::nullopt;
    const Departure end = ends[i];
    for (const std::uint32_t index : graph.links_to(end.circle)) {
      const FeasibleGraph::Link& link = graph.links()[index];
      if (seen[index] || !leads_to(graph, link.heading, end)) continue;
      seen[index] = true;
      ends.push_back({link.from, link.heading});
    }
  }
  return ends;
}

}  // namespace arcway
