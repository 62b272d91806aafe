#include "core/roadmap/lazy_feasible_graph.h"

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
      headings_(circles().size()),
      rows_(circles().size()) {}

LazyFeasibleGraph::Row::Row(CheckedRow known) : Row(std::move(known.row), known.around) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i].store(known.verdicts[i], std::memory_order_relaxed);
}

const HeadingSet& LazyFeasibleGraph::free_headings(std::uint32_t circle) const {
  if (circle < base_count_) return base_->free_headings(circle);
  return headings_.get(circle, [&] {
    const HeadingSet* known = found_ ? found_->headings(circle) : nullptr;
    return std::make_unique<const HeadingSet>(known ? *known : checks().free_headings(circle));
  });
}

const LazyFeasibleGraph::Row& LazyFeasibleGraph::row_of(std::uint32_t circle, const StopClock& clock) const {
  return rows_.get(circle, [&] {
    if (std::optional<CheckedRow> known = found_ ? found_->row(circle) : std::nullopt)
      return std::make_unique<const Row>(*std::move(known));
    Box around;
    LinkRow row = checks().departures(circle, free_headings(circle), clock, &around);
    return std::make_unique<const Row>(std::move(row), around);
  });
}

std::span<const FeasibleGraph::Link> LazyFeasibleGraph::links_from(std::uint32_t circle, const StopClock& clock) const {
  return row_of(circle, clock).row.links;
}

bool LazyFeasibleGraph::is_kept(std::uint32_t circle, std::size_t index) const {
  const Row& row = row_of(circle);
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
  sum.circles = circles().size();
  for (std::uint32_t c = 0; c < circles().size(); ++c) {
    if (const HeadingSet* set = headings_.find(c); set && set->empty()) ++sum.circles_blocked;
    const Row* row = rows_.find(c);
    if (!row) continue;
    add_counts(row->row.counts, sum);
    for (const std::atomic<LinkVerdict>& verdict : row->verdicts) {
      const LinkVerdict known = verdict.load(std::memory_order_relaxed);
      sum.kept += known == LinkVerdict::kKept ? 1 : 0;
      sum.rejected_arrival += known == LinkVerdict::kArrival ? 1 : 0;
      sum.rejected_straight += known == LinkVerdict::kStraight ? 1 : 0;
    }
  }
  return sum;
}

const HeadingSet* LazyFeasibleGraph::known_headings(std::uint32_t circle) const {
  if (circle < base_count_) return base_->known_headings(circle);
  const HeadingSet* known = headings_.find(circle);
  return known || !found_ ? known : found_->headings(circle);
}

std::optional<CheckedRow> LazyFeasibleGraph::known_row(std::uint32_t circle) const {
  const Row* row = rows_.find(circle);
  if (!row) return found_ ? found_->row(circle) : std::nullopt;
  CheckedRow known{row->row, {}, row->around};
  known.verdicts.reserve(row->verdicts.size());
  for (const std::atomic<LinkVerdict>& verdict : row->verdicts)
    known.verdicts.push_back(verdict.load(std::memory_order_relaxed));
  return known;
}

std::size_t LazyFeasibleGraph::graphs_behind() const { return found_ ? found_->graphs() : 0; }

void LazyFeasibleGraph::learn_headings(std::uint32_t circle, HeadingSet headings) {
  (void)headings_.get(circle, [&] { return std::make_unique<const HeadingSet>(std::move(headings)); });
}

void LazyFeasibleGraph::learn_row(std::uint32_t circle, CheckedRow row) {
  (void)rows_.get(circle, [&] { return std::make_unique<const Row>(std::move(row)); });
}

}  // namespace arcway::internal
