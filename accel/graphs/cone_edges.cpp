#include "accel/graphs/cone_edges.h"

#include <algorithm>
#include <atomic>

#include "accel/expansion/tangent_cone_expansion.h"

namespace arcway::internal {

namespace {

// Nodes per list of edges. Short lists, because a growing list is held in memory twice.
constexpr std::size_t kNodesPerList = 256;

}  // namespace

std::vector<EdgeList> cone_edges(const ExpansionInput& input, NodeRange nodes, const Executor& executor,
                                 ExpansionCounts* counts) {
  const auto [first, last] = nodes;
  std::vector<EdgeList> lists((last - first + kNodesPerList - 1) / kNodesPerList);
  std::atomic<std::uint64_t> steps = 0, candidates = 0;
  executor.for_ranges(lists.size(), 1, [&, first = first, last = last](std::size_t begin, std::size_t end) {
    TangentConeExpansion expansion(input.triangulation, &input.sleeves, &input.fans);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t behind = std::min(last, first + (i + 1) * kNodesPerList);
      for (std::size_t node = first + i * kNodesPerList; node < behind; ++node)
        expansion.expand_right(static_cast<std::uint32_t>(node));
      lists[i] = expansion.take_edges();
    }
    steps += expansion.steps();
    candidates += expansion.candidates();
  });
  if (counts) *counts = {steps, candidates};
  return lists;
}

}  // namespace arcway::internal
