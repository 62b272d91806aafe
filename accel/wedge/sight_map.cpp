#include "accel/wedge/sight_map.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>

#include "accel/triangulation/free_space_sweep.h"
#include "accel/wedge/tiles.h"
#include "core/query/blocking.h"

namespace arcway {

namespace {

constexpr std::size_t kTrianglesPerBlock = 4096;
constexpr std::size_t kNodesPerRange = 4096;
constexpr std::size_t kRingsPerRange = 256;
constexpr std::size_t kMaxVertices = std::size_t{1} << 28;  // six half-edges a vertex, and one bit for marks

// One piece, for who watches or stops the build.
bool sort(const Executor& executor, const std::function<bool()>& make_map) {
  bool is_made = false;
  executor.begin_stage("sorting");
  executor.for_ranges(1, 1, [&](std::size_t, std::size_t) { is_made = make_map(); });
  return is_made;
}

Box box_of(const LineSegment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

}  // namespace

SightMap::SightMap(const World& world, const Executor& executor, Diagonals shortened) : world_(world) {
  if (world.vertices().size() > kMaxVertices)
    throw std::length_error("wedge builder: the world has " + std::to_string(world.vertices().size()) +
                            " vertices, at most " + std::to_string(kMaxVertices) + " fit");
  if (world.vertices().empty()) return;
  std::optional<FreeSpace> space;
  if (sort(executor, [&] { return make_plain_map(world, map_); })) space = sweep(executor);
  if (!space) {
    sort(executor, [&] {
      map_ = make_cut_map(world);
      return true;
    });
    space = sweep(executor);
    if (!space) throw std::logic_error("wedge builder: edges meet after they have been cut");
  }
  edge_is_covered_ = std::move(space->edge_is_covered);
  shorten_diagonals(map_.sites, space->triangulation, shortened, executor);
  lay_out_doors(space->triangulation, executor);

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

// The sweep cannot be shared out, but nodes need no triangles.
std::optional<FreeSpace> SightMap::sweep(const Executor& executor) {
  executor.begin_stage("triangulation");
  std::optional<FreeSpace> space;
  executor.for_ranges(2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) {
      if (task == 0) {
        space = triangulate_free_space(map_);
      } else {
        lay_out_nodes();
      }
    }
  });
  return space;
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

void SightMap::lay_out_nodes() {
  struct Loop {
    VertexId leftmost;
    std::uint32_t nodes;
  };
  const auto count = static_cast<VertexId>(world_.vertices().size());
  const auto has_node = [&](VertexId v) { return world_.is_convex(v) && !world_.is_covered(v); };
  const Tiles tiles(world_.box(), map_.sites.size());
  tile_count_ = tiles.count();
  tile_of_site_ = tiles.of(map_.sites);
  std::vector<Loop> rings;
  std::vector<std::uint32_t> tile;  // by ring
  std::vector<std::uint8_t> is_found(count, 0);
  for (VertexId first = 0; first < count; ++first) {
    if (is_found[first]) continue;
    Loop ring{first, 0};
    for (VertexId v = first; !is_found[v]; v = world_.next(v)) {
      is_found[v] = 1;
      ring.nodes += has_node(v) ? 1 : 0;
      if (map_.site_of[v] < map_.site_of[ring.leftmost]) ring.leftmost = v;
    }
    rings.push_back(ring);
    tile.push_back(tile_of_site_[map_.site_of[ring.leftmost]]);
  }
  const std::vector<std::uint32_t> order = sorted_by_tile(tile, tile_count_);
  first_of_ring_.assign(1, 0);
  for (const std::uint32_t r : order) first_of_ring_.push_back(first_of_ring_.back() + rings[r].nodes);

  nodes_.resize(first_of_ring_.back());
  node_at_.assign(map_.sites.size(), kNone);
  std::uint32_t n = 0;
  for (const std::uint32_t ring : order) {
    const VertexId first = rings[ring].leftmost;
    VertexId previous = world_.previous(first), v = first;
    do {
      const VertexId next = world_.next(v);
      if (has_node(v)) {
        const std::uint32_t site = map_.site_of[v];
        nodes_[n] = {world_.vertex(v),
                     world_.vertex(previous),
                     world_.vertex(next),
                     v,
                     site,
                     map_.site_of[previous],
                     map_.site_of[next],
                     node_at_[site],
                     kNone,
                     kNone,
                     kNone,
                     kNone};
        node_at_[site] = n++;
      }
      previous = v;
      v = next;
    } while (v != first);
  }
}

void SightMap::lay_out_doors(const Triangulation& t, const Executor& executor) {
  std::vector<std::uint32_t> tile(t.triangle_count());
  for (std::size_t i = 0; i < tile.size(); ++i) tile[i] = tile_of_site_[t.corners[3 * i]];
  const std::vector<std::uint32_t> order = sorted_by_tile(tile, tile_count_);
  tile_of_site_ = {};
  std::vector<std::uint32_t>& place = tile;
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;

  doors_.resize(t.corners.size());
  std::vector<std::vector<Wall>> walls((order.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock);
  executor.for_ranges(walls.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block) {
      const std::size_t end = std::min(order.size(), (block + 1) * kTrianglesPerBlock);
      for (std::size_t i = block * kTrianglesPerBlock; i < end; ++i) {
        std::uint32_t site[3], behind[3];
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t h = 3 * order[i] + k, twin = t.twins[h];
          site[k] = t.corners[h];
          behind[k] = twin == kNone ? kNone : 3 * place[twin / 3] + twin % 3;
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t next = k == 2 ? 0 : k + 1, previous = k == 0 ? 2 : k - 1;
          const std::uint32_t apex = site[previous];
          const auto door = static_cast<std::uint32_t>(3 * i + k);
          doors_[door] = {map_.sites[apex], behind[previous], behind[next], apex, node_at_[apex]};
          if (behind[k] == kNone) walls[block].push_back({site[k], site[next], door});
        }
      }
    }
  });
  first_fan_.assign(nodes_.size() + 1, 0);
  if (!find_plain_nodes(walls, executor)) find_fans(walls);
}

