#include "accel/wedge/wedge_graph.h"

#include <mutex>
#include <vector>

#include "accel/wedge/edge_list.h"
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
  std::vector<EdgeList> parts;
  WedgeStatistics sum;
  executor.begin_stage("lines of sight");
  executor.for_ranges(map.nodes().size(), kNodesPerRange, [&](std::size_t begin, std::size_t end) {
    WedgeWalk walk(map);
    for (std::size_t node = begin; node < end; ++node) walk.look_right(static_cast<std::uint32_t>(node));
    const std::scoped_lock lock(mutex);
    parts.push_back(walk.take_edges());
    sum.steps += walk.steps();
    sum.candidates += walk.candidates();
  });

  if (statistics) {
    sum.triangles = map.doors().size() / 3;
    sum.broken_regions = map.broken_count();
    *statistics = sum;
  }
  return graph_of(world.vertices().size(), parts);
}

}  // namespace arcway
