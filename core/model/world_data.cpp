#include "core/model/world_data.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>

#include "core/geometry/predicates.h"
#include "core/geometry/ray_parity.h"

namespace arcway {

using namespace internal;

std::uint64_t World::Data::next_stamp() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void World::Data::add_region(const Polygon& polygon, std::span<const RingContact> ring_contacts, bool is_bounds,
                             Touches& touches) {
  const std::size_t first_ring = ring_starts.size();
  add_ring(polygon.outer, is_bounds ? -1 : 1);
  for (const Ring& hole : polygon.holes) add_ring(hole, -1);
  for (const RingContact& contact : ring_contacts) {
    const VertexId start = ring_starts[first_ring + contact.edge_ring] + static_cast<VertexId>(contact.edge);
    const Ring& ring = contact.edge_ring == 0 ? polygon.outer : polygon.holes[contact.edge_ring - 1];
    const VertexId ahead = contact.edge + 1 == ring.size() ? ring_starts[first_ring + contact.edge_ring] : start + 1;
    const VertexId edge = next[start] == ahead ? start : ahead;
    const VertexId v = ring_starts[first_ring + contact.vertex_ring] + static_cast<VertexId>(contact.vertex);
    // No edge runs along another one: both neighbors lie on one side.
    if (orientation(vertices[edge], vertices[next[edge]], vertices[next[v]]) > 0)
      touches.on_left.push_back({edge, v});
    else
      touches.on_right.push_back(v);
  }
  Box region_box;
  for (const Vec2& p : polygon.outer) region_box.extend(p);
  close_region(region_box);
}

void World::Data::add_ring(const Ring& ring, int wanted_winding) {
  const auto first = static_cast<VertexId>(vertices.size());
  const auto n = static_cast<VertexId>(ring.size());
  ring_starts.push_back(first);
  const bool as_given = winding(ring) == wanted_winding;
  for (VertexId i = 0; i < n; ++i) {
    const VertexId ahead = first + (i + 1 == n ? 0 : i + 1);
    const VertexId behind = first + (i == 0 ? n - 1 : i - 1);
    vertices.push_back(ring[i]);
    next.push_back(as_given ? ahead : behind);
    previous.push_back(as_given ? behind : ahead);
  }
}

void World::Data::reserve(std::size_t vertex_count) {
  vertices.reserve(vertex_count);
  edges.reserve(vertex_count);
  next.reserve(vertex_count);
  previous.reserve(vertex_count);
  obstacle_of.reserve(vertex_count);
}

void World::Data::close_region(const Box& region_box) {
  obstacle_of.resize(vertices.size(), static_cast<ObstacleId>(boxes.size()));
  boxes.push_back(region_box);
  stamps.push_back(next_stamp());
  region_starts.push_back(static_cast<VertexId>(vertices.size()));
  region_rings.push_back(ring_starts.size());
  box.extend(region_box);
}

void World::Data::derive_edges() {
  const auto n = static_cast<VertexId>(vertices.size());
  edges.reserve(n);
  convex.resize(n);
  for (auto v = static_cast<VertexId>(edges.size()); v < n; ++v) {
    edges.push_back({vertices[v], vertices[next[v]]});
    convex[v] = orientation(vertices[previous[v]], vertices[v], vertices[next[v]]) > 0;
  }
}

std::span<const VertexId> World::Data::listed_graph_vertices() const {
  std::call_once(graph_vertices->listed, [this] {
    empty_with_memory(graph_vertices->all, graph_vertex_count);
    for (VertexId v = 0; v < vertices.size(); ++v)
      if (is_graph_vertex(v)) graph_vertices->all.push_back(v);
  });
  return graph_vertices->all;
}

std::size_t World::Data::count_graph_vertices(std::span<const VertexRange> ranges) const {
  std::size_t count = 0;
  for (const VertexRange& range : ranges)
    for (VertexId v = range.first; v < range.last; ++v) count += is_graph_vertex(v) ? 1 : 0;
  return count;
}

PointLocation World::Data::locate(const Vec2& p, ObstacleId region) const {
  if (!boxes[region].contains(p)) return side_of(PointLocation::kOutside, region);
  RayParity parity(p);
  for (VertexId v = region_starts[region]; v < region_starts[region + 1]; ++v) {
    parity.add(vertices[v], vertices[next[v]]);
  }
  return side_of(parity.location(), region);
}

void World::Data::relink_pinches(VertexId first_vertex, std::span<const VertexId> on_right_of_edges) {
  HugeVector<VertexId> order(vertices.size() - first_vertex);
  std::iota(order.begin(), order.end(), first_vertex);
  const auto key = [this](VertexId v) { return std::tuple(obstacle_of[v], vertices[v].x(), vertices[v].y()); };
  std::sort(order.begin(), order.end(), [&](VertexId v, VertexId w) { return key(v) < key(w); });
  std::vector<std::pair<VertexId, VertexId>> links;  // made in the end: the search needs the old ones
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && key(order[first]) == key(order[last])) ++last;
    if (last - first < 2) continue;
    const auto on_right = std::partition(order.begin() + first, order.begin() + last, [&](VertexId v) {
      return !std::binary_search(on_right_of_edges.begin(), on_right_of_edges.end(), v);
    });
    append_links({order.begin() + first, on_right}, links);
    append_links({on_right, order.begin() + last}, links);
  }
  for (const auto& [u, v] : links) {
    next[u] = v;
    previous[v] = u;
  }
}

void World::Data::append_links(std::span<const VertexId> pinch,
                               std::vector<std::pair<VertexId, VertexId>>& links) const {
  for (const VertexId v : pinch) {
    VertexId nearest = previous[v];
    for (const VertexId w : pinch) {
      const VertexId u = previous[w];
      if (in_open_cone(vertices[nearest], vertices[v], vertices[next[v]], vertices[u])) nearest = u;
    }
    links.emplace_back(nearest, v);
  }
}

void World::Data::connect(VertexId first_vertex, Touches touches) {
  std::sort(touches.on_right.begin(), touches.on_right.end());
  relink_pinches(first_vertex, touches.on_right);
  contacts.insert(contacts.end(), touches.on_left.begin(), touches.on_left.end());
}

void World::Data::sort_contacts() {
  const auto by_edge = [](const SelfContact& c) { return std::pair(c.edge, c.vertex); };
  std::ranges::sort(contacts, {}, by_edge);
  contacts_by_vertex = contacts;
  std::ranges::sort(contacts_by_vertex, {}, &SelfContact::vertex);
}

}  // namespace arcway
