#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/feasible_graph_snapshot.h"

namespace arcway::internal {

/// Links that leave one circle, by heading, then `to`; and why other candidates are none of them.
struct LinkRow {
  std::vector<FeasibleLink> links;
  LinkCounts counts;
};

/// Rows of links in compressed form.
struct LinkRows {
  std::vector<FeasibleLink> links;       ///< by row
  std::vector<std::uint64_t> starts{0};  ///< rows + 1, into `links`
  std::vector<LinkCounts> counts;        ///< by row

  void append(std::span<const FeasibleLink> row, const LinkCounts& counts_of_row);
  [[nodiscard]] std::span<const FeasibleLink> of(std::uint32_t row) const {
    return std::span(links).subspan(starts[row], starts[row + 1] - starts[row]);
  }
};

/// The rows one behind the other.
[[nodiscard]] LinkRows compressed(std::span<const LinkRow> rows);

/// Adds the counts of one row to those of a graph, all but `kept`.
void add_counts(const LinkCounts& row, FeasibleGraphCounts& sum);

}  // namespace arcway::internal
