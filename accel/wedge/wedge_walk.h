#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/wedge/sight_map.h"

namespace [[gnu::visibility("default")]] arcway {

/// Finds the edges of the reduced visibility graph from its nodes.
///
/// A line between two nodes with no convex vertex on the way either touches nothing between its ends, and then it
/// passes through the insides of triangles only; or it runs along obstacle edges all the way. (A vertex that it touches
/// on the way is not convex. A reflex one would block it, a straight one has it run along its edges, and so on in both
/// directions until a vertex that is not straight.) So walks look at open ranges of directions between the vertices
/// that limit them, and edges of obstacles are followed by themselves.
class WedgeWalk {
 public:
  explicit WedgeWalk(const SightMap& map) : map_(map) {}

  /// Edges of a node to nodes further to the right: each edge is found from one of its ends.
  void look_right(std::uint32_t node);
  /// All edges of a node.
  void look_around(std::uint32_t node);

  [[nodiscard]] std::vector<std::pair<VertexId, VertexId>> take_edges() { return std::move(edges_); }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  using Node = SightMap::Node;

  /// A direction from the source: towards a site, or one that limits the wedge.
  struct Limit {
    double x, y;       ///< rounded
    std::uint32_t id;  ///< the site, or one of the two below
  };
  static constexpr std::uint32_t kWedgeLow = 0xFFFFFFFEu;
  static constexpr std::uint32_t kWedgeHigh = 0xFFFFFFFFu;

  /// What limits a wedge: a direction towards a site or away from it, or straight down or up. All but the directions
  /// towards sites that walks have met belong to the range that they limit.
  struct WedgeLimit {
    enum class Kind : std::uint8_t { kToward, kAway, kDown, kUp };
    Vec2 direction;  ///< rounded
    std::uint32_t site;
    Kind kind;
  };

  void follow_edges_right();
  void follow_edges_left();
  /// @param first       site at the other end of a wall that leaves the source.
  /// @param before_end  site before the last one.
  void report_along_wall(std::uint32_t first, std::uint32_t before_end, std::uint32_t end);
  void look_through_wedge(std::uint32_t node);
  void walk(std::uint32_t door, Limit low, Limit high);
  void report(std::uint32_t first_node);
  void add(const Node& target);

  [[nodiscard]] bool leads_right(const WedgeLimit& limit) const;
  [[nodiscard]] int side(const Limit& limit, double x, double y, std::uint32_t site) const;
  [[nodiscard]] int exact_side(std::uint32_t limit, std::uint32_t site) const;
  [[nodiscard]] bool is_closed(const Limit& limit) const { return limit.id >= kWedgeLow; }

  const SightMap& map_;
  const Node* source_ = nullptr;
  WedgeLimit wedge_low_{}, wedge_high_{};
  struct Postponed {
    std::uint32_t door;
    Limit low, high;
  };
  std::vector<Postponed> stack_;
  std::vector<std::pair<VertexId, VertexId>> edges_;
  std::uint64_t steps_ = 0;
  std::uint64_t candidates_ = 0;
};

/// The neighbours of a node in the reduced visibility graph, ascending; none for kNone. Needs a map that lists left
/// edges.
std::vector<VertexId> tangent_neighbours(const SightMap& map, std::uint32_t node);

}  // namespace arcway
