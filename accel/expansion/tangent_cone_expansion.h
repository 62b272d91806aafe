#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "accel/expansion/sleeves.h"
#include "accel/expansion/straight_boundary.h"

namespace arcway::internal {

/// Finds edges of the reduced visibility graph by tangent-cone expansion: from each node it expands only directions
/// that are tangent there.
///
/// A line of sight between two nodes with no convex vertex in between has one of two forms:
/// - It touches nothing between its ends. Then it passes through the interiors of triangles only.
/// - It runs along obstacle edges all the way. A vertex that it touches is not convex: a reflex vertex would block it,
///   and at a straight vertex it runs along the vertex's edges.
///
/// So an expansion needs open cones of directions only, and obstacle edges are followed separately.
///
/// Simple nodes that follow each other around an obstacle from left to right form a convex *chain*, which is expanded
/// as a whole. Consider rays that leave the chain tangentially, with the obstacle on their left. Their starts advance
/// along the chain as they turn counter-clockwise, and no two of them meet. So a cone of such rays crosses triangles
/// like a cone from a single node. A vertex that splits it is visible from the node whose tangent cone contains it.
class TangentConeExpansion {
 public:
  /// @param sleeves, fans  of the triangulation, crossed in one step each; may be null.
  explicit TangentConeExpansion(const FreeSpaceTriangulation& triangulation, const Sleeves* sleeves = nullptr,
                                const LongFans* fans = nullptr);

  /// Finds the edges to the right from the chains that start at a node. After all nodes, each edge is found once.
  void expand_right(std::uint32_t node);
  /// Finds all edges of a node.
  void expand_all(std::uint32_t node);

  /// Takes the edges found since the last call.
  [[nodiscard]] EdgeList take_edges();
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  using Node = FreeSpaceTriangulation::Node;

  /// How a bounding ray is given: from a node towards a point or away from it, or straight down or up. All kinds but
  /// kMet belong to their cone; kMet leads to a point that the expansion has met.
  enum class Kind : std::uint32_t { kMet, kToward, kAway, kDown, kUp };
  struct BoundingRay {
    Vec2 origin;
    Vec2 direction;                ///< rounded
    std::uint32_t from;            ///< position of its node on the chain
    std::uint32_t point_and_kind;  ///< point and kind in one word
    [[nodiscard]] std::uint32_t point() const { return point_and_kind & kPointMask; }
    [[nodiscard]] Kind kind() const { return static_cast<Kind>(point_and_kind >> kPointBits); }
  };
  static constexpr int kPointBits = 29;
  static constexpr std::uint32_t kPointMask = (1u << kPointBits) - 1;
  [[nodiscard]] BoundingRay bounding_ray(Kind kind, std::uint32_t from, std::uint32_t point, const Vec2& at) const;
  [[nodiscard]] BoundingRay straight(Kind down_or_up, std::uint32_t from) const;
  [[nodiscard]] static bool is_closed(const BoundingRay& ray) { return ray.kind() != Kind::kMet; }

  template <Sense kSense>
  void follow_edges(const Node& source);
  /// @param first       point at the other end of the boundary edge that leaves the source.
  /// @param before_end  last point before the end.
  void report_along_boundary(const Node& source, std::uint32_t first, std::uint32_t before_end, std::uint32_t end);

  /// The side of the rays on which the obstacle lies.
  enum class Hand : std::uint8_t { kLeft, kRight };
  template <Hand kHand>
  void expand_from_chain(std::uint32_t first);
  enum class End : std::uint8_t { kLow, kHigh };
  [[nodiscard]] std::uint32_t touch(std::uint32_t low, std::uint32_t high, End from, const Vec2& p) const;

