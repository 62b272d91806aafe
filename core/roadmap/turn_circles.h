#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcway/executor.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/roadmap/added_circles.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// The turn circles of a world. Each convex vertex has a left and a right one of each radius. Two neighbors of the
/// reduced graph that are passed on one side may lie so near each other that the bitangent of their circles would lead
/// back, as at the end of a thin wall. The two have a left and a right circle in common, of the smallest radius that
/// leads round vertices, which goes round both. Immutable.
class TurnCircles {
 public:
  /// @param radii  ascending, not empty;  @param grown_body  by the safety margin.
  TurnCircles(const World& world, const VisibilityRows& rows, std::span<const double> radii,
              const Footprint& grown_body, const Executor& executor);

  /// The base circles and behind them added ones: those round a vertex, left before right, then those of the gap
  /// straights, the entries of each before its exits.
  TurnCircles(const TurnCircles& base, const AddedCircles& added);

  /// Those of one vertex first: all of a vertex are neighbors, radii ascending, for each left before right. Then those
  /// of two, left before right.
  [[nodiscard]] std::span<const TurnCircle> all() const { return circles_; }
  /// Whether a vertex is convex and has circles.
  [[nodiscard]] bool has(VertexId v) const { return first_[v] != kNone; }
  /// The circle round a convex vertex alone, of the smallest radius: an index into `all`.
  [[nodiscard]] std::uint32_t first_around(VertexId v, Side side) const {
    return first_[v] + (side == Side::kLeft ? 0 : 1);
  }
  /// Calls visit(circle) for each circle round a convex vertex, alone or with another one: indices into `all`.
  template <class Visitor>
  void visit_around(VertexId v, Side side, Visitor&& visit) const {
    const std::uint32_t right = side == Side::kLeft ? 0 : 1;
    for (std::uint32_t k = 0; k < radius_count_; ++k) visit(first_[v] + 2 * k + right);
    for (const std::uint32_t left : more_.of(v)) visit(left + right);
  }

  /// How many circles are base ones; all that follow are added.
  [[nodiscard]] std::size_t base_count() const { return base_count_; }
  /// Calls visit(circle) for each circle that has this vertex for its first one.
  template <class Visitor>
  void visit_by_first(VertexId v, Visitor&& visit) const {
    if (!has(v)) return;
    for (std::uint32_t c = first_[v]; c < first_[v] + 2 * radius_count_; ++c) visit(c);
    for (const std::uint32_t left : more_.of(v))
      if (circles_[left].vertex == v)
        for (const std::uint32_t c : {left, left + 1}) visit(c);
    for (const std::uint32_t c : beside_.of(v))
      if (circles_[c].vertex == v) visit(c);
  }
  /// Calls visit(circle) for each gap straight's entry that knows this vertex.
  template <class Visitor>
  void visit_entries(VertexId v, Visitor&& visit) const {
    for (const std::uint32_t c : beside_.of(v))
      if (!is_exit(c)) visit(c);
  }
  /// Of a circle: whether it is one of a gap straight, and there an exit.
  [[nodiscard]] bool is_of_gap_straight(std::uint32_t c) const { return c >= first_of_gap_straights_; }
  [[nodiscard]] bool is_exit(std::uint32_t c) const { return is_of_gap_straight(c) && c >= gap_straight_of(c).exits; }
  /// Calls visit(circle) for each exit of an entry's gap straight.
  template <class Visitor>
  void visit_exits_behind(std::uint32_t entry, Visitor&& visit) const {
    for (std::uint32_t c = gap_straight_of(entry).exits; c < gap_straight_of(entry).end; ++c) visit(c);
  }

 private:
  // Circles by a vertex.
  struct VertexBuckets {
    [[nodiscard]] std::span<const std::uint32_t> of(VertexId v) const {
      return starts.empty() ? std::span<const std::uint32_t>()
                            : std::span(circles).subspan(starts[v], starts[v + 1] - starts[v]);
    }
    HugeVector<std::uint64_t> starts;
    std::vector<std::uint32_t> circles;
  };
  // The circles [first, last), one in so many, by the vertices that they know.
  [[nodiscard]] VertexBuckets vertex_buckets(std::size_t first, std::size_t last, std::uint32_t step) const;

  struct GapStraightRange {
    std::uint32_t exits, end;  // circles
  };
  [[nodiscard]] const GapStraightRange& gap_straight_of(std::uint32_t c) const {
    return gap_straights_[gap_straight_[c - first_of_gap_straights_]];
  }

  std::size_t radius_count_;
  HugeVector<TurnCircle> circles_;
  HugeVector<std::uint32_t> first_;  // of each vertex's own circles, or kNone
  VertexBuckets more_;               // the left ones of those that are no vertex's own, gap straights left out
  VertexBuckets beside_;             // those of gap straights
  std::size_t base_count_ = 0, first_of_gap_straights_ = 0;
  std::vector<std::uint32_t> gap_straight_;  // by circle from first_of_gap_straights_ on
  std::vector<GapStraightRange> gap_straights_;
};

}  // namespace arcway::internal
