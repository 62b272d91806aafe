#include "accel/expansion/contact_edges.h"

#include <algorithm>

#include "accel/expansion/line_of_sight_trace.h"
#include "accel/expansion/triangular_expansion.h"
#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

class ContactVisibility {
 public:
  ContactVisibility(const World& world, const FreeSpaceTriangulation& triangulation)
      : world_(world), triangulation_(triangulation), trace_(triangulation), expansion_(triangulation, trace_) {}

  void add_edges(const SelfContact& contact, EdgeList& edges) {
    const Vec2& at = world_.vertex(contact.vertex);
    const std::uint32_t point = triangulation_.point_at(at);
    // Edges of the graph end at nodes.
    if (world_.is_covered(contact.vertex) || triangulation_.first_node_at(point) != kNone) return;
    const std::vector<VertexId> seen = tangents_from(at, point);
    const LineSegment& touched = world_.edges()[contact.edge];
    std::vector<VertexId> before, beyond;
    for (const VertexId v : seen) {
      const int side = orientation(touched.a, touched.b, world_.vertex(v));
      if (side != 0) (side > 0 ? before : beyond).push_back(v);
    }
    // They lie on one side of a line, so they have an order by angle around the contact.
    std::ranges::sort(beyond,
                      [&](VertexId v, VertexId w) { return orientation(at, world_.vertex(v), world_.vertex(w)) > 0; });
    for (const VertexId u : before) {
      const auto side = [&](VertexId v) { return orientation(world_.vertex(u), at, world_.vertex(v)); };
      const auto first = std::ranges::partition_point(beyond, [&](VertexId v) { return side(v) < 0; });
      for (auto v = first; v != beyond.end() && side(*v) == 0; ++v) edges.push_back(std::minmax(u, *v));
    }
  }

 private:
  [[nodiscard]] std::vector<VertexId> tangents_from(const Vec2& at, std::uint32_t point) {
    scratch_.triangles.clear();
    for (const std::uint32_t corner : trace_.corners_at(point)) scratch_.triangles.push_back(corner - corner % 3);
    expansion_.find_points(at, point, scratch_);
    std::vector<VertexId> seen;
    for (const std::uint32_t s : scratch_.points) {
      if (!triangulation_.is_valid() && triangulation_.is_blocked_by_invalid({at, triangulation_.points()[s]}))
        continue;
      for (std::uint32_t n = triangulation_.first_node_at(s); n != kNone; n = triangulation_.nodes()[n].sibling)
        seen.push_back(triangulation_.nodes()[n].vertex);
    }
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    keep_tangents(world_, at, seen);
    return seen;
  }

  const World& world_;
  const FreeSpaceTriangulation& triangulation_;
  LineOfSightTrace trace_;
  TriangularExpansion expansion_;
  TriangularExpansion::Scratch scratch_;
};

}  // namespace

EdgeList edges_through_contacts(const World& world, const FreeSpaceTriangulation& triangulation) {
  EdgeList edges;
  if (world.self_contacts().empty()) return edges;
  ContactVisibility visibility(world, triangulation);
  for (const SelfContact& contact : world.self_contacts()) visibility.add_edges(contact, edges);
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void add_missing(EdgeList added, std::vector<EdgeList>& lists) {
  if (added.empty()) return;
  std::vector<std::uint8_t> is_there(added.size(), 0);
  for (const EdgeList& list : lists)
    for (const auto& [u, v] : list) {
      const auto at = std::ranges::lower_bound(added, std::pair(std::min(u, v), std::max(u, v)));
      if (at != added.end() && at->first == std::min(u, v) && at->second == std::max(u, v))
        is_there[static_cast<std::size_t>(at - added.begin())] = 1;
    }
  EdgeList& missing = lists.emplace_back();
  for (std::size_t i = 0; i < added.size(); ++i)
    if (is_there[i] == 0) missing.push_back(added[i]);
}

EdgeList both_ways(EdgeList edges) {
  const std::size_t count = edges.size();
  for (std::size_t i = 0; i < count; ++i) edges.emplace_back(edges[i].second, edges[i].first);
  std::ranges::sort(edges);
  return edges;
}

void add_missing(std::span<const EdgeList::value_type> both_ways, VertexId vertex, std::vector<VertexId>& row) {
  const auto first = std::ranges::lower_bound(both_ways, vertex, {}, &EdgeList::value_type::first);
  const auto last = std::ranges::upper_bound(both_ways, vertex, {}, &EdgeList::value_type::first);
  if (first == last) return;
  for (auto edge = first; edge != last; ++edge) row.push_back(edge->second);
  std::ranges::sort(row);
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

void keep_tangents(const World& world, const Vec2& point, std::vector<VertexId>& seen) {
  std::erase_if(seen, [&](VertexId v) { return !world.is_graph_vertex(v) || !is_tangent(world, v, point); });
  // Keeps the nearest vertex in each direction, or all at the nearest point.
  const auto place = [&](VertexId v) -> const Vec2& { return world.vertex(v); };
  const auto around = std::partition(seen.begin(), seen.end(), [&](VertexId v) { return place(v) == point; });
  std::sort(around, seen.end(), [&](VertexId v, VertexId w) {
    if (precedes_about(point, place(v), place(w))) return true;
    return !precedes_about(point, place(w), place(v)) && on_open_segment(place(v), {point, place(w)});
  });
  const Vec2* nearest = &point;
  const auto is_behind = [&](VertexId v) {
    if (on_open_segment(*nearest, {point, place(v)})) return true;
    nearest = &place(v);
    return false;
  };
  seen.erase(std::remove_if(around, seen.end(), is_behind), seen.end());
  std::sort(seen.begin(), seen.end());
}

}  // namespace arcway::internal
