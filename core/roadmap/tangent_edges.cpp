#include "core/roadmap/tangent_edges.h"

#include <algorithm>
#include <span>
#include <vector>

#include "arcway/visibility_rows.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/compress_rows.h"

namespace arcway::internal {

bool is_tangent(const World& world, VertexId v, const Vec2& p) {
  const Vec2& at = world.vertex(v);
  if (at == p) return false;
  return orientation(p, at, world.vertex(world.previous(v))) * orientation(p, at, world.vertex(world.next(v))) >= 0;
}

Side obstacle_side(const World& world, VertexId v, const Vec2& from) {
  const Vec2& at = world.vertex(v);
  const int side =
      orientation(from, at, world.vertex(world.previous(v))) + orientation(from, at, world.vertex(world.next(v)));
  return side > 0 ? Side::kLeft : Side::kRight;
}

void keep_nearest(const World& world, VertexId u, std::vector<VertexId>& around) {
  const auto before = [&](VertexId v, VertexId w) {
    return precedes_about(world.vertex(u), world.vertex(v), world.vertex(w));
  };
  std::sort(around.begin(), around.end(), before);
  std::size_t kept = 0;
  for (std::size_t first = 0, last = 0; first < around.size(); first = last) {
    while (last < around.size() && !before(around[first], around[last])) ++last;
    // The edges to all but the nearest place are carried.
    const auto same_direction = std::span(around).subspan(first, last - first);
    const VertexId nearest = *std::ranges::min_element(same_direction, [&](VertexId v, VertexId w) {
      return on_open_segment(world.vertex(v), {world.vertex(u), world.vertex(w)});
    });
    for (const VertexId v : same_direction)
      if (world.vertex(v) == world.vertex(nearest)) around[kept++] = v;
  }
  around.resize(kept);
  std::sort(around.begin(), around.end());
}

VisibilityGraph without_carried_edges(const World& world, const VisibilityGraph& graph, const Executor& executor) {
  const auto rows = rows_of(world, graph);
  Rows kept(graph.vertex_count());
  executor.for_ranges(kept.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (auto u = static_cast<VertexId>(begin); u < end; ++u) {
      kept[u].assign(rows->of(u).begin(), rows->of(u).end());
      keep_nearest(world, u, kept[u]);
      std::erase_if(kept[u], [u](VertexId v) { return v < u; });
    }
  });
  return compress(kept);
}

}  // namespace arcway::internal
