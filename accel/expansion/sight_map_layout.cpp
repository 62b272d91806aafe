#include <algorithm>
#include <atomic>
#include <utility>

#include "accel/expansion/sight_map.h"
#include "core/base/prefetch.h"
#include "core/geometry/tiles.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kTrianglesPerRange = 4096;
constexpr std::size_t kRingsPerRange = 256;
constexpr std::size_t kAhead = 24;  // triangles: what they need and where they go lies all over a sleeve of the map

}  // namespace

SightMap::NodeOrder SightMap::number_nodes() {
  const auto count = static_cast<VertexId>(world_.vertices().size());
  const Tiles tiles(world_.box(), map_.sites.size());
  NodeOrder order;
  std::vector<std::uint32_t> tile;  // by ring
  std::vector<bool> is_found(count, false);
  for (VertexId first = 0; first < count; ++first) {
    if (is_found[first]) continue;
    Ring ring{first, 0, 0};
    for (VertexId v = first; !is_found[v]; v = world_.next(v)) {
      is_found[v] = true;
      ring.nodes += world_.is_graph_vertex(v) ? 1 : 0;
      if (map_.site_of[v] < map_.site_of[ring.leftmost]) ring.leftmost = v;
    }
    order.rings.push_back(ring);
    tile.push_back(tiles.of(world_.vertex(ring.leftmost)));
  }
  for (const std::uint32_t r : sorted_by_tile(std::move(tile), tiles.count())) {
    order.rings[r].first_node = order.node_count;
    order.node_count += order.rings[r].nodes;
  }
  node_at_.assign(map_.sites.size(), kNone);
  for (const Ring& ring : order.rings) {
    VertexId v = ring.leftmost;
    for (std::uint32_t n = ring.first_node; n < ring.first_node + ring.nodes; v = world_.next(v)) {
      if (!world_.is_graph_vertex(v)) continue;
      std::uint32_t& last = node_at_[map_.site_of[v]];
      if (last != kNone) order.shared_sites.push_back(map_.site_of[v]);
      last = last == kNone ? n : std::max(last, n);
      ++n;
    }
  }
  return order;
}

// Triangles are read in the order of the sweep and written to their tiles: what a sleeve of the sweep reads and writes
// stays in the cache while the sweep passes it.
BigVector<SightMap::Wall> SightMap::lay_out_doors(Triangulation t, const Executor& executor) {
  const Tiles tiles(world_.box(), map_.sites.size());
  std::vector<std::uint32_t> place(t.triangle_count());
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (i + kAhead < place.size()) will_need(&map_.sites[t.corners[3 * (i + kAhead)]]);
    place[i] = tiles.of(map_.sites[t.corners[3 * i]]);
  }
  place = places_by_tile(std::move(place), tiles.count());

  doors_.resize(t.corners.size());
  BigVector<Wall> walls(map_.sites.size(), kNoWall);
  const auto fetch = [&](std::size_t i) {
    for (std::size_t h = 3 * i; h < 3 * i + 3; ++h) {
      will_need(&map_.sites[t.corners[h]]);
      will_need(&node_at_[t.corners[h]]);
      will_need(&place[std::min<std::size_t>(t.twins[h] / 3, place.size() - 1)]);
    }
    will_need(&doors_[3 * place[i]]);
    will_need(&doors_[3 * place[i] + 2]);
  };
  executor.for_ranges(place.size(), kTrianglesPerRange, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<std::uint32_t, Wall>>
        found;  // by left end; noted in the end, as atomics would wait for doors
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < place.size()) fetch(i + kAhead);
      std::uint32_t site[3], behind[3];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * i + k;
        const std::uint32_t twin = t.twins[h];
        site[k] = t.corners[h];
        behind[k] = twin == kNone ? kNone : 3 * place[twin / 3] + twin % 3;
      }
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = k == 2 ? 0 : k + 1, previous = k == 0 ? 2 : k - 1;
        const std::uint32_t apex = site[previous], door = 3 * place[i] + k;
        doors_[door] = {map_.sites[apex], behind[previous], behind[next], apex, node_at_[apex]};
        if (behind[k] == kNone) found.push_back({site[k], {door, site[next]}});
      }
    }
    for (const auto& [left, wall] : found) {
      const std::atomic_ref at(walls[left]);
      Wall none = kNoWall;
      if (!at.compare_exchange_strong(none, wall, std::memory_order_relaxed))
        at.store(kSeveralWalls, std::memory_order_relaxed);
    }
  });
  return walls;
}