  void expand_right_from(std::uint32_t node);
  void expand_cone(std::uint32_t node, const BoundingRay& low, const BoundingRay& high);
  void expand(std::uint32_t half_edge, const BoundingRay& low, const BoundingRay& high);
  template <bool kHasSleeves, bool kHasFans>
  void expand_through(std::uint32_t half_edge, BoundingRay low, BoundingRay high);
  /// Reports a node as visible from a position of the chain.
  /// @param instead_of  report to replace, because its node is not tangent; kNone: none.
  /// @return the report, to be replaced later; kNone if points may have several nodes.
  std::uint32_t report(std::uint32_t place, std::uint32_t first_node, std::uint32_t instead_of = kNone);
  /// The node of a convex chain beside a sleeve that a ray of the cone touches; it bounds the cone there.
  struct Contact {
    std::uint32_t index = kNone;  ///< on the chain; kNone if the cone passes by
    int own_side = 0;             ///< -1: inside the bounding ray on the chain's side; 0: on it
    int other_side = 0;           ///< -1: beyond the other bounding ray, so that nothing passes; 0: on it
    BoundingRay ray{};
    [[nodiscard]] bool exists() const { return index != kNone; }
    [[nodiscard]] bool leaves_way() const { return !exists() || other_side > 0; }
  };
  /// What `contact` searches.
  struct ChainSearch {
    std::uint32_t nodes;       ///< number of the chain's nodes that the cone reaches
    const BoundingRay& own;    ///< bounding ray on the chain's side
    const BoundingRay* other;  ///< bounding ray on the other side; may be null
    std::uint32_t guess;       ///< see Sleeves::Chain::bounding_node_from
  };
  /// @param passed_before  (position) -> number of the chain's nodes behind that position.
  /// @param touched_from   (index, at) -> position from which a ray to the chain's node `index` starts.
  template <int kStep, class Passed, class From>
  [[nodiscard]] Contact contact(const Sleeves::Chain<kStep>& chain, const ChainSearch& search,
                                const Passed& passed_before, const From& touched_from) const;
  /// Crosses a sleeve. Returns whether rays pass; then `low` and `high` bound them.
  bool pass(const Sleeves::Sleeve& sleeve, BoundingRay& low, BoundingRay& high);
  /// Crosses a sleeve along one of its chains, from a position at its entrance. Returns whether the chain goes on.
  /// @param count  number of nodes to advance; 0 where the chain ends, and the sleeve lies around its last node.
  template <Hand kHand>
  bool pass_along(const Sleeves::Sleeve& sleeve, std::uint32_t count, std::uint32_t place, BoundingRay& near);
  /// Crosses the triangles of a long fan whose pivot lies at one end of a half-edge, up to the first triangle that
  /// splits the cone.
  /// @tparam kPivot  the side of the pivot.
  /// @param ray      bounding ray on the other side.
  /// @return half-edge to go on with; kNone on the boundary.
  template <Hand kPivot>
  [[nodiscard]] std::uint32_t pass_fan(std::uint32_t half_edge, const BoundingRay& ray) const;
  [[nodiscard]] int turn_along(const BoundingRay& ray, std::uint32_t from, std::uint32_t to) const;
  void take_tangent();
  void add(const Node& source, const Node& target);

  [[nodiscard]] const Node& node(std::uint32_t place) const {
    return triangulation_.nodes()[place == alias_ ? alias_of_ : place];
  }
  [[nodiscard]] int side(const BoundingRay& ray, const Vec2& p, std::uint32_t point) const;
  [[nodiscard]] int exact_side(const BoundingRay& ray, std::uint32_t point) const;

  const FreeSpaceTriangulation& triangulation_;
  const Sleeves* sleeves_;
  const LongFans* fans_;
  double sure_;  ///< FreeSpaceTriangulation::sure_cross_product
  Hand hand_ = Hand::kLeft;
  /// Positions on a chain are its nodes, counter-clockwise around the obstacle. The first node of a ring may also have
  /// the position after the last.
  std::uint32_t alias_ = kNone, alias_of_ = kNone;
  struct Postponed {
    std::uint32_t half_edge;
    BoundingRay low, high;
  };
  std::vector<Postponed> stack_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      seen_;  // pairs of nodes; the second ones are tested when they are in the cache
  EdgeList edges_;
  std::uint64_t steps_ = 0;
  std::uint64_t candidates_ = 0;
};

/// Neighbors of a node in the reduced visibility graph, ascending; none for kNone.
/// @param triangulation  must have listed its left edges.
std::vector<VertexId> tangent_neighbors(const FreeSpaceTriangulation& triangulation, std::uint32_t node,
                                        const LongFans* fans = nullptr);

}  // namespace arcway::internal
