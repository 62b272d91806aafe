#include "core/search/backward_reachable_set.h"

#include <unordered_set>

#include "arcway/angle.h"

namespace arcway::internal {

bool leads_to(const CircleTable& circles, double arrival, const Departure& departure) {
  const double reach = circles.reach(departure.circle, arrival);
  return reach >= 0.0 && turn_between(arrival, departure.heading, circles.circle(departure.circle).side) <= reach;
}

std::optional<std::vector<Departure>> backward_reachable_set(const CircleTable& circles, std::vector<Departure> ends,
                                                             std::size_t most) {
  std::unordered_set<std::uint64_t> seen;  // links
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends.size() > most) return std::nullopt;
    const Departure end = ends[i];
    for (const CircleTable::LinkOf& at : circles.links_to(end.circle)) {
      const double heading = circles.links_from(at.circle)[at.index].heading;
      const std::uint64_t link = (std::uint64_t{at.circle} << 32) | at.index;
      if (seen.contains(link) || !leads_to(circles, heading, end) || !circles.is_kept(at.circle, at.index)) continue;
      seen.insert(link);
      ends.push_back({at.circle, heading});
    }
  }
  return ends;
}

}  // namespace arcway::internal