void SightMap::lay_out_nodes(const NodeOrder& order, BigVector<Wall> walls, const Executor& executor) {
  for (const std::uint32_t site : order.shared_sites) walls[site] = kSeveralWalls;
  nodes_.resize(order.node_count);
  std::atomic<bool> are_all_plain = true;
  executor.for_ranges(order.rings.size(), kRingsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
      if (!lay_out_ring(order.rings[r], walls)) are_all_plain.store(false, std::memory_order_relaxed);
  });
  if (are_all_plain) return;
  if (!order.shared_sites.empty()) {
    std::fill(node_at_.begin(), node_at_.end(), kNone);
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) nodes_[n].sibling = std::exchange(node_at_[nodes_[n].site], n);
  }
  find_fans();
}

bool SightMap::lay_out_ring(const Ring& ring, std::span<const Wall> walls) {
  const std::uint32_t first = ring.first_node, behind = first + ring.nodes;
  VertexId previous = world_.previous(ring.leftmost), v = ring.leftmost;
  do {
    will_need(&walls[map_.site_of[v]]);
    v = world_.next(v);
  } while (v != ring.leftmost);
  bool are_all_plain = true;
  for (std::uint32_t n = first; n < behind;) {
    const VertexId next = world_.next(v);
    if (world_.is_graph_vertex(v)) {
      const std::uint32_t site = map_.site_of[v], previous_site = map_.site_of[previous],
                          next_site = map_.site_of[next];
      Node node{world_.vertex(v),
                world_.vertex(previous),
                world_.vertex(next),
                v,
                site,
                previous_site,
                next_site,
                kNone,
                kNone,
                kNone,
                kNone,
                kNone};
      if (walls[site].right == previous_site) {
        const Wall& ahead = walls[next_site];
        node.last_door = ahead.right == site ? ahead.door : last_door_of_fan(walls[site].door, next_site);
        if (node.last_door != kNone) node.first_door = walls[site].door;
      }
      are_all_plain = are_all_plain && node.is_plain();
      nodes_[n++] = node;
    }
    previous = v;
    v = next;
  }
  for (std::uint32_t n = first, before = behind - 1; n < behind; before = n++)
    if (nodes_[n].is_plain() && nodes_[before].is_plain() && nodes_[before].next_site == nodes_[n].site) {
      nodes_[n].before = before;
      nodes_[before].after = n;
    }
  return are_all_plain;
}

// The one that a fan leaves through the wall from its site to the next one; kNone if it ends at another wall.
std::uint32_t SightMap::last_door_of_fan(std::uint32_t door, std::uint32_t next_site) const {
  while (doors_[door].left != kNone) door = doors_[door].left;
  return doors_[door].site == next_site ? Triangulation::previous(door) : kNone;
}

void SightMap::find_fans() {
  struct Start {
    std::uint32_t node;
    Fan fan;
  };
  std::vector<Start> starts;
  std::vector<std::uint8_t> has_fan(nodes_.size(), 0);
  const auto door_count = static_cast<std::uint32_t>(doors_.size());
  const auto left_end = [&](std::uint32_t door) { return doors_[Triangulation::next(door)].site; };
  const auto right_end = [&](std::uint32_t door) { return doors_[Triangulation::previous(door)].site; };
  const auto is_wall = [&](std::uint32_t door) { return doors_[Triangulation::next(door)].left == kNone; };
  const auto start_fan = [&](std::uint32_t door) {
    const std::uint32_t node = node_at_[left_end(door)];
    if (node == kNone || nodes_[node].is_plain()) return;
    starts.push_back({node, {door, right_end(door)}});
    has_fan[node] = 1;
  };
  for (std::uint32_t door = 0; door < door_count; ++door)
    if (is_wall(door)) start_fan(door);
  const auto lacks_fan = [&](std::uint32_t n) {
    return node_at_[nodes_[n].site] == n && !nodes_[n].is_plain() && !has_fan[n];
  };
  bool is_complete = true;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) is_complete = is_complete && !lacks_fan(n);
  if (!is_complete) {  // sites without walls
    for (std::uint32_t door = 0; door < door_count; ++door)
      if (const std::uint32_t n = node_at_[left_end(door)]; n != kNone && lacks_fan(n)) start_fan(door);
  }

  // Every node of a site has the fans of the site.
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
