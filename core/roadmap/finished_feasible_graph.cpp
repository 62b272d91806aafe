#include "core/roadmap/finished_feasible_graph.h"

#include <algorithm>
#include <utility>

namespace arcway::internal {

FinishedFeasibleGraph::FinishedFeasibleGraph(std::shared_ptr<const CircleChecks> checks,
                                             std::vector<HeadingSet> headings, LinkRows rows)
    : FeasibleGraph(std::move(checks)), headings_(std::move(headings)), rows_(std::move(rows)) {
  counts_.circles = turn_circles().used_count();
  counts_.circles_blocked =
      static_cast<std::uint64_t>(std::ranges::count_if(headings_, [](const HeadingSet& set) { return set.empty(); })) -
      (circles().size() - counts_.circles);
  for (const LinkCounts& row : rows_.counts) add_counts(row, counts_);
  counts_.kept = rows_.links.size();
}

std::optional<CheckedRow> FinishedFeasibleGraph::known_row(std::uint32_t circle) const {
  const std::span<const Link> links = rows_.of(circle);
  return CheckedRow{{{links.begin(), links.end()}, rows_.counts[circle]},
                    std::vector<LinkVerdict>(links.size(), LinkVerdict::kKept),
                    {}};
}

FeasibleGraphSnapshot FinishedFeasibleGraph::snapshot() const {
  FeasibleGraphSnapshot flat;
  flat.interval_starts.push_back(0);
  for (const HeadingSet& set : headings_) {
    flat.intervals.insert(flat.intervals.end(), set.intervals().begin(), set.intervals().end());
    flat.interval_starts.push_back(flat.intervals.size());
  }
  flat.link_starts = rows_.starts;
  flat.links = rows_.links;
  flat.link_counts = rows_.counts;
  return flat;
}

}  // namespace arcway::internal
