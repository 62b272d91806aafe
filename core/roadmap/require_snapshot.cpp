#include "core/roadmap/require_snapshot.h"

#include <cmath>
#include <span>
#include <string>

#include "arcway/angle.h"
#include "arcway/snapshot.h"
#include "core/base/shortest_text.h"

namespace arcway::internal {

void require_snapshot(const FeasibleGraphSnapshot& known, std::size_t circles) {
  const auto require_starts = [&](SnapshotArray array, std::span<const std::uint64_t> starts, std::size_t count) {
    if (starts.size() != circles + 1)
      throw SnapshotError(array, starts.size(), "at the end, there are " + std::to_string(circles) + " circles");
    for (std::size_t c = 0; c < starts.size(); ++c) {
      const std::uint64_t before = c == 0 ? 0 : starts[c - 1];
      const bool is_end = c == 0 || c + 1 == starts.size();
      const std::uint64_t wanted = c == 0 ? 0 : count;
      if (starts[c] < before || starts[c] > count || (is_end && starts[c] != wanted))
        throw SnapshotError(array, c,
                            std::to_string(starts[c]) + " follows " + std::to_string(before) +
                                ", they must rise from 0 to " + std::to_string(count));
    }
  };
  require_starts(SnapshotArray::kIntervalStarts, known.interval_starts, known.intervals.size());
  require_starts(SnapshotArray::kLinkStarts, known.link_starts, known.links.size());
  if (known.link_counts.size() != circles)
    throw SnapshotError(SnapshotArray::kLinkCounts, known.link_counts.size(),
                        "at the end, there are " + std::to_string(circles) + " circles");
  for (std::uint32_t c = 0; c < circles; ++c) {
    for (std::uint64_t i = known.link_starts[c]; i < known.link_starts[c + 1]; ++i) {
      const FeasibleLink& link = known.links[i];
      if (link.from != c || link.to >= circles)
        throw SnapshotError(SnapshotArray::kLinks, i,
                            "from circle " + std::to_string(link.from) + " to " + std::to_string(link.to) + " in row " +
                                std::to_string(c) + " of " + std::to_string(circles));
      const double least = i == known.link_starts[c] ? 0.0 : known.links[i - 1].heading;
      if (!(link.heading >= least && link.heading < kTwoPi) || !(link.length >= 0.0 && std::isfinite(link.length)))
        throw SnapshotError(SnapshotArray::kLinks, i,
                            "heading " + shortest_text(link.heading) + " and length " + shortest_text(link.length) +
                                ", headings rise from 0 to 2 pi and lengths are finite");
    }
  }
}

}  // namespace arcway::internal
