#include "arcway/world.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "core/model/world_checks.h"
#include "core/model/world_data.h"
#include "core/model/world_zones.h"

namespace arcway {

using namespace internal;

World::World(std::vector<Polygon> obstacles, std::optional<Ring> bounds) {
  auto data = std::make_shared<Data>();
  const std::size_t vertex_count = vertex_count_of(obstacles) + (bounds ? bounds->size() : 0);
  const auto obstacle_count = static_cast<ObstacleId>(obstacles.size());
  require_vertex_count(vertex_count, obstacle_count);
  data->vertices.reserve(vertex_count);
  data->next.reserve(vertex_count);
  data->previous.reserve(vertex_count);
  data->obstacle_of.reserve(vertex_count);
  Data::Touches touches;
  for (ObstacleId o = 0; o < obstacle_count; ++o) {
    data->add_region(obstacles[o], require_region(obstacles[o], o, false), false, touches);
    obstacles[o] = {};
  }
  if (bounds) {
    const Polygon polygon{std::move(*bounds), {}};
    data->has_bounds = true;
    data->add_region(polygon, require_region(polygon, obstacle_count, true), true, touches);
  }
  data->connect(0, std::move(touches));
  data->sort_contacts();
  data->derive_edges();
  data->mark_all_covered();
  data->graph_vertex_count =
      data->count_graph_vertices(std::array{VertexRange{0, static_cast<VertexId>(vertex_count)}});
  data->begin_history();
  data_ = std::move(data);
}

World World::from_snapshot(WorldSnapshot snapshot) {
  require_world(snapshot);
  auto data = std::make_shared<Data>();
  const auto n = static_cast<VertexId>(snapshot.vertices.size());
  data->previous.resize(n);
  for (VertexId v = 0; v < n; ++v) data->previous[snapshot.next[v]] = v;
  data->has_bounds = snapshot.has_bounds;
  data->obstacle_of.reserve(n);
  const std::size_t regions = snapshot.region_rings.size() - 1;
  for (std::size_t region = 0; region < regions; ++region) {
    const std::size_t end_ring = snapshot.region_rings[region + 1];
    const VertexId first = snapshot.ring_starts[snapshot.region_rings[region]];
    const VertexId last = end_ring < snapshot.ring_starts.size() ? snapshot.ring_starts[end_ring] : n;
    Box region_box;
    for (VertexId v = first; v < last; ++v) region_box.extend(snapshot.vertices[v]);
    data->obstacle_of.resize(last, static_cast<ObstacleId>(region));
    data->region_starts.push_back(last);
    data->region_rings.push_back(end_ring);
    data->boxes.push_back(region_box);
    data->stamps.push_back(Data::next_stamp());
    data->box.extend(region_box);
  }
  data->vertices.assign(snapshot.vertices.begin(), snapshot.vertices.end());
  snapshot.vertices = {};
  data->next.assign(snapshot.next.begin(), snapshot.next.end());
  data->ring_starts = std::move(snapshot.ring_starts);
  data->covered.assign(snapshot.covered.begin(), snapshot.covered.end());
  data->contacts = std::move(snapshot.self_contacts);
  data->sort_contacts();
  data->derive_edges();
  data->graph_vertex_count = data->count_graph_vertices(std::array{VertexRange{0, n}});
  data->begin_history();
  World world(std::vector<Polygon>{});
  world.data_ = std::move(data);
  world.zones_ = Zones::of(std::move(snapshot.zones), snapshot.keep_outs);
  return world;
}

WorldSnapshot World::snapshot() const {
  WorldSnapshot snapshot;
  snapshot.vertices.assign(data_->vertices.begin(), data_->vertices.end());
  snapshot.next.assign(data_->next.begin(), data_->next.end());
  snapshot.covered.assign(data_->covered.begin(), data_->covered.end());
  snapshot.ring_starts = data_->ring_starts;
  snapshot.region_rings.assign(data_->region_rings.begin(), data_->region_rings.end());
  snapshot.self_contacts = data_->contacts;
  snapshot.has_bounds = data_->has_bounds;
  add_zones(snapshot);
  return snapshot;
}

std::span<const Vec2> World::vertices() const { return data_->vertices; }
std::span<const LineSegment> World::edges() const { return data_->edges; }
VertexId World::next(VertexId v) const { return data_->next[v]; }
VertexId World::previous(VertexId v) const { return data_->previous[v]; }
std::span<const SelfContact> World::self_contacts() const { return data_->contacts; }

std::span<const SelfContact> World::self_contacts_on(VertexId edge) const {
  if (data_->contacts.empty()) return {};
  const auto& all = data_->contacts;
  const auto first = std::ranges::lower_bound(all, edge, {}, &SelfContact::edge);
  return {first, std::ranges::upper_bound(first, all.end(), edge, {}, &SelfContact::edge)};
}

VertexId World::edge_touched_by(VertexId v) const {
  const auto& contacts = data_->contacts_by_vertex;
  if (contacts.empty()) return kNone;
  const auto at = std::ranges::lower_bound(contacts, v, {}, &SelfContact::vertex);
  return at != contacts.end() && at->vertex == v ? at->edge : kNone;
}

ObstacleId World::obstacle_of(VertexId v) const { return data_->obstacle_of[v]; }
bool World::is_convex(VertexId v) const { return data_->convex[v]; }
bool World::is_covered(VertexId v) const { return data_->covered[v]; }
bool World::is_graph_vertex(VertexId v) const { return data_->is_graph_vertex(v); }
std::span<const VertexId> World::convex_vertices() const { return data_->listed_graph_vertices(); }
std::size_t World::graph_vertex_count() const { return data_->graph_vertex_count; }
std::size_t World::obstacle_count() const { return data_->obstacle_count(); }
ObstacleKey World::key_of(ObstacleId o) const { return data_->key_of(o); }

ObstacleId World::obstacle_with(ObstacleKey key) const {
  const std::vector<ObstacleKey>& keys = data_->keys;
  if (!data_->next_key) return key < obstacle_count() ? static_cast<ObstacleId>(key) : kNone;
  const auto at = std::ranges::lower_bound(keys, key);
  return at != keys.end() && *at == key ? static_cast<ObstacleId>(at - keys.begin()) : kNone;
}

bool World::has_bounds() const { return data_->has_bounds; }

World::VertexRange World::vertices_of(ObstacleId o) const {
  return {data_->region_starts[o], data_->region_starts[o + 1]};
}

std::span<const VertexId> World::ring_starts(ObstacleId o) const {
  const std::size_t first = data_->region_rings[o];
  return std::span(data_->ring_starts).subspan(first, data_->region_rings[o + 1] - first);
}

Polygon World::polygon_of(ObstacleId o) const {
  Polygon polygon;
  const std::span<const VertexId> starts = ring_starts(o);
  for (std::size_t r = 0; r < starts.size(); ++r) {
    const VertexId end = r + 1 < starts.size() ? starts[r + 1] : vertices_of(o).last;
    const std::span<const Vec2> ring = vertices().subspan(starts[r], end - starts[r]);
    (r == 0 ? polygon.outer : polygon.holes.emplace_back()).assign(ring.begin(), ring.end());
  }
  return polygon;
}

const Box& World::box_of(ObstacleId o) const { return data_->boxes[o]; }
const Box& World::box() const { return data_->box; }
std::vector<ObstacleId> World::regions_meeting(std::span<const Box> boxes) const {
  return data_->regions_meeting(boxes);
}
const WorldHistory& World::history() const { return data_->history; }
PointLocation World::locate(const Vec2& p, ObstacleId o) const { return data_->locate(p, o); }

World World::from_polygons(std::vector<Polygon> obstacles, std::optional<Ring> bounds) {
  return World(std::move(obstacles), std::move(bounds));
}

World World::from_polygons(std::vector<Polygon> obstacles, const Polygon& bounds) {
  if (!bounds.holes.empty())
    throw WorldError("bounds: a polygon with " + std::to_string(bounds.holes.size()) +
                         (bounds.holes.size() == 1 ? " hole" : " holes") + ", must have none; make holes obstacles",
                     static_cast<ObstacleId>(obstacles.size()));
  return World(std::move(obstacles), bounds.outer);
}

World World::from_polygons(const std::vector<Ring>& obstacles, std::optional<Ring> bounds) {
  std::vector<Polygon> polygons;
  polygons.reserve(obstacles.size());
  for (const Ring& ring : obstacles) polygons.push_back({ring, {}});
  return World(std::move(polygons), std::move(bounds));
}

std::string to_string(const World& world) {
  const std::size_t obstacles = world.obstacle_count(), vertices = world.vertices().size();
  return std::to_string(obstacles) + (obstacles == 1 ? " obstacle of " : " obstacles of ") + std::to_string(vertices) +
         (vertices == 1 ? " vertex" : " vertices") + (world.has_bounds() ? " within bounds" : "");
}

}  // namespace arcway
