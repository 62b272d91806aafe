#include "core/roadmap/change_feasible_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/model/vertex_map.h"
#include "core/roadmap/circle_change.h"
#include "core/roadmap/find_circle_rows.h"
#include "core/roadmap/found_before.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kChangedAtOnce = 64;  // number of circles that a thread takes at once
// What the graph before a change knows of circles that stay, by their indices after it.
class KeptKnowledge {
 public:
  KeptKnowledge(const FeasibleGraph& before, const FeasibleGraphInputs& inputs, const CircleChecks& after,
                const WorldChange& change)
      : before_(before),
        after_(after),
        change_({before.checks().world(), before.checks().rows(), before.turn_circles()},
                {after.world(), after.rows(), after.circles()}, change,
                inputs.vehicle.footprint(inputs.vehicle.safety_margin()), Destinations::kMostSteps) {}

  // The free headings of a circle; null if they have to be found.
  [[nodiscard]] const HeadingSet* headings(std::uint32_t circle) const {
    const std::uint32_t was = change_.before(circle);
    const bool stay = was != kNone && change_.is_unchanged_at(after_.circles().all()[circle].vertex);
    return stay ? before_.known_headings(was) : nullptr;
  }

  // The row of a circle; nothing if it has to be found.
  [[nodiscard]] std::optional<CheckedRow> row(std::uint32_t circle) const {
    if (!keeps_row(circle)) return std::nullopt;
    std::optional<CheckedRow> row = before_.known_row(change_.before(circle));
    if (!row) return std::nullopt;
    for (FeasibleLink& link : row->row.links) {
      link.from = circle;
      link.to = change_.after(link.to);
    }
    return row;
  }

 private:
  // Whether links lead from a circle to the same vertices as before, and are as free as before.
  [[nodiscard]] bool keeps_row(std::uint32_t circle) const;

  const FeasibleGraph& before_;
  const CircleChecks& after_;
  CircleChange change_;
};

bool KeptKnowledge::keeps_row(std::uint32_t c) const {
  const TurnCircle& circle = after_.circles().all()[c];
  if (change_.before(c) == kNone || !change_.keeps_row(circle.vertex)) return false;
  if (circle.second != kNone && !change_.keeps_row(circle.second)) return false;
  for (const VertexId u : {circle.vertex, circle.second})
    if (const VertexId before = u == kNone ? kNone : after_.destinations().vertex_before(u, circle.side);
        before != kNone && !change_.keeps_row(before))
      return false;
  if (circle.second == kNone && change_.is_unchanged_around(circle.vertex)) return true;
  return std::ranges::all_of(after_.destinations().from(circle), [&](const Destinations::Arrival& arrival) {
    return change_.keeps_row(arrival.vertex) && change_.is_unchanged_between(circle.vertex, arrival.vertex);
  });
}

// The kept links of a row of which each link is decided; nothing if one is not.
std::optional<LinkRow> kept_links(const CheckedRow& known) {
  LinkRow kept{{}, known.row.counts};
  for (std::size_t i = 0; i < known.verdicts.size(); ++i) {
    switch (known.verdicts[i]) {
      case LinkVerdict::kUnknown:
        return std::nullopt;
      case LinkVerdict::kKept:
        kept.links.push_back(known.row.links[i]);
        break;
      case LinkVerdict::kArrival:
        ++kept.counts.arrivals;
        break;
      case LinkVerdict::kStraight:
        ++kept.counts.straights;
        break;
    }
  }
  return kept;
}

std::vector<std::uint32_t> those_without(std::span<const std::uint8_t> known) {
  std::vector<std::uint32_t> unknown;
  for (std::uint32_t c = 0; c < known.size(); ++c)
    if (!known[c]) unknown.push_back(c);
  return unknown;
}

}  // namespace

std::shared_ptr<const FinishedFeasibleGraph> change_feasible_graph(const FeasibleGraph& before,
                                                                   const FeasibleGraphInputs& after,
                                                                   const WorldChange& change,
                                                                   const Executor& executor) {
  auto checks = std::make_shared<const CircleChecks>(after, executor);
  const KeptKnowledge kept(before, after, *checks, change);
  const std::size_t count = checks->circles().all().size();
  std::vector<HeadingSet> headings(count);
  std::vector<LinkRow> rows(count);
  std::vector<std::uint8_t> known_headings(count), known_rows(count);  // by circle
  executor.begin_stage("changes");
  executor.for_ranges(count, kChangedAtOnce, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      if (const HeadingSet* free = kept.headings(c)) {
        headings[c] = *free;
        known_headings[c] = 1;
      }
      const std::optional<CheckedRow> known = kept.row(c);
      if (std::optional<LinkRow> row = known ? kept_links(*known) : std::nullopt) {
        rows[c] = std::move(*row);
        known_rows[c] = 1;
      }
    }
  });

  find_headings(*checks, those_without(known_headings), executor, headings);
  const std::vector<std::uint32_t> unknown = those_without(known_rows);
  std::vector<LinkRow> found = find_kept_links(*checks, headings, unknown, executor);
  for (std::size_t i = 0; i < unknown.size(); ++i) rows[unknown[i]] = std::move(found[i]);
  return std::make_shared<const FinishedFeasibleGraph>(std::move(checks), std::move(headings), compressed(rows));
}

std::shared_ptr<const LazyFeasibleGraph> change_lazy_feasible_graph(const FeasibleGraph& before,
                                                                    const FeasibleGraphInputs& after,
                                                                    const WorldChange& change,
                                                                    const Executor& executor) {
  auto checks = std::make_shared<const CircleChecks>(after, executor);
  const KeptKnowledge kept(before, after, *checks, change);
  auto lazy = std::make_shared<LazyFeasibleGraph>(checks);
  executor.begin_stage("changes");
  executor.for_ranges(lazy->circles().size(), kChangedAtOnce, [&](std::size_t begin, std::size_t end) {
    for (auto c = static_cast<std::uint32_t>(begin); c < end; ++c) {
      if (const HeadingSet* free = kept.headings(c)) lazy->learn_headings(c, *free);
      if (std::optional<CheckedRow> row = kept.row(c)) lazy->learn_row(c, std::move(*row));
    }
  });
  return lazy;
}

std::shared_ptr<const LazyFeasibleGraph> change_lazy_feasible_graph(const LazyFeasibleGraph& before,
                                                                    const FeasibleGraphInputs& after,
                                                                    const WorldChange& change,
                                                                    std::span<const VertexId> may_differ) {
  auto checks = std::make_shared<const CircleChecks>(before.checks(), VertexMap(change), after, may_differ);
  auto found = std::make_unique<const FoundBefore>(before, after, *checks, change, may_differ);
  return std::make_shared<const LazyFeasibleGraph>(std::move(checks), std::move(found));
}

}  // namespace arcway::internal
