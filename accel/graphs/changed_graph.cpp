#include "accel/graphs/changed_graph.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

#include "accel/expansion/change_visibility.h"
#include "accel/expansion/contact_edges.h"
#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/opened_triangulation.h"
#include "accel/expansion/tangent_cone_expansion.h"
#include "core/geometry/near_boxes.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kNodesPerRange = 16;

// Marks vertices of the new world whose rows are to be recomputed.
std::vector<std::uint8_t> find_stale(const VisibilityGraph& graph, const World& after, const WorldChange& change,
                                     const FreeSpaceTriangulation& triangulation) {
  std::vector<std::uint8_t> stale(after.vertices().size(), 0);
  for (const World::VertexRange& range : change.added_vertices)
    std::fill(stale.begin() + range.first, stale.begin() + range.last, std::uint8_t{1});
  const VertexMap map(change);
  const NearBoxes added(change.added_boxes);
  if (!added.empty()) {
    for (VertexId u = 0; u < graph.vertex_count(); ++u) {
      const VertexId from = map.after(u);
      if (from == kNone) continue;
      for (const VertexId v : graph.row(u)) {
        const VertexId to = map.after(v);
        if (to == kNone || (stale[from] && stale[to]) || !added.may_meet(after.vertex(from), after.vertex(to)))
          continue;
        stale[from] = stale[to] = 1;
      }
    }
  }
  if (!change.removed_boxes.empty()) {
    const OpenedTriangulation triangles(triangulation);
    ChangeVisibility viewers(triangles);
    viewers.mark_viewers(change.removed_boxes);
    for (const std::uint32_t n : viewers.viewers().all()) stale[triangulation.nodes()[n].vertex] = 1;
  }
  return stale;
}

}  // namespace

VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor,
                                                std::size_t* rows) {
  if (graph.vertex_count() != change.vertices_before ||
      (!change.added_vertices.empty() && change.added_vertices.back().last > after.vertices().size()))
    throw std::invalid_argument("change of a reduced visibility graph: it has " + std::to_string(graph.vertex_count()) +
                                " vertices, the change is one from " + std::to_string(change.vertices_before) + " to " +
                                std::to_string(after.vertices().size()));
  FreeSpaceTriangulation triangulation(after, executor);
  triangulation.list_left_edges();
  const std::vector<std::uint8_t> stale = find_stale(graph, after, change, triangulation);
  const VertexMap map(change);
  std::vector<EdgeList> lists(1);
  for (VertexId u = 0; u < graph.vertex_count(); ++u) {
    const VertexId from = map.after(u);
    if (from == kNone || stale[from]) continue;
    for (const VertexId v : graph.row(u)) {
      const VertexId to = map.after(v);
      if (to != kNone && !stale[to]) lists[0].emplace_back(from, to);
    }
  }
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t n = 0; n < triangulation.nodes().size(); ++n)
    if (stale[triangulation.nodes()[n].vertex]) nodes.push_back(n);
  if (rows) *rows = nodes.size();
  std::mutex mutex;
  executor.begin_stage("lines of sight");
  executor.for_ranges(nodes.size(), kNodesPerRange, [&](std::size_t begin, std::size_t end) {
    TangentConeExpansion expansion(triangulation);
    for (std::size_t i = begin; i < end; ++i) expansion.expand_all(nodes[i]);
    EdgeList edges = expansion.take_edges();
    // An edge between two stale rows is found from both ends and kept from the lower one.
    std::erase_if(edges, [&](const auto& edge) { return stale[edge.second] && edge.second < edge.first; });
    const std::scoped_lock lock(mutex);
    lists.push_back(std::move(edges));
  });
  add_missing(edges_through_contacts(after, triangulation), lists);
  return graph_of(after.vertices().size(), lists, executor);
}

}  // namespace arcway::internal
