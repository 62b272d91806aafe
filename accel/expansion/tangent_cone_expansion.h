#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "accel/expansion/edge_list.h"
#include "accel/expansion/free_space_triangulation.h"
#include "accel/expansion/long_fans.h"
#include "accel/expansion/sleeves.h"
#include "arcway/executor.h"

namespace arcway::internal {

/// Finds the edges of the reduced visibility graph from its nodes.
///
/// A line between two nodes with no convex vertex on the way either touches nothing between its ends, and then it
/// passes through the insides of triangles only; or it runs along obstacle edges all the way. (A vertex that it touches
/// on the way is not convex. A reflex one would block it, a straight one has it run along its edges, and so on in both
/// directions until a vertex that is not straight.) So walks look at open ranges of directions between the vertices
/// that limit them, and edges of obstacles are followed by themselves.
///
/// Plain nodes that follow each other around an obstacle from left to right are a *run*, and all of a run is looked
/// from at once: rays that leave it tangentially, with the obstacle on their left, say, begin further and further along
/// the run as they turn counter-clockwise, and no two of them meet. So a range of them is passed through triangles like
/// one that leaves from a single node; the vertex that splits it is seen from the node whose tangent cone it lies in.
class TangentConeExpansion {
 public:
  /// @param sleeves, fans  of the map, to be passed at once; may be null.
  explicit TangentConeExpansion(const FreeSpaceTriangulation& triangulation, const Sleeves* sleeves = nullptr,
                                const LongFans* fans = nullptr);

  /// Edges to the right of the nodes of the runs that start at a node: after all nodes, each edge is found once.
  void expand_right(std::uint32_t node);
  /// All edges of a node.
  void expand_all(std::uint32_t node);

  /// Those found since they were last taken.
  [[nodiscard]] EdgeList take_edges();
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  using Node = FreeSpaceTriangulation::Node;

  /// What limits a range: a ray from a node towards a point or away from it, or straight down or up. All but those
  /// towards points that walks have met belong to the range.
  enum class Kind : std::uint32_t { kMet, kToward, kAway, kDown, kUp };
  struct BoundingRay {
    Vec2 origin;
    Vec2 direction;                ///< rounded
    std::uint32_t from;            ///< the node, by its place on the run
    std::uint32_t point_and_kind;  ///< point and kind
    [[nodiscard]] std::uint32_t point() const { return point_and_kind & kPointMask; }
    [[nodiscard]] Kind kind() const { return static_cast<Kind>(point_and_kind >> kPointBits); }
  };
  static constexpr int kPointBits = 29;
  static constexpr std::uint32_t kPointMask = (1u << kPointBits) - 1;
  [[nodiscard]] BoundingRay bounding_ray(Kind kind, std::uint32_t from, std::uint32_t point, const Vec2& at) const;
  [[nodiscard]] BoundingRay straight(Kind down_or_up, std::uint32_t from) const;
  [[nodiscard]] static bool is_closed(const BoundingRay& ray) { return ray.kind() != Kind::kMet; }

  void follow_edges_right(const Node& source);
  void follow_edges_left(const Node& source);
  /// @param first       point at the other end of a wall that leaves the source.
  /// @param before_end  point before the last one.
  void report_along_boundary(const Node& source, std::uint32_t first, std::uint32_t before_end, std::uint32_t end);

  /// Where the obstacle lies, as seen along the rays.
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
  /// @param instead_of  what has been reported and is not tangent; kNone if nothing is.
  /// @return to be replaced later on; kNone if points may have several nodes.
  std::uint32_t report(std::uint32_t place, std::uint32_t first_node, std::uint32_t instead_of = kNone);
  /// What limits a range along a wall: the node that a ray of the range touches.
  struct Contact {
    std::uint32_t index = kNone;  ///< of the wall; kNone if the range passes by
    int own_side = 0;             ///< -1 if within the range's limit on the side of the wall, 0 if on it
    int other_side = 0;           ///< -1 if beyond the other limit, so that nothing passes; 0 if on it
    BoundingRay ray{};
    [[nodiscard]] bool exists() const { return index != kNone; }
    [[nodiscard]] bool leaves_way() const { return !exists() || other_side > 0; }
  };
  /// @param nodes           how many of the wall are reached.
  /// @param own, other      limits of the range; `other` may be none.
  /// @param guess           see Sleeves::Chain::bounding_node_from.
  /// @param passed_before   how many nodes of the wall are behind a place of the run.
  /// @param touched_from    the place from which a ray to the wall's node `index`, at some place, starts.
  template <int kStep, class Passed, class From>
  [[nodiscard]] Contact contact(const Sleeves::Chain<kStep>& chain, std::uint32_t nodes, const BoundingRay& own,
                                const BoundingRay* other, std::uint32_t guess, const Passed& passed_before,
                                const From& touched_from) const;
  /// Passes a sleeve. Returns whether anything comes through; then the limits are what does.
  bool pass(const Sleeves::Sleeve& sleeve, BoundingRay& low, BoundingRay& high);
  /// Passes a sleeve along one of its walls, from a place of the run at its entrance. Returns whether the run goes on.
  /// @param count  nodes to go: those of the wall; or none, where the run ends, and then the triangles around the
  /// place.
  template <Hand kHand>
  bool pass_along(const Sleeves::Sleeve& sleeve, std::uint32_t count, std::uint32_t place, BoundingRay& near);
  /// Passes the triangles of a long fan whose pivot is on one side of a half-edge, up to the first one that the range
  /// does not pass by.
  /// @param kPivot  the side.
  /// @param limit   of the range, on the other side.
  /// @return the half-edge to go on with; kNone: a wall.
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
  /// Places on a run are its nodes, counter-clockwise around the obstacle; a ring's first node may also be one past the
  /// last.
  std::uint32_t alias_ = kNone, alias_of_ = kNone;
  struct Postponed {
    std::uint32_t half_edge;
    BoundingRay low, high;
  };
  std::vector<Postponed> stack_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seen_;  // nodes, to be tested once the second ones are at hand
  EdgeList edges_;
  std::uint64_t steps_ = 0;
  std::uint64_t candidates_ = 0;
};

/// The neighbors of a node in the reduced visibility graph, ascending; none for kNone. Needs a map that lists left
/// edges.
std::vector<VertexId> tangent_neighbors(const FreeSpaceTriangulation& triangulation, std::uint32_t node,
                                        const LongFans* fans = nullptr);

/// Triangles that walks to the right enter, of a node on average: from some nodes all over the map.
/// @param executor  only asked whether to end. @throws Cancelled then
double steps_per_node(const FreeSpaceTriangulation& triangulation, const Executor& executor,
                      const LongFans* fans = nullptr);

/// The long fans of a map where walks are very long, and much shorter with them; else none. O(n log n).
/// @param executor  only asked whether to end. @throws Cancelled then
LongFans worthwhile_fans(const FreeSpaceTriangulation& triangulation, const Executor& executor);

}  // namespace arcway::internal
