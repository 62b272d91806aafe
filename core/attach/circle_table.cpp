#include "core/attach/circle_table.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

#include "arcway/executor.h"
#include "core/roadmap/finished_feasible_graph.h"

namespace arcway::internal {

CircleTable::CircleTable(const FeasibleGraph& graph) : graph_(graph), is_lazy_(!graph.finished()) {
  if (is_lazy_ || graph.finished()->links().size() > std::numeric_limits<std::uint32_t>::max()) return;
  links_ = graph.finished()->links();
  records_.reserve(graph.circles().size());
  sectors_.reserve(graph.circles().size());
  std::uint32_t first = 0;
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    const TurnCircle& circle = graph.circles()[c];
    const auto intervals = graph.free_headings(c).intervals();
    const auto links = static_cast<std::uint32_t>(graph.links_from(c).size());
    const HeadingInterval free = intervals.size() == 1 ? intervals[0] : HeadingInterval{0.0, 0.0};
    records_.push_back({circle.center, circle.radius, free, first, links, circle.side, intervals.size() == 1});
    first += links;
    Sectors sectors = 0;
    for (const HeadingInterval& interval : intervals) sectors |= sectors_of(interval.low, interval.high);
    sectors_.push_back(sectors);
  }
  has_one_radius_ =
      std::ranges::all_of(records_, [&](const Record& record) { return record.radius == records_[0].radius; });
}

bool CircleTable::find_links_to(const StopClock& clock) const {
  try {
    (void)incoming_.get(0, [&] { return std::make_unique<const Incoming>(find_incoming(clock)); });
    return true;
  } catch (const Canceled&) {
    return false;
  }
}

std::span<const CircleTable::LinkOf> CircleTable::links_to(std::uint32_t c) const {
  (void)find_links_to();
  const Incoming& incoming = *incoming_.find(0);
  return std::span(incoming.links).subspan(incoming.starts[c], incoming.starts[c + 1] - incoming.starts[c]);
}

CircleTable::Incoming CircleTable::find_incoming(const StopClock& clock) const {
  Incoming incoming;
  incoming.starts.assign(size() + 1, 0);
  StopTicker ticker(clock);
  for (std::uint32_t c = 0; c < size(); ++c) {
    end_if_over(ticker);
    for (const FeasibleGraph::Link& link : links_from(c, clock)) ++incoming.starts[link.to + 1];
  }
  std::partial_sum(incoming.starts.begin(), incoming.starts.end(), incoming.starts.begin());
  incoming.links.resize(incoming.starts.back());
  std::vector<std::uint64_t> next(incoming.starts.begin(), incoming.starts.end() - 1);
  for (std::uint32_t c = 0; c < size(); ++c) {
    end_if_over(ticker);
    for (std::uint32_t index = 0; const FeasibleGraph::Link& link : links_from(c))
      incoming.links[next[link.to]++] = {c, index++};
  }
  return incoming;
}

}  // namespace arcway::internal
