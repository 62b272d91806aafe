#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/geometry/box_tree.h"
#include "core/model/outlines.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// A spatial index of a roadmap's circles. Each circle belongs to the piece of outline that has its first vertex.
/// Circles of similar radius share a box. Immutable and thread-safe.
class CirclePlaces {
 public:
  /// @param circles  used during the call only.
  /// @param outlines  if changed, their pieces are those of Outlines::as_new.
  /// @throws Canceled if the clock is over before.
  CirclePlaces(const TurnCircles& circles, const std::shared_ptr<const Outlines>& outlines,
               const StopClock& clock = {});
  /// The index of a world after a change, in time that depends on what has changed since that of `before` was built.
  /// Circles of a piece are looked up when they are first asked for.
  /// @param graph  after the change.
  /// @param outlines  after the change. Precondition: they share pieces with those of `before`.
  /// @param may_differ  see VisibilityRows::Changed: no other vertices that were there before have other circles.
  CirclePlaces(const CirclePlaces& before, std::shared_ptr<const FeasibleGraph> graph,
               std::shared_ptr<const Outlines> outlines, std::span<const VertexId> may_differ);

  /// The pieces that this index refers to.
  [[nodiscard]] const Outlines& outlines() const { return *outlines_; }

  /// Circles of one piece whose radii differ by less than a factor of 2, and their box [m].
  struct Group {
    std::uint32_t first, last;
    Box box;
  };
  /// The circles of one piece.
  struct Circles {
    std::span<const Group> groups;
    const HugeVector<std::uint32_t>& all;
    [[nodiscard]] std::span<const std::uint32_t> of(const Group& group) const {
      return std::span(all).subspan(group.first, group.last - group.first);
    }
  };
  /// Calls visit(piece, index) for each piece that lies, with all of its circles, in a box that passes a test. Pieces
  /// near a position tend to come early: see BoxTree::visit_near_first.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& position, Test&& passes, Visitor&& visit) const {
    const auto visit_piece = [&](std::uint32_t i) { visit((*outlines_)[i], i); };
    if (!changed_) return built_->tree.visit_near_first(position, passes, visit_piece);
    built_->tree.visit_near_first(position, passes, [&](std::uint32_t i) {
      if (is_in_built_tree(i)) visit_piece(i);
    });
    visit_others_near_first(position, passes, visit_piece);
  }
  /// The circles of a piece, by its index.
  [[nodiscard]] Circles of(std::uint32_t piece) const {
    return changed_ ? found(piece) : Circles{built_->groups_of(piece), built_->circles};
  }

 private:
  // The circles of many pieces, one piece behind the other.
  struct Built {
    // Appends the circles of a piece. Returns the box of them and the piece.
    Box append(const Outlines::Piece& piece, const TurnCircles& of);
    [[nodiscard]] std::span<const Group> groups_of(std::uint32_t piece) const {
      return std::span(groups).subspan(first_group[piece], first_group[piece + 1] - first_group[piece]);
    }

    HugeVector<std::uint32_t> circles;
    HugeVector<Group> groups;
    HugeVector<std::uint32_t> first_group{0};  // by piece, one more
    BoxTree tree;                              // of the pieces
  };
  struct Changed;

  [[nodiscard]] bool is_in_built_tree(std::uint32_t piece) const;
  [[nodiscard]] Circles found(std::uint32_t piece) const;
  [[nodiscard]] const BoxTree& other_tree() const;
  [[nodiscard]] std::span<const std::uint32_t> other_pieces() const;
  template <class Test, class Visitor>
  void visit_others_near_first(const Vec2& position, Test&& passes, Visitor&& visit_piece) const {
    other_tree().visit_near_first(position, passes, [&](std::uint32_t k) { visit_piece(other_pieces()[k]); });
  }

  std::shared_ptr<const Outlines> outlines_;
  std::shared_ptr<const Built> built_;
  std::shared_ptr<const Changed> changed_;  // null: nothing since all of it was built
};

}  // namespace arcway::internal
