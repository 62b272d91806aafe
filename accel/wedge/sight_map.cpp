#include "accel/wedge/sight_map.h"

#include <numeric>
#include <stdexcept>
#include <string>

#include "accel/triangulation/delaunay_flips.h"
#include "accel/triangulation/free_space_sweep.h"
#include "accel/wedge/tiles.h"
#include "core/query/blocking.h"

namespace arcway {

namespace {

constexpr std::size_t kTrianglesPerRange = 4096;
constexpr std::size_t kMaxVertices = std::size_t{1} << 28;  // six half-edges a vertex, and one bit for marks

Box box_of(const LineSegment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

}  // namespace

SightMap::SightMap(const World& world, const Executor& executor) : world_(world) {
  if (world.vertices().size() > kMaxVertices)
    throw std::length_error("wedge builder: the world has " + std::to_string(world.vertices().size()) +
                            " vertices, at most " + std::to_string(kMaxVertices) + " fit");
  if (world.vertices().empty()) return;
  std::optional<FreeSpace> space;
  if (make_plain_map(world, map_)) space = triangulate_free_space(map_);
  if (!space) {
    map_ = make_cut_map(world);
    space = triangulate_free_space(map_);
    if (!space) throw std::logic_error("wedge builder: edges meet after they have been cut");
  }
  edge_is_covered_ = std::move(space->edge_is_covered);
  executor.begin_stage("triangulation");
  flip_towards_delaunay(map_.sites, space->triangulation, executor);
  const Tiles tiles(world_.box(), map_.sites.size());
  const std::vector<std::uint32_t> tile_of_site = tiles.of(map_.sites);
  lay_out_nodes(tile_of_site, tiles.count());
  lay_out_doors(space->triangulation, tile_of_site, tiles.count(), executor);

  std::vector<Box> boxes;
  for (const ObstacleId o : map_.broken) {
    const auto [first, last] = world_.vertices_of(o);
    for (VertexId e = first; e < last; ++e) {
      broken_edges_.push_back(e);
      boxes.push_back(box_of(world_.edges()[e]));
    }
  }
  broken_tree_ = BoxTree(boxes);
}

bool SightMap::is_blocked_by_broken(const LineSegment& segment) const {
  return !broken_tree_.visit_overlaps(box_of(segment),
                                      [&](std::uint32_t i) { return !blocks(world_, broken_edges_[i], segment); });
}

void SightMap::list_left_edges() {
  std::vector<std::uint32_t> ends(map_.edges.size());
  first_left_edge_.assign(map_.sites.size() + 1, 0);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    ends[e] = map_.edges[e].high;
    ++first_left_edge_[ends[e] + 1];
  }
  std::partial_sum(first_left_edge_.begin(), first_left_edge_.end(), first_left_edge_.begin());
  left_edges_ = sorted_by_tile(ends, static_cast<std::uint32_t>(map_.sites.size()));
}

void SightMap::lay_out_nodes(std::span<const std::uint32_t> tile_of_site, std::uint32_t tiles) {
  const auto count = static_cast<VertexId>(world_.vertices().size());
  std::vector<VertexId> leftmost;  // by ring
  std::vector<std::uint32_t> tile;
  std::vector<std::uint8_t> is_found(count, 0);
  for (VertexId first = 0; first < count; ++first) {
    if (is_found[first]) continue;
    VertexId low = first;
    for (VertexId v = first; !is_found[v]; v = world_.next(v)) {
      is_found[v] = 1;
      if (map_.site_of[v] < map_.site_of[low]) low = v;
    }
    leftmost.push_back(low);
    tile.push_back(tile_of_site[map_.site_of[low]]);
  }
  nodes_.reserve(world_.convex_vertices().size());
  node_at_.assign(map_.sites.size(), kNone);
  for (const std::uint32_t ring : sorted_by_tile(tile, tiles)) {
    first_of_ring_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    VertexId previous = world_.previous(leftmost[ring]), v = leftmost[ring];
    do {
      const VertexId next = world_.next(v);
      if (world_.is_convex(v) && !world_.is_covered(v)) {
        const std::uint32_t site = map_.site_of[v];
        nodes_.push_back({world_.vertex(v), world_.vertex(previous), world_.vertex(next), v, site,
                          map_.site_of[previous], map_.site_of[next], node_at_[site], kNone, kNone, kNone, kNone});
        node_at_[site] = static_cast<std::uint32_t>(nodes_.size() - 1);
      }
      previous = v;
      v = next;
    } while (v != leftmost[ring]);
  }
  first_of_ring_.push_back(static_cast<std::uint32_t>(nodes_.size()));
}

void SightMap::lay_out_doors(const Triangulation& t, std::span<const std::uint32_t> tile_of_site, std::uint32_t tiles,
                             const Executor& executor) {
  std::vector<std::uint32_t> tile(t.triangle_count());
  for (std::size_t i = 0; i < tile.size(); ++i) tile[i] = tile_of_site[t.corners[3 * i]];
  const std::vector<std::uint32_t> order = sorted_by_tile(tile, tiles);
  std::vector<std::uint32_t>& place = tile;
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;

  door_count_ = t.corners.size();
  doors_ = std::make_unique_for_overwrite<Door[]>(door_count_);
  executor.for_ranges(order.size(), kTrianglesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::uint32_t site[3], behind[3];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * order[i] + k, twin = t.twins[h];
        site[k] = t.corners[h];
        behind[k] = twin == kNone ? kNone : 3 * place[twin / 3] + twin % 3;
      }
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = k == 2 ? 0 : k + 1, previous = k == 0 ? 2 : k - 1;
        const std::uint32_t apex = site[previous];
        doors_[3 * i + k] = {map_.sites[apex], behind[previous], behind[next], apex, node_at_[apex]};
      }
    }
  });
  find_fans(t, order);
  find_plain_nodes();
}

