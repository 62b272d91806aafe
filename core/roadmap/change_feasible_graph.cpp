#include "core/roadmap/change_feasible_graph.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/near_boxes.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/circle_change.h"
#include "core/roadmap/find_circle_rows.h"

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

// What a lazy graph before a change knows of circles that stay, and where it still holds.
class FoundKnowledge {
 public:
  FoundKnowledge(const FeasibleGraph& before, const FeasibleGraphInputs& inputs, const CircleChecks& after,
                 const WorldChange& change, std::span<const VertexId> may_differ)
      : before_(before),
        after_(after),
        map_(change),
        places_(places_of(change, largest_reach(inputs))),
        differing_(boxes_of(after.world(), may_differ)),
        circle_after_(before.circles().size()) {
    for (std::uint32_t was = 0; was < circle_after_.size(); ++was) circle_after_[was] = find_after(was);
  }

  // The index of a circle after the change; kNone if it is gone.
  [[nodiscard]] std::uint32_t after(std::uint32_t was) const { return circle_after_[was]; }

  // Headings that were found; null if there are none, or they may be others.
  [[nodiscard]] const HeadingSet* headings(std::uint32_t was) const {
    const HeadingSet* known = before_.known_headings(was);
    if (!known) return nullptr;
    const Vec2& vertex = before_.checks().world().vertex(before_.circles()[was].vertex);
    return places_.may_meet(Box{vertex, vertex}) ? nullptr : known;
  }

  // A row that was found, of a circle that is `now`.
  [[nodiscard]] std::optional<CheckedRow> row(std::uint32_t was, std::uint32_t now) const {
    std::optional<CheckedRow> known = before_.known_row(was);
    if (!known || known->around.empty() || places_.may_meet(known->around) || differing_.may_meet(known->around))
      return std::nullopt;
    for (FeasibleLink& link : known->row.links) {
      link.from = now;
      link.to = after(link.to);
    }
    return known;
  }

 private:
  [[nodiscard]] std::uint32_t find_after(std::uint32_t was) const {
    const TurnCircle& old = before_.circles()[was];
    const VertexId v = map_.after(old.vertex);
    if (v == kNone || !after_.circles().has(v)) return kNone;
    if (old.second == kNone)
      return after_.circles().first_around(v, Side::kLeft) + was -
             before_.turn_circles().first_around(old.vertex, Side::kLeft);
    const VertexId second = map_.after(old.second);
    std::uint32_t found = kNone;
    if (second == kNone) return found;
    after_.circles().visit_around(v, old.side, [&](std::uint32_t c) {
      const TurnCircle& circle = after_.circles().all()[c];
      if (circle.vertex == v && circle.second == second && circle.radius == old.radius) found = c;
    });
    return found;
  }
  // No less than how far a body reaches from a vertex of a circle on that circle.
  static double largest_reach(const FeasibleGraphInputs& inputs) {
    const Footprint grown_body = inputs.vehicle.footprint(inputs.vehicle.safety_margin());
    double largest = 0.0;
    for (const Side side : {Side::kLeft, Side::kRight})
      for (const double radius : inputs.radii.of(side))
        largest = std::max(largest, 2.0 * swept_annulus(grown_body, side, radius).outer);
    return largest;
  }
  static NearBoxes places_of(const WorldChange& change, double reach) {
    std::vector<Box> boxes = change.removed_boxes;
    boxes.insert(boxes.end(), change.added_boxes.begin(), change.added_boxes.end());
    return NearBoxes(boxes, reach);
  }
  static NearBoxes boxes_of(const World& world, std::span<const VertexId> vertices) {
    std::vector<Box> boxes;
    boxes.reserve(vertices.size());
    for (const VertexId v : vertices) boxes.push_back({world.vertex(v), world.vertex(v)});
    return NearBoxes(boxes);
  }

  const FeasibleGraph& before_;
  const CircleChecks& after_;
  VertexMap map_;
  NearBoxes places_;     // where obstacles were added or removed
  NearBoxes differing_;  // vertices that may have other neighbors
  std::vector<std::uint32_t> circle_after_;
};

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

std::shared_ptr<const LazyFeasibleGraph> change_lazy_feasible_graph(const FeasibleGraph& before,
                                                                    const FeasibleGraphInputs& after,
                                                                    const WorldChange& change,
                                                                    std::span<const VertexId> may_differ,
                                                                    const Executor& executor) {
  const VertexMap map(change);
  auto checks = std::make_shared<const CircleChecks>(before.checks(), map, after, may_differ);
  const FoundKnowledge found(before, after, *checks, change, may_differ);
  auto lazy = std::make_shared<LazyFeasibleGraph>(checks);
  executor.begin_stage("changes");
  executor.for_ranges(before.circles().size(), kChangedAtOnce, [&](std::size_t begin, std::size_t end) {
    for (auto was = static_cast<std::uint32_t>(begin); was < end; ++was) {
      const HeadingSet* free = found.headings(was);
      const std::uint32_t now = free ? found.after(was) : kNone;
      if (now == kNone) continue;
      lazy->learn_headings(now, *free);
      if (std::optional<CheckedRow> row = found.row(was, now)) lazy->learn_row(now, std::move(*row));
    }
  });
  return lazy;
}

}  // namespace arcway::internal
