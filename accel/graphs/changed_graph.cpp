#include "accel/graphs/changed_graph.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

#include "accel/expansion/change_visibility.h"
#include "accel/expansion/contact_edges.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/sight_map.h"
#include "accel/expansion/wedge_walk.h"
#include "core/geometry/near_boxes.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kNodesPerRange = 16;

// Vertices whose rows are to be walked again, by vertex of the world after.
std::vector<std::uint8_t> find_stale(const VisibilityGraph& graph, const World& after, const WorldChange& change,
                                     const SightMap& map) {
  std::vector<std::uint8_t> stale(after.vertices().size(), 0);
  std::fill(stale.begin() + change.first_come, stale.begin() + change.end_come, std::uint8_t{1});
  const NearBoxes come(change.come);
  if (!come.empty()) {
    for (VertexId u = 0; u < graph.vertex_count(); ++u) {
      const VertexId from = change.moved[u];
      if (from == kNone) continue;
      for (const VertexId v : graph.row(u)) {
        const VertexId to = change.moved[v];
        if (to == kNone || (stale[from] && stale[to]) || !come.may_meet(after.vertex(from), after.vertex(to))) continue;
        stale[from] = stale[to] = 1;
      }
    }
  }
  if (!change.gone.empty()) {
    ChangeVisibility shadows(map);
    shadows.look_from(change.gone);
    for (std::size_t n = 0; n < map.nodes().size(); ++n)
      if (shadows.seen()[n]) stale[map.nodes()[n].vertex] = 1;
  }
  return stale;
}

}  // namespace

VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor,
                                                std::size_t* rows) {
  if (graph.vertex_count() != change.moved.size() || change.end_come > after.vertices().size())
    throw std::invalid_argument("change of a reduced visibility graph: it has " + std::to_string(graph.vertex_count()) +
                                " vertices, the change is one from " + std::to_string(change.moved.size()) + " to " +
                                std::to_string(after.vertices().size()));
  SightMap map(after, executor);
  map.list_left_edges();
  const std::vector<std::uint8_t> stale = find_stale(graph, after, change, map);
  std::vector<EdgeList> lists(1);
  for (VertexId u = 0; u < graph.vertex_count(); ++u) {
    const VertexId from = change.moved[u];
    if (from == kNone || stale[from]) continue;
    for (const VertexId v : graph.row(u)) {
      const VertexId to = change.moved[v];
      if (to != kNone && !stale[to]) lists[0].emplace_back(from, to);
    }
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n < map.nodes().size(); ++n)
    if (stale[map.nodes()[n].vertex]) nodes.push_back(n);
  if (rows) *rows = nodes.size();
  std::mutex mutex;
  executor.begin_stage("lines of sight");
  executor.for_ranges(nodes.size(), kNodesPerRange, [&](std::size_t begin, std::size_t end) {
    WedgeWalk walk(map);
    for (std::size_t i = begin; i < end; ++i) walk.look_around(nodes[i]);
    EdgeList edges = walk.take_edges();
    // What two stale rows have in common is found from both.
    std::erase_if(edges, [&](const auto& edge) { return stale[edge.second] && edge.second < edge.first; });
    const std::scoped_lock lock(mutex);
    lists.push_back(std::move(edges));
  });
  add_missing(edges_through_contacts(after, map), lists);
  return graph_of(after.vertices().size(), lists, executor);
}

}  // namespace arcway::internal
