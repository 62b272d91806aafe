#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/executor.h"
#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/base/spare.h"
#include "core/model/vertex_map.h"
#include "core/model/world_history.h"
#include "core/roadmap/added_circles.h"
#include "core/roadmap/circle_radii.h"
#include "core/roadmap/circles_by_vertex.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// The turn circles of a world. Each convex vertex has a left and a right circle of each radius. Those of a covered
/// vertex are there for their indices only: which number a circle has depends on no obstacle around it, so that a
/// change moves few of them. Two vertices at the end of a thin wall may be so close that the bitangent of their circles
/// would lead backwards. Such neighbors in the reduced graph, passed on one side, share a left and a right circle
/// around both. These have the smallest radii that lead around vertices. Left and right circles of a vertex have the
/// same center only if the body reaches as far and turns as tightly to both sides. Immutable.
class TurnCircles {
 public:
  /// @param radii  not empty.
  /// @param grown_body  the body grown by the safety margin [m].
  TurnCircles(const World& world, const VisibilityRows& rows, const CircleRadii& radii, const Footprint& grown_body,
              const Executor& executor);

  /// The base circles of a world after a change, from those before it, of the same radii and body: the same as made
  /// anew. It asks for rows of close vertices that may have other neighbors only. It takes the arrays of circles that
  /// are gone and came from the same ones by changes. Circles of obstacles that only one of the two worlds has are made
  /// again, and all that follow where these are not as many.
  /// @param rows  of the world after the change.
  /// @param may_differ  see VisibilityRows::Changed.
  TurnCircles(const TurnCircles& before, const VertexMap& change, const World& after, const VisibilityRows& rows,
              std::span<const VertexId> may_differ, const CircleRadii& radii, const Footprint& grown_body);

  /// The base circles, followed by added ones: those around a vertex, then those of the gap straights, entries before
  /// exits.
  /// @throws Canceled if the clock is over before all are there.
  TurnCircles(const TurnCircles& base, const AddedCircles& added, const StopClock& clock = {});

  TurnCircles(const TurnCircles& other) = default;
  TurnCircles(TurnCircles&& other) noexcept = default;
  TurnCircles& operator=(const TurnCircles&) = delete;
  ~TurnCircles();

  /// All circles. Those of single vertices come first, all of one vertex together: index = first + 2 * radius index +
  /// (right ? 1 : 0). Circles of two vertices follow.
  [[nodiscard]] std::span<const TurnCircle> all() const { return circles_; }
  /// Whether a vertex is a graph vertex: convex and not covered. Only its circles are used.
  [[nodiscard]] bool has(VertexId v) const { return first_[v] < kCovered; }
  [[nodiscard]] bool is_used(std::uint32_t c) const { return c >= own_count_ || has(circles_[c].vertex); }
  /// The number of circles that are used.
  [[nodiscard]] std::size_t used_count() const { return circles_.size() - unused_count_; }
  /// The circle of smallest radius around a convex vertex alone, as an index into all().
  [[nodiscard]] std::uint32_t first_around(VertexId v, Side side) const {
    return (first_[v] & ~kCovered) + (side == Side::kLeft ? 0 : 1);
  }
  /// Calls visit(circle) for each circle around a graph vertex, alone or with another one.
  template <class Visitor>
  void visit_around(VertexId v, Side side, Visitor&& visit) const {
    const std::uint32_t right = side == Side::kLeft ? 0 : 1;
    for (std::uint32_t k = 0; k < radius_count_; ++k) visit(first_[v] + 2 * k + right);
    visit_more(v, side, visit);
  }