bool SightMap::find_plain_nodes(const std::vector<std::vector<Wall>>& walls, const Executor& executor) {
  std::vector<std::uint32_t> fans(nodes_.size(), 0);  // by first node of a site
  executor.for_ranges(walls.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t block = first; block < last; ++block)
      for (const Wall& wall : walls[block]) {
        if (const std::uint32_t n = node_at_[wall.left]; n != kNone) {
          std::atomic_ref(fans[n]).fetch_add(1, std::memory_order_relaxed);
          if (nodes_[n].previous_site == wall.right) nodes_[n].first_door = wall.door;
        }
        if (const std::uint32_t n = node_at_[wall.right]; n != kNone && nodes_[n].next_site == wall.left)
          nodes_[n].last_door = wall.door;
      }
  });
  std::atomic<bool> are_all_plain = true;
  executor.for_ranges(nodes_.size(), kNodesPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      Node& node = nodes_[n];
      const bool is_alone = node_at_[node.site] == n && node.sibling == kNone && fans[n] == 1;
      if (is_alone && node.first_door != kNone && node.last_door != kNone) continue;
      node.first_door = node.last_door = kNone;
      are_all_plain.store(false, std::memory_order_relaxed);
    }
  });
  executor.for_ranges(first_of_ring_.size() - 1, kRingsPerRange, [&](std::size_t begin, std::size_t end) {
    for (std::size_t ring = begin; ring < end; ++ring) {
      const std::uint32_t first = first_of_ring_[ring], behind = first_of_ring_[ring + 1];
      for (std::uint32_t n = first, previous = behind - 1; n < behind; previous = n++)
        if (nodes_[n].is_plain() && nodes_[previous].is_plain() && nodes_[previous].next_site == nodes_[n].site) {
          nodes_[n].before = previous;
          nodes_[previous].after = n;
        }
    }
  });
  return are_all_plain;
}

void SightMap::find_fans(const std::vector<std::vector<Wall>>& walls) {
  struct Start {
    std::uint32_t node;
    Fan fan;
  };
  std::vector<Start> starts;
  std::vector<std::uint8_t> has_fan(nodes_.size(), 0);
  const auto start_fan = [&](const Wall& wall) {
    const std::uint32_t node = node_at_[wall.left];
    if (node == kNone || nodes_[node].is_plain()) return;
    starts.push_back({node, {wall.door, wall.right}});
    has_fan[node] = 1;
  };
  for (const auto& block : walls)
    for (const Wall& wall : block) start_fan(wall);
  const auto lacks_fan = [&](std::uint32_t n) {
    return node_at_[nodes_[n].site] == n && !nodes_[n].is_plain() && !has_fan[n];
  };
  bool is_complete = true;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) is_complete = is_complete && !lacks_fan(n);
  if (!is_complete) {  // sites without walls
    for (std::uint32_t d = 0; d < doors_.size(); ++d) {
      const std::uint32_t left = doors_[d % 3 == 2 ? d - 2 : d + 1].site,
                          right = doors_[d % 3 == 0 ? d + 2 : d - 1].site;
      if (node_at_[left] != kNone && lacks_fan(node_at_[left])) start_fan({left, right, d});
    }
  }

  // Every node of a site has the fans of the site.
  const auto each_node_of = [&](const Start& start, const auto& visit) {
    for (std::uint32_t n = start.node; n != kNone; n = nodes_[n].sibling) visit(n);
  };
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { ++first_fan_[n + 1]; });
  for (std::size_t n = 0; n < nodes_.size(); ++n) first_fan_[n + 1] += first_fan_[n];
  fans_.resize(first_fan_.back());
  std::vector<std::uint32_t> next(first_fan_.begin(), first_fan_.end() - 1);
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { fans_[next[n]++] = start.fan; });
}

}  // namespace arcway
