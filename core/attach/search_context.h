#pragma once

#include <span>

#include "arcway/executor.h"
#include "arcway/sweep_query.h"
#include "core/attach/attachment_links.h"
#include "core/attach/circle_table.h"
#include "core/attach/roadmap.h"
#include "core/attach/search_options.h"

namespace arcway::internal {

/// What all parts of one search share.
class SearchContext {
 public:
  SearchContext(const Roadmap& m, std::span<const Attachment> s, std::span<const Attachment> g, const SearchOptions& o,
                SearchResult& r)
      : map(m),
        graph(*m.graph),
        vehicle(o.gear == Gear::kForward ? m.vehicle : m.vehicle.with_gears_swapped()),
        starts(s),
        goals(g),
        options(o),
        goal((g[0].connection.empty() ? g[0].pose : g[0].connection.back().end()).position()),
        result(r) {}

  bool interrupted() {
    result.interrupted = result.interrupted || options.interrupted();
    return result.interrupted;
  }

  /// The links that leave a circle. None, and the search is interrupted, if the clock is over before a lazy graph has
  /// found them.
  std::span<const FeasibleGraph::Link> links_from(std::uint32_t circle) {
    try {
      return map.circles->links_from(circle, options.clock);
    } catch (const Canceled&) {
      result.interrupted = true;
      return {};
    }
  }

  bool is_free(const Bitangent& line) {
    ++result.counts.straights_checked;
    return map.queries.sweep->straight_free({line.start, line.length, map.body});
  }

  const Roadmap& map;
  const FeasibleGraph& graph;
  const Vehicle vehicle;  ///< with the speeds of the gear in which the path is driven
  std::span<const Attachment> starts;
  std::span<const Attachment> goals;
  const SearchOptions& options;
  const Vec2 goal;  ///< position where all paths end [m]
  SearchResult& result;
};

}  // namespace arcway::internal