void SightMap::find_fans(const Triangulation& t, std::span<const std::uint32_t> order) {
  struct Start {
    std::uint32_t node;
    Fan fan;
  };
  std::vector<Start> starts;
  starts.reserve(nodes_.size());
  std::vector<std::uint8_t> has_fan(nodes_.size(), 0);
  std::size_t missing = 0;
  const auto each_half_edge = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < order.size(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k) visit(3 * order[i] + k, 3 * i + k);
  };
  const auto start_fan = [&](std::uint32_t h, std::uint32_t door, std::uint32_t node) {
    starts.push_back({node, {door, t.corners[Triangulation::next(h)]}});
    if (!has_fan[node]) --missing;
    has_fan[node] = 1;
  };
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) missing += node_at_[nodes_[n].site] == n;
  each_half_edge([&](std::uint32_t h, std::uint32_t door) {
    if (t.twins[h] != kNone) return;
    const std::uint32_t left = t.corners[h], right = t.corners[Triangulation::next(h)];
    if (node_at_[left] != kNone) start_fan(h, door, node_at_[left]);
    const std::uint32_t node = node_at_[right];
    if (node != kNone && nodes_[node].next_site == left) nodes_[node].last_door = door;
  });
  if (missing > 0) {  // sites without walls
    each_half_edge([&](std::uint32_t h, std::uint32_t door) {
      const std::uint32_t node = node_at_[t.corners[h]];
      if (node != kNone && !has_fan[node]) start_fan(h, door, node);
    });
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

void SightMap::find_plain_nodes() {
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    const bool is_alone = node_at_[node.site] == n && node.sibling == kNone && fans(n).size() == 1;
    if (is_alone && node.last_door != kNone && fans(n)[0].first_site == node.previous_site) {
      node.first_door = fans(n)[0].door;
    } else {
      node.last_door = kNone;
    }
  }
  for (std::size_t ring = 0; ring + 1 < first_of_ring_.size(); ++ring) {
    const std::uint32_t first = first_of_ring_[ring], end = first_of_ring_[ring + 1];
    for (std::uint32_t n = first, previous = end - 1; n < end; previous = n++)
      if (nodes_[n].is_plain() && nodes_[previous].is_plain() && nodes_[previous].next_site == nodes_[n].site) {
        nodes_[n].before = previous;
        nodes_[previous].after = n;
      }
  }
}

}  // namespace arcway
