#include "core/roadmap/exchange_circle_rows.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/bytes.h"

namespace arcway::internal {

void exchange_headings(std::span<HeadingSet> headings, const ProcessGroup& process_group) {
  const auto own = process_group.share_of(headings.size());
  std::string bytes;
  for (std::size_t c = own.begin; c < own.end; ++c) {
    append_bytes(bytes, static_cast<std::uint32_t>(headings[c].intervals().size()));
    append_bytes(bytes, headings[c].intervals());
  }
  const std::vector<std::string> all = process_group.gather(std::move(bytes));
  for (std::size_t rank = 0; rank < process_group.size(); ++rank) {
    if (rank == process_group.rank()) continue;
    const auto [begin, end] = process_group.share_of(headings.size(), rank);
    std::string_view rest = all[rank];
    for (std::size_t c = begin; c < end; ++c) {
      const auto size = take_bytes<std::uint32_t>(rest);
      headings[c] = HeadingSet::of_intervals(take_bytes<HeadingInterval>(rest, size));
    }
  }
}

LinkRows exchange_links(std::span<const LinkRow> share, const ProcessGroup& process_group) {
  std::string bytes;
  for (const LinkRow& row : share) {
    append_bytes(bytes, static_cast<std::uint32_t>(row.links.size()));
    append_bytes(bytes, row.counts);
    append_bytes(bytes, std::span<const FeasibleLink>(row.links));
  }
  LinkRows rows;
  for (std::string_view rest : process_group.gather(std::move(bytes))) {
    while (!rest.empty()) {
      const auto size = take_bytes<std::uint32_t>(rest);
      const auto counts = take_bytes<LinkCounts>(rest);
      rows.append(take_bytes<FeasibleLink>(rest, size), counts);
    }
  }
  return rows;
}

}  // namespace arcway::internal
