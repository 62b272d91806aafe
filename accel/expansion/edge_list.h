#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "arcway/executor.h"
#include "arcway/visibility_graph.h"

namespace arcway::internal {

/// Edges of a visibility graph by their ends, in any order.
using EdgeList = std::vector<std::pair<VertexId, VertexId>>;

/// The graph with the edges of all lists, which may be in any order and direction.
inline VisibilityGraph graph_of(std::size_t vertices, const std::vector<EdgeList>& lists, const Executor& executor) {
  constexpr std::size_t kRowsPerRange = 1024;
  // The offset of each row. It advances while the row is filled, and ends up as the start of the next row.
  std::vector<std::uint64_t> starts(vertices + 2, 0);
  const auto place_of = [&](const auto& edge) { return &starts[std::min(edge.first, edge.second) + 1]; };
  for (const EdgeList& list : lists)
    for (const auto& edge : list) ++place_of(edge)[1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<VertexId> targets(starts.back());
  for (const EdgeList& list : lists)
    for (const auto& edge : list) targets[(*place_of(edge))++] = std::max(edge.first, edge.second);
  starts.pop_back();
  executor.for_ranges(vertices, kRowsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t u = begin; u < end; ++u) std::sort(targets.begin() + starts[u], targets.begin() + starts[u + 1]);
  });
  return {std::move(starts), std::move(targets)};
}

}  // namespace arcway::internal
