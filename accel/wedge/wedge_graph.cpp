#include "accel/wedge/wedge_graph.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "accel/wedge/sight_map.h"
#include "accel/wedge/wedge_walk.h"

namespace arcway {

namespace {

constexpr std::size_t kNodesPerRange = 256;

}  // namespace

VisibilityGraph build_reduced_visibility_graph_by_wedges(const World& world, const Executor& executor,
                                                         WedgeStatistics* statistics) {
  const SightMap map(world, executor);
  std::mutex mutex;
  std::vector<std::vector<std::pair<VertexId, VertexId>>> parts;
  WedgeStatistics sum;
  executor.for_ranges(map.nodes().size(), kNodesPerRange, [&](std::size_t begin, std::size_t end) {
    WedgeWalk walk(map);
    for (std::size_t node = begin; node < end; ++node) walk.look_right(static_cast<std::uint32_t>(node));
    const std::scoped_lock lock(mutex);
    parts.push_back(walk.take_edges());
    sum.steps += walk.steps();
    sum.candidates += walk.candidates();
  });

  std::vector<std::uint64_t> starts(world.vertices().size() + 1, 0);
  for (const auto& part : parts)
    for (const auto& [u, v] : part) ++starts[std::min(u, v) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<VertexId> targets(starts.back());
  std::vector<std::uint64_t> place(starts.begin(), starts.end() - 1);
  for (const auto& part : parts)
    for (const auto& [u, v] : part) targets[place[std::min(u, v)]++] = std::max(u, v);
  for (std::size_t u = 0; u + 1 < starts.size(); ++u)
    std::sort(targets.begin() + starts[u], targets.begin() + starts[u + 1]);

  if (statistics) {
    sum.triangles = map.doors().size() / 3;
    sum.broken_regions = map.broken_count();
    *statistics = sum;
  }
  return {std::move(starts), std::move(targets)};
}

}  // namespace arcway
