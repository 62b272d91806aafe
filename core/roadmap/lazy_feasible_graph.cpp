#include "core/roadmap/lazy_feasible_graph.h"

#include <atomic>
#include <utility>

#include "core/roadmap/found_before.h"

namespace arcway::internal {

LazyFeasibleGraph::LazyFeasibleGraph(const FeasibleGraphInputs& inputs, const Executor& executor)
    : LazyFeasibleGraph(std::make_shared<const CircleChecks>(inputs, executor)) {}

LazyFeasibleGraph::LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks)
    : LazyFeasibleGraph(std::move(checks), std::shared_ptr<const FeasibleGraph>()) {}

LazyFeasibleGraph::LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks,
                                     std::unique_ptr<const FoundBefore> found)
    : LazyFeasibleGraph(std::move(checks)) {
  found_ = std::move(found);
}

LazyFeasibleGraph::~LazyFeasibleGraph() = default;

LazyFeasibleGraph::LazyFeasibleGraph(std::shared_ptr<const CircleChecks> checks,
                                     std::shared_ptr<const FeasibleGraph> base)
    : FeasibleGraph(std::move(checks)),
      base_(std::move(base)),
      base_count_(base_ ? base_->circles().size() : 0),
      own_(std::make_shared<const FoundLinks>(circles().size())) {}

const HeadingSet& LazyFeasibleGraph::free_headings(std::uint32_t circle) const {
  if (circle < base_count_) return base_->free_headings(circle);
  return own_->headings.get(circle, [&] {
    const HeadingSet* known = found_ ? found_->headings(circle) : nullptr;
    return std::make_unique<const HeadingSet>(known ? *known : checks().free_headings(circle));
  });
}

const FoundLinks::Row& LazyFeasibleGraph::row_of(std::uint32_t circle, const StopClock& clock) const {
  return own_->rows.get(circle, [&] {
    if (std::optional<CheckedRow> known = found_ ? found_->row(circle) : std::nullopt)
      return std::make_unique<const FoundLinks::Row>(*std::move(known));
    Box around;
    LinkRow row = checks().departures(circle, free_headings(circle), clock, &around);
    return std::make_unique<const FoundLinks::Row>(std::move(row), around);
  });
}

std::span<const FeasibleGraph::Link> LazyFeasibleGraph::links_from(std::uint32_t circle, const StopClock& clock) const {
  return row_of(circle, clock).row.links;
}

bool LazyFeasibleGraph::is_kept(std::uint32_t circle, std::size_t index) const {
  const FoundLinks::Row& row = row_of(circle);
  std::atomic<LinkVerdict>& verdict = row.verdicts[index];
  if (const LinkVerdict known = verdict.load(std::memory_order_relaxed); known != LinkVerdict::kUnknown)
    return known == LinkVerdict::kKept;
  const Link& link = row.row.links[index];
  LinkVerdict found = LinkVerdict::kKept;
  if (!free_headings(link.to).contains(link.heading)) {
    found = LinkVerdict::kArrival;
  } else if (!checks().is_free(link)) {
    found = LinkVerdict::kStraight;
  }
  verdict.store(found, std::memory_order_relaxed);
  return found == LinkVerdict::kKept;
}

FeasibleGraphCounts LazyFeasibleGraph::counts() const {
  FeasibleGraphCounts sum;
  const TurnCircles& all = turn_circles();
  sum.circles = all.used_count();
  own_->headings.visit([&](std::size_t c, const HeadingSet& set) {
    sum.circles_blocked += set.empty() && all.is_used(static_cast<std::uint32_t>(c)) ? 1 : 0;
  });
  own_->rows.visit([&](std::size_t, const FoundLinks::Row& row) {
    add_counts(row.row.counts, sum);
    for (const std::atomic<LinkVerdict>& verdict : row.verdicts) {
      const LinkVerdict known = verdict.load(std::memory_order_relaxed);
      sum.kept += known == LinkVerdict::kKept ? 1 : 0;
      sum.rejected_arrival += known == LinkVerdict::kArrival ? 1 : 0;
      sum.rejected_straight += known == LinkVerdict::kStraight ? 1 : 0;
    }
  });
  return sum;
}

const HeadingSet* LazyFeasibleGraph::known_headings(std::uint32_t circle) const {
  if (circle < base_count_) return base_->known_headings(circle);
  const HeadingSet* known = own_->headings.find(circle);
  return known || !found_ ? known : found_->headings(circle);
}

std::optional<CheckedRow> LazyFeasibleGraph::known_row(std::uint32_t circle) const {
  const FoundLinks::Row* row = own_->rows.find(circle);
  if (!row) return found_ ? found_->row(circle) : std::nullopt;
  return row->checked();
}

void LazyFeasibleGraph::learn_headings(std::uint32_t circle, HeadingSet headings) {
  (void)own_->headings.get(circle, [&] { return std::make_unique<const HeadingSet>(std::move(headings)); });
}

void LazyFeasibleGraph::learn_row(std::uint32_t circle, CheckedRow row) {
  (void)own_->rows.get(circle, [&] { return std::make_unique<const FoundLinks::Row>(std::move(row)); });
}

}  // namespace arcway::internal
