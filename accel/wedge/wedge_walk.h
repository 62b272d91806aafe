#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/wedge/sight_map.h"

namespace arcway {

/// Finds the edges of the reduced visibility graph from its nodes to nodes further to the right.
///
/// A line between two nodes with no convex vertex on the way either touches nothing between its ends, and then it
/// passes through the insides of triangles only; or it runs along obstacle edges all the way. (A vertex that it touches
/// on the way is not convex. A reflex one would block it, a straight one has it run along its edges, and so on in both
/// directions until a vertex that is not straight.) So walks look at open ranges of directions between the vertices
/// that limit them, and edges of obstacles are followed by themselves.
class WedgeWalk {
 public:
  WedgeWalk(const World& world, const SightMap& map) : world_(world), map_(map) {}

  void run(std::uint32_t node);

  [[nodiscard]] std::vector<std::pair<VertexId, VertexId>> take_edges() { return std::move(edges_); }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  using Node = SightMap::Node;

  /// A direction from the source, and which side of it a site is on.
  struct Limit {
    enum class Kind : std::uint8_t { kToward, kAway, kDown, kUp };
    double x, y;         ///< rounded
    std::uint32_t site;  ///< that it leads to, or away from
    Kind kind;
    bool closed;  ///< belongs to the range that it limits
  };
  /// Directions counter-clockwise from low to high, less than a half-turn.
  struct Range {
    Limit low, high;
  };
  struct Step {
    std::uint32_t door;
    Range range;
  };

  void follow_edges(const Node& node);
  void look_through_wedge(std::uint32_t node, const Range& wedge);
  void walk(std::uint32_t door, const Range& range);
  void report(std::uint32_t first_node);
  void add(const Node& target);

  [[nodiscard]] Limit toward(std::uint32_t site, const Vec2& at, bool closed) const;
  [[nodiscard]] Limit away_from(std::uint32_t site, const Vec2& at) const;
  [[nodiscard]] bool leads_right(const Limit& limit) const;
  [[nodiscard]] int side(const Limit& limit, double x, double y, std::uint32_t site) const;
  [[nodiscard]] int exact_side(const Limit& limit, std::uint32_t site) const;

  const World& world_;
  const SightMap& map_;
  const Node* source_ = nullptr;
  std::vector<Step> stack_;
  std::vector<std::pair<VertexId, VertexId>> edges_;
  std::uint64_t steps_ = 0;
  std::uint64_t candidates_ = 0;
};

}  // namespace arcway
