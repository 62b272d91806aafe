#include "core/roadmap/restore_feasible_graph.h"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arcway/snapshot.h"
#include "core/roadmap/require_snapshot.h"

namespace arcway::internal {

namespace {

std::vector<HeadingSet> headings_of(const FeasibleGraphSnapshot& snapshot) {
  std::vector<HeadingSet> headings(snapshot.interval_starts.size() - 1);
  for (std::size_t c = 0; c < headings.size(); ++c) {
    const std::uint64_t begin = snapshot.interval_starts[c];
    const auto row = std::span(snapshot.intervals).subspan(begin, snapshot.interval_starts[c + 1] - begin);
    try {
      headings[c] = HeadingSet::of_intervals({row.begin(), row.end()});
    } catch (const std::invalid_argument& error) {
      throw SnapshotError(SnapshotArray::kIntervals, begin, "of circle " + std::to_string(c) + ": " + error.what());
    }
  }
  return headings;
}

}  // namespace

std::shared_ptr<const FinishedFeasibleGraph> restore_feasible_graph(const FeasibleGraphInputs& inputs,
                                                                    FeasibleGraphSnapshot snapshot) {
  auto checks = std::make_shared<const CircleChecks>(inputs, SerialExecutor());
  require_snapshot(snapshot, checks->circles().all().size());
  std::vector<HeadingSet> headings = headings_of(snapshot);
  LinkRows rows{std::move(snapshot.links), std::move(snapshot.link_starts), std::move(snapshot.link_counts)};
  return std::make_shared<const FinishedFeasibleGraph>(std::move(checks), std::move(headings), std::move(rows));
}

}  // namespace arcway::internal
