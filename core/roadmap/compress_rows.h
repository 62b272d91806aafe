#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "arcway/visibility_graph.h"

namespace arcway::internal {

/// By vertex: its neighbors above it, ascending.
using Rows = std::vector<std::vector<VertexId>>;

/// The graph with these rows. O(edges).
inline VisibilityGraph compress(const Rows& rows) {
  std::vector<std::uint64_t> starts(rows.size() + 1, 0);
  for (std::size_t u = 0; u < rows.size(); ++u) starts[u + 1] = starts[u] + rows[u].size();
  std::vector<VertexId> targets;
  targets.reserve(starts.back());
  for (const auto& row : rows) targets.insert(targets.end(), row.begin(), row.end());
  return {std::move(starts), std::move(targets)};
}

}  // namespace arcway::internal
