#include "core/search/circle_table.h"

#include <algorithm>
#include <limits>

namespace arcway {

CircleTable::CircleTable(const FeasibleGraph& graph) : graph_(graph) {
  if (graph.mode() != GraphMode::kEager || graph.links().size() > std::numeric_limits<std::uint32_t>::max()) return;
  links_ = graph.links();
  records_.reserve(graph.circles().size());
  std::uint32_t first = 0;
  for (std::uint32_t c = 0; c < graph.circles().size(); ++c) {
    const TurnCircle& circle = graph.circles()[c];
    const auto intervals = graph.free_headings(c).intervals();
    const auto links = static_cast<std::uint32_t>(graph.links_from(c).size());
    const HeadingInterval free = intervals.size() == 1 ? intervals[0] : HeadingInterval{0.0, 0.0};
    records_.push_back({circle.center, circle.radius, free, first, links, circle.side, intervals.size() == 1});
    first += links;
  }
  has_one_radius_ =
      std::ranges::all_of(records_, [&](const Record& record) { return record.radius == records_[0].radius; });
}

}  // namespace arcway
