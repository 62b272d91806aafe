#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arcway/angle.h"
#include "arcway/stop_clock.h"
#include "core/attach/sectors.h"
#include "core/base/huge_pages.h"
#include "core/base/prefetch.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/slot_cache.h"

namespace arcway::internal {

/// A feasible graph as searches read it. Of a finished graph, all that a search asks about a circle lies in one cache
/// line, since searches on large maps mostly wait for memory. Questions about a lazy graph are passed on to it.
/// Immutable, thread-safe.
class CircleTable {
 public:
  /// @param graph  must outlive this.
  explicit CircleTable(const FeasibleGraph& graph);

  struct Circle {
    Vec2 center;
    double radius;
    Side side;
  };
  [[nodiscard]] Circle circle(std::uint32_t c) const {
    if (const Record* r = record(c)) return {r->center, r->radius, r->side};
    const TurnCircle& circle = graph_.circles()[c];
    return {circle.center, circle.radius, circle.side};
  }
  /// Whether all circles are known to have the same radius.
  [[nodiscard]] bool has_one_radius() const { return has_one_radius_; }
  /// See HeadingSet::reach, towards the circle's own side.
  [[nodiscard]] double reach(std::uint32_t c, double heading) const {
    if (const Record* r = record(c); r && r->has_one_interval) return reach_within(r->free, heading, r->side);
    return graph_.free_headings(c).reach(heading, graph_.circles()[c].side);
  }
  /// Whether a heading may be free, as far as is known without computing headings. False only if it is certainly
  /// blocked.
  /// @param heading  in [0, 2 pi), known up to `slack` [rad].
  [[nodiscard]] bool may_be_free(std::uint32_t c, double heading, double slack) const {
    const Record* r = record(c);
    if (!r || !r->has_one_interval) return true;
    const double ahead = heading - r->free.low + slack;  // of the interval's begin, up to whole turns
    const double width = r->free.high - r->free.low + 2.0 * slack;
    return (ahead >= 0.0 && ahead <= width) || ahead + kTwoPi <= width || ahead >= kTwoPi;
  }
  /// The sectors of headings that may be free, as far as is known without computing headings.
  [[nodiscard]] Sectors free_sectors(std::uint32_t c) const { return sectors_.empty() ? kAllSectors : sectors_[c]; }
  /// See FeasibleGraph::links_from.
  [[nodiscard]] std::span<const FeasibleGraph::Link> links_from(std::uint32_t c, const StopClock& clock = {}) const {
    if (const Record* r = record(c)) return links_.subspan(r->first_link, r->links);
    return graph_.links_from(c, clock);
  }
  /// See FeasibleGraph::is_kept.
  [[nodiscard]] bool is_kept(std::uint32_t c, std::uint32_t index) const { return graph_.is_kept(c, index); }
  /// One of the links that leave a circle: links_from(circle)[index].
  struct LinkOf {
    std::uint32_t circle, index;
  };
  /// Sorts all links by their destination, 8 bytes each, kept from then on. A lazy graph first finds all of its rows,
  /// without checking their links.
  /// @return false if the clock is over before that is done.
  [[nodiscard]] bool find_links_to(const StopClock& clock = {}) const;
  /// Whether find_links_to has succeeded before.
  [[nodiscard]] bool knows_links_to() const { return incoming_.find(0) != nullptr; }
  /// The links that lead to a circle, by the circle that they leave. Calls find_links_to first if need be.
  [[nodiscard]] std::span<const LinkOf> links_to(std::uint32_t c) const;
  [[nodiscard]] std::size_t size() const { return graph_.circles().size(); }
  [[nodiscard]] bool is_lazy() const { return is_lazy_; }
  /// Prefetches what is known about a circle.
  void prefetch(std::uint32_t c) const {
    if (const Record* r = record(c)) will_need(r);
  }
  /// Prefetches the links that leave a circle; best some time after `prefetch`.
  void prefetch_links(std::uint32_t c) const {
    if (const Record* r = record(c)) will_need(links_.data() + r->first_link);
  }

 private:
  struct alignas(64) Record {
    Vec2 center;
    double radius;
    HeadingInterval free;  // if there is just one interval
    std::uint32_t first_link, links;
    Side side;
    bool has_one_interval;
  };
  [[nodiscard]] const Record* record(std::uint32_t c) const { return records_.empty() ? nullptr : &records_[c]; }

  // Links by where they lead to.
  struct Incoming {
    std::vector<std::uint64_t> starts;
    std::vector<LinkOf> links;
  };
  [[nodiscard]] Incoming find_incoming(const StopClock& clock) const;

  const FeasibleGraph& graph_;
  bool is_lazy_;
  bool has_one_radius_ = false;
  std::span<const FeasibleGraph::Link> links_;
  HugeVector<Record> records_;    // none of a lazy graph
  std::vector<Sectors> sectors_;  // none of a lazy graph
  SlotCache<Incoming> incoming_{1};
};

}  // namespace arcway::internal
