#include "core/roadmap/link_rows.h"

#include <cstddef>

namespace arcway::internal {

void LinkRows::append(std::span<const FeasibleLink> row, const LinkCounts& counts_of_row) {
  links.insert(links.end(), row.begin(), row.end());
  starts.push_back(links.size());
  counts.push_back(counts_of_row);
}

LinkRows compressed(std::span<const LinkRow> rows) {
  std::size_t links = 0;
  for (const LinkRow& row : rows) links += row.links.size();
  LinkRows all;
  all.links.reserve(links);
  all.starts.reserve(rows.size() + 1);
  all.counts.reserve(rows.size());
  for (const LinkRow& row : rows) all.append(row.links, row.counts);
  return all;
}

void add_counts(const LinkCounts& row, FeasibleGraphCounts& sum) {
  sum.candidates += row.candidates;
  sum.repeated += row.repeated;
  sum.rejected_overlap += row.overlaps;
  sum.rejected_departure += row.departures;
  sum.rejected_arrival += row.arrivals;
  sum.rejected_straight += row.straights;
}

}  // namespace arcway::internal
