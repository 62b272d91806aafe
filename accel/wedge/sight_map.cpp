#include "accel/wedge/sight_map.h"

#include <stdexcept>
#include <string>

#include "accel/triangulation/delaunay_flips.h"
#include "accel/triangulation/free_space_sweep.h"
#include "accel/wedge/tiles.h"
#include "core/query/blocking.h"

namespace arcway {

namespace {

constexpr std::size_t kMaxVertices = std::size_t{1} << 28;  // six half-edges a vertex, and one bit for marks

Box box_of(const LineSegment& s) { return {s.a.cwiseMin(s.b), s.a.cwiseMax(s.b)}; }

}  // namespace

SightMap::SightMap(const World& world) : world_(world) {
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
  flip_towards_delaunay(map_.sites, space->triangulation);
  lay_out_nodes();
  lay_out_doors(space->triangulation);

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

void SightMap::lay_out_nodes() {
  const Tiles tiles(world_.box(), map_.sites.size());
  const std::span<const VertexId> vertices = world_.convex_vertices();
  // By site, then by tile.
  std::vector<std::uint32_t> sites(vertices.size()), tile(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) sites[i] = map_.site_of[vertices[i]];
  const std::vector<std::uint32_t> by_site = sorted_by_tile(sites, static_cast<std::uint32_t>(map_.sites.size()));
  for (std::size_t i = 0; i < by_site.size(); ++i) tile[i] = tiles.of(world_.vertex(vertices[by_site[i]]));
  nodes_.reserve(vertices.size());
  node_at_.assign(map_.sites.size(), kNone);
  for (const std::uint32_t i : sorted_by_tile(tile, tiles.count())) {
    const VertexId v = vertices[by_site[i]];
    const VertexId previous = world_.previous(v), next = world_.next(v);
    const std::uint32_t site = map_.site_of[v];
    if (node_at_[site] == kNone) node_at_[site] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({world_.vertex(v), world_.vertex(previous), world_.vertex(next), v, site, map_.site_of[previous],
                      map_.site_of[next]});
  }
}

void SightMap::lay_out_doors(const Triangulation& t) {
  const Tiles tiles(world_.box(), map_.sites.size());
  std::vector<std::uint32_t> tile(t.triangle_count());
  for (std::size_t i = 0; i < tile.size(); ++i) tile[i] = tiles.of(map_.sites[t.corners[3 * i]]);
  const std::vector<std::uint32_t> order = sorted_by_tile(tile, tiles.count());
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  const auto door_of = [&](std::uint32_t h) { return h == kNone ? kNone : 3 * place[h / 3] + h % 3; };

  doors_.resize(t.corners.size());
  struct Start {
    std::uint32_t node;
    Fan fan;
  };
  std::vector<std::uint8_t> has_wall(nodes_.size(), 0);
  first_fan_.assign(nodes_.size() + 1, 0);
  std::vector<Start> starts;
  starts.reserve(nodes_.size());
  for (const bool at_walls : {true, false}) {
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * order[i] + k;
        if (at_walls) {
          const std::uint32_t apex = t.corners[Triangulation::previous(h)];
          doors_[3 * i + k] = {map_.sites[apex], door_of(t.twins[Triangulation::previous(h)]),
                               door_of(t.twins[Triangulation::next(h)]), apex, node_at_[apex]};
        }
        const std::uint32_t node = node_at_[t.corners[h]];
        if (node == kNone || (at_walls ? t.twins[h] != kNone : has_wall[node] != 0)) continue;
        has_wall[node] = 1;  // or the one fan that a site without walls needs
        starts.push_back({node, {3 * i + k, t.corners[Triangulation::next(h)], at_walls}});
      }
    }
  }
  // Every node of a site has the fans of the site.
  const auto each_node_of = [&](const Start& start, const auto& visit) {
    for (std::uint32_t n = start.node; n < nodes_.size() && nodes_[n].site == nodes_[start.node].site; ++n) visit(n);
  };
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { ++first_fan_[n + 1]; });
  for (std::size_t n = 0; n < nodes_.size(); ++n) first_fan_[n + 1] += first_fan_[n];
  fans_.resize(first_fan_.back());
  std::vector<std::uint32_t> next(first_fan_.begin(), first_fan_.end() - 1);
  for (const Start& start : starts) each_node_of(start, [&](std::uint32_t n) { fans_[next[n]++] = start.fan; });
}

}  // namespace arcway