  /// The number of circles around single vertices.
  [[nodiscard]] std::size_t own_count() const { return own_count_; }
  /// The number of base circles. The added ones follow them.
  [[nodiscard]] std::size_t base_count() const { return base_count_; }
  /// Calls visit(circle) for each circle of which this is the first vertex.
  template <class Visitor>
  void visit_by_first(VertexId v, Visitor&& visit) const {
    if (!has(v)) return;
    for (std::uint32_t c = first_[v]; c < first_[v] + 2 * radius_count_; ++c) visit(c);
    const auto visit_if_first = [&](std::uint32_t c) {
      if (circles_[c].vertex == v) visit(c);
    };
    for (const Side side : {Side::kLeft, Side::kRight}) visit_more(v, side, visit_if_first);
    for (const CirclesByVertex::Entry& entry : beside_.of(v)) visit_if_first(entry.circle);
  }
  /// Calls visit(circle) for each entry of a gap straight that refers to this vertex.
  template <class Visitor>
  void visit_entries(VertexId v, Visitor&& visit) const {
    for (const CirclesByVertex::Entry& entry : beside_.of(v))
      if (!is_exit(entry.circle)) visit(entry.circle);
  }
  /// Whether a circle belongs to a gap straight, and whether it is an exit of one.
  [[nodiscard]] bool is_of_gap_straight(std::uint32_t c) const { return c >= first_of_gap_straights_; }
  [[nodiscard]] bool is_exit(std::uint32_t c) const { return is_of_gap_straight(c) && c >= gap_straight_of(c).exits; }
  /// Calls visit(circle) for each exit of an entry's gap straight.
  template <class Visitor>
  void visit_exits_behind(std::uint32_t entry, Visitor&& visit) const {
    for (std::uint32_t c = gap_straight_of(entry).exits; c < gap_straight_of(entry).end; ++c) visit(c);
  }

 private:
  struct PairRule;
  // Base circles of a world, as others of the same origin may use them again.
  struct Arrays {
    WorldHistory history;  // of their world
    HugeVector<TurnCircle> circles;
    HugeVector<std::uint32_t> first;
  };
  // The circles that these came from by changes, and where their arrays go when they are gone.
  struct Origin {
    Origin() = default;
    Origin(const Origin& other) : spare(other.spare) {}
    Origin(Origin&&) noexcept = default;
    Origin& operator=(const Origin&) = delete;

    std::shared_ptr<Spare<Arrays>> spare = std::make_shared<Spare<Arrays>>();
    std::unique_ptr<Arrays> room;  // null if there was no change, and in copies
  };
  struct OwnRule;
  // Takes arrays of circles that are gone, and makes them those of the first vertices of a world after a change, as far
  // as the numbers of circles are the same ones.
  void take_arrays(const OwnRule& rule);
  // Writes the own circles of an obstacle's vertices. False, and nothing is written, if they were another number of
  // circles.
  bool exchange(const World::VertexRange& range, const OwnRule& rule);
  // Gives a vertex its number of circles, the next ones, if it is convex. Returns whether it is.
  bool number(const World& world, VertexId v, std::size_t next);
  // The circles around two vertices before a change that are not there after it, or may be others, ascending.
  [[nodiscard]] std::vector<std::uint32_t> pairs_gone(const TurnCircles& before, const VertexMap& change,
                                                      const World& after, std::span<const VertexId> may_differ) const;
  // Completes the base circles after a change.
  // @param gone   circles of before around two vertices that are left out, ascending.
  // @param fresh  others, ascending by their vertices.
  void take_pairs(const TurnCircles& before, const VertexMap& change, std::span<const std::uint32_t> gone,
                  std::span<const TurnCircle> fresh);
  // The vertices that circles of [first, last) refer to.
  [[nodiscard]] CirclesByVertex by_vertex(std::size_t first, std::size_t last, const StopClock& clock) const;
  // Calls visit(circle) for each circle of a side around a vertex that is not its own.
  template <class Visitor>
  void visit_more(VertexId v, Side side, Visitor&& visit) const {
    for (const CirclesByVertex::Entry& entry : more_.of(v))
      if (circles_[entry.circle].side == side) visit(entry.circle);
  }

  // Beyond all circles.
  static constexpr std::uint32_t kCovered = 0x80000000u;

  struct GapStraightRange {
    std::uint32_t exits, end;  // circles
  };
  [[nodiscard]] const GapStraightRange& gap_straight_of(std::uint32_t c) const {
    return gap_straights_[gap_straight_[c - first_of_gap_straights_]];
  }

  std::size_t radius_count_;
  std::size_t own_count_ = 0;     // of circles around single vertices, where those around two begin
  std::size_t unused_count_ = 0;  // of these, around covered vertices
  Origin origin_;
  HugeVector<TurnCircle> circles_;
  HugeVector<std::uint32_t> first_;  // of each vertex's own circles, with kCovered if it is covered; or kNone
  CirclesByVertex more_;             // circles around vertices that are not a vertex's own
  CirclesByVertex beside_;           // circles of gap straights
  std::size_t base_count_ = 0, first_of_gap_straights_ = 0;
  std::vector<std::uint32_t> gap_straight_;  // by circle from first_of_gap_straights_ on
  std::vector<GapStraightRange> gap_straights_;
};

}  // namespace arcway::internal
