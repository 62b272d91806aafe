#include <algorithm>
#include <atomic>
#include <utility>

#include "accel/expansion/free_space_triangulation.h"
#include "core/base/prefetch.h"
#include "core/geometry/tiles.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kTrianglesPerRange = 4096;
constexpr std::size_t kRingsPerRange = 256;
constexpr std::size_t kAhead = 24;  // triangles to prefetch ahead: their data lie all over the sweep line

}  // namespace

FreeSpaceTriangulation::NodeOrder FreeSpaceTriangulation::number_nodes() {
  const auto count = static_cast<VertexId>(world_.vertices().size());
  const Tiles tiles(world_.box(), map_.points.size());
  NodeOrder order;
  std::vector<std::uint32_t> tile;  // by ring
  std::vector<bool> is_found(count, false);
  for (VertexId first = 0; first < count; ++first) {
    if (is_found[first]) continue;
    Ring ring{first, 0, 0};
    for (VertexId v = first; !is_found[v]; v = world_.next(v)) {
      is_found[v] = true;
      ring.nodes += world_.is_graph_vertex(v) ? 1 : 0;
      if (map_.point_of[v] < map_.point_of[ring.leftmost]) ring.leftmost = v;
    }
    order.rings.push_back(ring);
    tile.push_back(tiles.of(world_.vertex(ring.leftmost)));
  }
  for (const std::uint32_t r : sorted_by_tile(std::move(tile), tiles.count())) {
    order.rings[r].first_node = order.node_count;
    order.node_count += order.rings[r].nodes;
  }
  node_at_.assign(map_.points.size(), kNone);
  for (const Ring& ring : order.rings) {
    VertexId v = ring.leftmost;
    for (std::uint32_t n = ring.first_node; n < ring.first_node + ring.nodes; v = world_.next(v)) {
      if (!world_.is_graph_vertex(v)) continue;
      std::uint32_t& last = node_at_[map_.point_of[v]];
      if (last != kNone) order.shared_points.push_back(map_.point_of[v]);
      last = last == kNone ? n : std::max(last, n);
      ++n;
    }
  }
  return order;
}

// Reads triangles in the order of the sweep and writes them to their tiles. The working set is the neighborhood of the
// sweep line, which stays in the cache.
BigVector<FreeSpaceTriangulation::BoundaryHalfEdge> FreeSpaceTriangulation::lay_out_half_edges(
    Triangulation t, const Executor& executor) {
  const Tiles tiles(world_.box(), map_.points.size());
  std::vector<std::uint32_t> place(t.triangle_count());
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (i + kAhead < place.size()) will_need(&map_.points[t.corners[3 * (i + kAhead)]]);
    place[i] = tiles.of(map_.points[t.corners[3 * i]]);
  }
  place = places_by_tile(std::move(place), tiles.count());

  half_edges_.resize(t.corners.size());
  BigVector<BoundaryHalfEdge> boundary(map_.points.size(), kNoBoundary);
  const auto fetch = [&](std::size_t i) {
    for (std::size_t h = 3 * i; h < 3 * i + 3; ++h) {
      will_need(&map_.points[t.corners[h]]);
      will_need(&node_at_[t.corners[h]]);
      will_need(&place[std::min<std::size_t>(t.twins[h] / 3, place.size() - 1)]);
    }
    will_need(&half_edges_[3 * place[i]]);
    will_need(&half_edges_[3 * place[i] + 2]);
  };
  executor.for_ranges(place.size(), kTrianglesPerRange, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<std::uint32_t, BoundaryHalfEdge>>
        found;  // by left end; stored after the loop, as atomics would wait for the half-edges
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < place.size()) fetch(i + kAhead);
      std::uint32_t point[3], behind[3];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * i + k;
        const std::uint32_t twin = t.twins[h];
        point[k] = t.corners[h];
        behind[k] = twin == kNone ? kNone : 3 * place[twin / 3] + twin % 3;
      }
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = k == 2 ? 0 : k + 1, previous = k == 0 ? 2 : k - 1;
        const std::uint32_t apex = point[previous], half_edge = 3 * place[i] + k;
        half_edges_[half_edge] = {map_.points[apex], behind[previous], behind[next], apex, node_at_[apex]};
        if (behind[k] == kNone) found.push_back({point[k], {half_edge, point[next]}});
      }
    }
    for (const auto& [left, edge] : found) {
      const std::atomic_ref at(boundary[left]);
      BoundaryHalfEdge none = kNoBoundary;
      if (!at.compare_exchange_strong(none, edge, std::memory_order_relaxed))
        at.store(kSeveralBoundaries, std::memory_order_relaxed);
    }
  });
  return boundary;
}

void FreeSpaceTriangulation::lay_out_nodes(const NodeOrder& order, BigVector<BoundaryHalfEdge> boundary,
                                           const Executor& executor) {
  for (const std::uint32_t point : order.shared_points) boundary[point] = kSeveralBoundaries;
  nodes_.resize(order.node_count);
  std::atomic<bool> are_all_simple = true;
  executor.for_ranges(order.rings.size(), kRingsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
      if (!lay_out_ring(order.rings[r], boundary)) are_all_simple.store(false, std::memory_order_relaxed);
  });
  if (are_all_simple) return;
  if (!order.shared_points.empty()) {
    std::fill(node_at_.begin(), node_at_.end(), kNone);
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) nodes_[n].sibling = std::exchange(node_at_[nodes_[n].point], n);
  }
  find_fans();
}

