#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/roadmap/feasible_graph.h"

namespace [[gnu::visibility("default")]] arcway {

/// Bitangents that leave one circle, and why they are out; FeasibleGraphCounts adds them up.
struct LinkCounts {
  std::uint32_t candidates = 0;
  std::uint32_t repeated = 0;
  std::uint32_t overlaps = 0;
  std::uint32_t departures = 0;
  std::uint32_t arrivals = 0;
  std::uint32_t straights = 0;
};

/// All that an eager feasible graph has found out, in compressed rows, one a circle.
struct FeasibleTables {
  std::vector<std::uint64_t> interval_starts;  ///< circles + 1, into `intervals`
  std::vector<HeadingInterval> intervals;      ///< free headings
  std::vector<std::uint64_t> link_starts;      ///< circles + 1, into `links`
  std::vector<FeasibleGraph::Link> links;      ///< those kept, by heading, then `to`
  std::vector<LinkCounts> link_counts;         ///< by circle
};

/// Sizes and ranges; what headings and lengths are is taken as it comes.
/// @param circles  of the graph.  @throws TableError for the first entry that cannot be.
void require_tables(const FeasibleTables& known, std::size_t circles);

}  // namespace arcway
