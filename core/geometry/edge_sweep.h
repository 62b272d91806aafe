#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "arcway/vec2.h"

namespace arcway::internal {

/// Sweeps the plane from left to right over edges that may touch and overlap, but do not cross [Shamos and Hoey 1976].
/// Exact. "Left" is less by (x, y), so that vertical edges are no special case. Edges must not be single points.
///
/// The sweep visits every distinct end of an edge, ascending, and names the edges there and the one below. Edges that
/// become neighbors are tested: a pair that crosses is reported before the sweep gets to the crossing.
/// O((n + t) log n) for n edges and t pairs of a visited point and an edge that passes through it. Memory about 100
/// bytes an edge.
class EdgeSweep {
 public:
  static constexpr std::uint32_t kNoEdge = 0xFFFFFFFFu;

  /// What the sweep meets at a point.
  struct Event {
    Vec2 at;
    std::uint32_t below;                   ///< the edge just below the point; kNoEdge if there is none
    std::span<const std::uint32_t> left;   ///< edges that end there or pass through, ascending as they are before it
    std::span<const std::uint32_t> right;  ///< edges that start there or pass through, ascending as they are behind it
    std::span<const std::uint32_t> ends;   ///< all edges with an end there, those left out as well; in no useful order
  };

  class Visitor {
   public:
    virtual ~Visitor() = default;
    virtual void visit(const Event& event) = 0;
    /// Edges that cross, or that pass through a visited point in different directions.
    /// @return false to end the sweep; after true at least one of them must be left out.
    virtual bool crosses(std::uint32_t e, std::uint32_t f) = 0;
    /// Whether an edge takes no part. Its ends are visited nevertheless.
    [[nodiscard]] virtual bool is_left_out(std::uint32_t /*edge*/) const { return false; }
  };

  explicit EdgeSweep(std::span<const LineSegment> edges);
  EdgeSweep(const EdgeSweep&) = delete;
  EdgeSweep& operator=(const EdgeSweep&) = delete;

  /// @return whether the sweep got to the end.
  bool run(Visitor& visitor);

 private:
  struct Below {
    using is_transparent = void;
    const EdgeSweep* sweep;
    bool operator()(std::uint32_t e, std::uint32_t f) const;
    bool operator()(std::uint32_t e, const Vec2& p) const { return sweep->side(e, p) > 0; }
    bool operator()(const Vec2& p, std::uint32_t e) const { return sweep->side(e, p) < 0; }
  };
  using Order = std::set<std::uint32_t, Below>;

  [[nodiscard]] const Vec2& low(std::uint32_t e) const { return goes_right_[e] ? edges_[e].a : edges_[e].b; }
  [[nodiscard]] const Vec2& high(std::uint32_t e) const { return goes_right_[e] ? edges_[e].b : edges_[e].a; }
  /// +1 if the point lies above the edge, 0 on its line.
  [[nodiscard]] int side(std::uint32_t e, const Vec2& p) const;

  void list_left(const Vec2& p, std::span<const std::uint32_t> ends);
  void pass(std::span<const std::uint32_t> ends, const Vec2& p, const Visitor& visitor);
  bool test_passing(Visitor& visitor);
  bool test_neighbors(Order::iterator lower, Visitor& visitor);
  void leave(std::uint32_t e);

  std::span<const LineSegment> edges_;
  std::vector<bool> goes_right_;
  Order active_{Below{this}};
  std::vector<Order::iterator> place_;  ///< by edge; the end of `active_` if it is not active
  std::vector<std::uint32_t> left_, right_, passing_;
  std::uint32_t below_ = kNoEdge;
};

/// How many regions cover the places just above each edge during a sweep over their boundaries. Regions lie to the left
/// of their edges.
class SweptDepths {
 public:
  /// @param outside  how many cover the places far away.
  SweptDepths(std::span<const LineSegment> edges, std::int32_t outside)
      : edges_(edges), outside_(outside), above_(edges.size(), 0) {}

  [[nodiscard]] bool is_region_above(std::uint32_t e) const;
  /// State of an edge at the sweep line.
  [[nodiscard]] std::int32_t above(std::uint32_t e) const { return above_[e]; }
  /// Just below the event's point.
  [[nodiscard]] std::int32_t below(const EdgeSweep::Event& event) const {
    return event.below == EdgeSweep::kNoEdge ? outside_ : above_[event.below];
  }
  /// To be called at each event.
  void pass(const EdgeSweep::Event& event) {
    std::int32_t depth = below(event);
    for (const std::uint32_t e : event.right) above_[e] = depth += is_region_above(e) ? 1 : -1;
  }

 private:
  std::span<const LineSegment> edges_;
  std::int32_t outside_;
  std::vector<std::int32_t> above_;  // by edge
};

}  // namespace arcway::internal
