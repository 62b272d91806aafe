#include "accel/wedge/changed_graph.h"

#include <algorithm>
#include <mutex>

#include "accel/wedge/edge_list.h"
#include "accel/wedge/shadow_walk.h"
#include "accel/wedge/sight_map.h"
#include "accel/wedge/wedge_walk.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/predicates.h"

namespace arcway {

namespace {

constexpr std::size_t kNodesPerRange = 16;

Box box_of(const Vec2& a, const Vec2& b) {
  Box box;
  box.extend(a);
  box.extend(b);
  return box;
}

// Whether a segment whose box meets another one may meet that.
bool may_meet(const Vec2& a, const Vec2& b, const Box& box) {
  int sum = 0;
  for (const Vec2& corner : {box.min, Vec2(box.max.x(), box.min.y()), box.max, Vec2(box.min.x(), box.max.y())})
    sum += orientation(a, b, corner);
  return sum > -4 && sum < 4;
}

// Vertices whose rows are to be walked again, by vertex of the world after.
std::vector<std::uint8_t> find_stale(const VisibilityGraph& graph, const World& after, const WorldChange& change,
                                     const SightMap& map) {
  std::vector<std::uint8_t> stale(after.vertices().size(), 0);
  std::fill(stale.begin() + change.first_come, stale.begin() + change.end_come, std::uint8_t{1});
  const BoxTree come(change.come), gone(change.gone);
  const auto meets_come = [&](const Vec2& a, const Vec2& b) {
    return !come.visit_overlaps(box_of(a, b), [&](std::uint32_t i) { return !may_meet(a, b, change.come[i]); });
  };
  if (come.size() > 0) {
    for (VertexId u = 0; u < graph.vertex_count(); ++u) {
      const VertexId from = change.moved[u];
      if (from == kNone) continue;
      for (const VertexId v : graph.row(u)) {
        const VertexId to = change.moved[v];
        if (to == kNone || (stale[from] && stale[to]) || !meets_come(after.vertex(from), after.vertex(to))) continue;
        stale[from] = stale[to] = 1;
      }
    }
  }
  if (gone.size() > 0) {
    ShadowWalk shadows(map);
    for (const Box& place : change.gone) shadows.look_from(place);
    for (std::size_t n = 0; n < map.nodes().size(); ++n)
      if (shadows.seen()[n]) stale[map.nodes()[n].vertex] = 1;
  }
  return stale;
}

}  // namespace

WorldChange::WorldChange(const World& before, const World& after, std::span<const ObstacleId> removed) {
  moved.assign(before.vertices().size(), kNone);
  const auto move_region = [&](ObstacleId old, ObstacleId now) {
    const VertexId to = after.vertices_of(now).first;
    const auto [first, last] = before.vertices_of(old);
    for (VertexId v = first; v < last; ++v) moved[v] = v - first + to;
  };
  ObstacleId now = 0;
  for (ObstacleId o = 0; o < before.obstacle_count(); ++o) {
    if (std::binary_search(removed.begin(), removed.end(), o)) {
      gone.push_back(before.box_of(o));
    } else {
      move_region(o, now++);
    }
  }
  const auto obstacles = static_cast<ObstacleId>(after.obstacle_count());
  first_come =
      now < after.region_count() ? after.vertices_of(now).first : static_cast<VertexId>(after.vertices().size());
  for (; now < obstacles; ++now) come.push_back(after.box_of(now));
  end_come = after.has_bounds() ? after.vertices_of(obstacles).first : static_cast<VertexId>(after.vertices().size());
  if (before.has_bounds()) move_region(static_cast<ObstacleId>(before.obstacle_count()), obstacles);
}

VisibilityGraph change_reduced_visibility_graph(const VisibilityGraph& graph, const World& after,
                                                const WorldChange& change, const Executor& executor,
                                                std::size_t* rows) {
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
  return graph_of(after.vertices().size(), lists);
}

}  // namespace arcway