bool FreeSpaceTriangulation::lay_out_ring(const Ring& ring, std::span<const BoundaryHalfEdge> boundary) {
  const std::uint32_t first = ring.first_node, behind = first + ring.nodes;
  VertexId previous = world_.previous(ring.leftmost), v = ring.leftmost;
  do {
    will_need(&boundary[map_.point_of[v]]);
    v = world_.next(v);
  } while (v != ring.leftmost);
  bool are_all_simple = true;
  for (std::uint32_t n = first; n < behind;) {
    const VertexId next = world_.next(v);
    if (world_.is_graph_vertex(v)) {
      const std::uint32_t point = map_.point_of[v], previous_point = map_.point_of[previous],
                          next_point = map_.point_of[next];
      Node node{world_.vertex(v),
                world_.vertex(previous),
                world_.vertex(next),
                v,
                point,
                previous_point,
                next_point,
                kNone,
                kNone,
                kNone,
                kNone,
                kNone};
      if (boundary[point].right == previous_point) {
        const BoundaryHalfEdge& ahead = boundary[next_point];
        node.last_half_edge =
            ahead.right == point ? ahead.half_edge : last_half_edge_of_fan(boundary[point].half_edge, next_point);
        if (node.last_half_edge != kNone) node.first_half_edge = boundary[point].half_edge;
      }
      are_all_simple = are_all_simple && node.is_simple();
      nodes_[n++] = node;
    }
    previous = v;
    v = next;
  }
  for (std::uint32_t n = first, before = behind - 1; n < behind; before = n++)
    if (nodes_[n].is_simple() && nodes_[before].is_simple() && nodes_[before].next_point == nodes_[n].point) {
      nodes_[n].before = before;
      nodes_[before].after = n;
    }
  return are_all_simple;
}

// Last half-edge of the fan from a half-edge on, if the fan ends at the boundary edge from its point to the next one;
// kNone if it ends elsewhere.
std::uint32_t FreeSpaceTriangulation::last_half_edge_of_fan(std::uint32_t half_edge, std::uint32_t next_point) const {
  while (half_edges_[half_edge].left != kNone) half_edge = half_edges_[half_edge].left;
  return half_edges_[half_edge].point == next_point ? Triangulation::previous(half_edge) : kNone;
}

void FreeSpaceTriangulation::find_fans() {
  struct Start {
    std::uint32_t node;
    Fan fan;
  };
  std::vector<Start> starts;
  std::vector<std::uint8_t> has_fan(nodes_.size(), 0);
  const auto half_edge_count = static_cast<std::uint32_t>(half_edges_.size());
  const auto left_end = [&](std::uint32_t half_edge) { return half_edges_[Triangulation::next(half_edge)].point; };
  const auto right_end = [&](std::uint32_t half_edge) { return half_edges_[Triangulation::previous(half_edge)].point; };
  const auto is_boundary = [&](std::uint32_t half_edge) {
    return half_edges_[Triangulation::next(half_edge)].left == kNone;
  };
  const auto start_fan = [&](std::uint32_t half_edge) {
    const std::uint32_t node = node_at_[left_end(half_edge)];
    if (node == kNone || nodes_[node].is_simple()) return;
    starts.push_back({node, {half_edge, right_end(half_edge)}});
    has_fan[node] = 1;
  };
  for (std::uint32_t half_edge = 0; half_edge < half_edge_count; ++half_edge)
    if (is_boundary(half_edge)) start_fan(half_edge);
  const auto lacks_fan = [&](std::uint32_t n) {
    return node_at_[nodes_[n].point] == n && !nodes_[n].is_simple() && !has_fan[n];
  };
  bool is_complete = true;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) is_complete = is_complete && !lacks_fan(n);
  if (!is_complete) {  // points without boundary edges
    for (std::uint32_t half_edge = 0; half_edge < half_edge_count; ++half_edge)
      if (const std::uint32_t n = node_at_[left_end(half_edge)]; n != kNone && lacks_fan(n)) start_fan(half_edge);
  }

  // All nodes at a point share its fans.
  const auto each_node_of = [&](const Start& start, const auto& visit) {
    for (std::uint32_t n = start.node; n != kNone; n = nodes_[n].sibling) visit(n);
  };
  first_fan_.assign(nodes_.size() + 1, 0);
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { ++first_fan_[n + 1]; });
  for (std::size_t n = 0; n < nodes_.size(); ++n) first_fan_[n + 1] += first_fan_[n];
  fans_.resize(first_fan_.back());
  std::vector<std::uint32_t> next(first_fan_.begin(), first_fan_.end() - 1);
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { fans_[next[n]++] = start.fan; });
}

}  // namespace arcway::internal
