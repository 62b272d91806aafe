#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/base/late_value.h"
#include "core/geometry/box_tree.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// A spatial index of the outlines of all regions, as short pieces. Every edge is in exactly one piece. Immutable and
/// thread-safe. O(n log n) to build, about 35 bytes a vertex. Copies share the data.
class Outlines {
 public:
  explicit Outlines(const World& world);
  /// The outlines of a world after a change, in time that depends on what has changed since the pieces were built. It
  /// shares these, passes over removed ones, and has a tree of its own for added ones. Precondition: can_change.
  Outlines(const Outlines& before, const World& after, const VertexMap& change);
  /// Whether so few pieces have changed since they were built that visits hardly take longer.
  [[nodiscard]] bool can_change(const VertexMap& change) const;

  /// Consecutive edges of a ring.
  struct Piece {
    VertexId first;                ///< vertex at points[0]; the others follow, except at the last point
    std::span<const Vec2> points;  ///< one more than edges [m]; the last one begins the next piece
    const Box& box;                ///< of the points [m]
    [[nodiscard]] std::size_t edge_count() const { return points.size() - 1; }
  };

  /// Pieces have indices below this. Those of a piece stay through changes; the ones of removed pieces are left out.
  /// Without changes, pieces of a ring are consecutive, and so are rings of a region, and regions.
  [[nodiscard]] std::size_t size() const;
  /// The number of pieces that were built, which have the first indices. Added ones follow them.
  [[nodiscard]] std::size_t built_count() const { return built_->boxes.size(); }
  /// Whether the piece of an index is there.
  [[nodiscard]] bool has(std::uint32_t i) const;
  /// Precondition: has(i).
  [[nodiscard]] Piece operator[](std::uint32_t i) const;
  /// The index of the piece with the edge that starts at a vertex. O(log n).
  [[nodiscard]] std::uint32_t index_of(VertexId v) const;

  /// Whether another index has the same pieces, but for added and removed ones.
  [[nodiscard]] bool shares_pieces_with(const Outlines& other) const { return built_ == other.built_; }
  /// The map from the world whose pieces were built; null if it was not changed since.
  [[nodiscard]] const VertexMap* change() const;

  /// The outlines as made anew, for visits whose order matters: these are. Made when first asked for after a change, in
  /// O(n log n), and kept as long as this.
  [[nodiscard]] const Outlines& as_new() const;

  /// The tree of the pieces' boxes. Precondition: unchanged.
  [[nodiscard]] const BoxTree& tree() const { return built_->tree; }

  /// Calls visit(piece) for each piece whose box, and all boxes around it, pass a test, until a call returns false.
  /// Returns whether all calls returned true. See BoxTree::visit_if.
  template <class Test, class Visitor>
  bool visit_if(Test&& passes, Visitor&& visit) const;
  /// Calls visit(piece) for the pieces of visit_if, those near a place early. See BoxTree::visit_near_first.
  template <class Test, class Visitor>
  void visit_near_first(const Vec2& place, Test&& passes, Visitor&& visit) const;

 private:
  // The pieces of some regions.
  struct Pieces {
    Pieces(const World& world, std::span<const ObstacleId> regions);  // ascending
    [[nodiscard]] Piece operator[](std::uint32_t i) const {
      return {starts[i].vertex, std::span(points).subspan(starts[i].point, starts[i + 1].point - starts[i].point),
              boxes[i]};
    }
    [[nodiscard]] std::uint32_t index_of(VertexId v) const {
      return static_cast<std::uint32_t>(std::ranges::upper_bound(starts, v, {}, &Start::vertex) - starts.begin() - 1);
    }

    struct Start {
      VertexId vertex;
      std::uint32_t point;
    };
    HugeVector<Vec2> points;
    HugeVector<Start> starts;  // one more than pieces
    HugeVector<Box> boxes;
    BoxTree tree;
  };
  struct Changed;
  // A piece that was built, as it is now.
  [[nodiscard]] Piece now(std::uint32_t i, VertexId first) const {
    const Piece piece = (*built_)[i];
    return {first, piece.points, piece.box};
  }

  std::shared_ptr<const Pieces> built_;
  std::shared_ptr<const Changed> changed_;  // null: nothing since the pieces were built
};

// What has changed since the pieces were built.
struct Outlines::Changed {
  Changed(const World& after, const VertexMap& the_map);

  World world;
  VertexMap map;  // to this world
  Pieces added;
  LateValue<std::unique_ptr<const Outlines>> anew;
};

template <class Test, class Visitor>
bool Outlines::visit_if(Test&& passes, Visitor&& visit) const {
  if (!changed_) return built_->tree.visit_if(passes, [&](std::uint32_t i) { return visit((*built_)[i]); });
  return built_->tree.visit_if(passes, [&](std::uint32_t i) {
    const VertexId first = changed_->map.after(built_->starts[i].vertex);
    return first == kNone || visit(now(i, first));
  }) && changed_->added.tree.visit_if(passes, [&](std::uint32_t i) { return visit(changed_->added[i]); });
}

template <class Test, class Visitor>
void Outlines::visit_near_first(const Vec2& place, Test&& passes, Visitor&& visit) const {
  if (!changed_) return built_->tree.visit_near_first(place, passes, [&](std::uint32_t i) { visit((*built_)[i]); });
  built_->tree.visit_near_first(place, passes, [&](std::uint32_t i) {
    const VertexId first = changed_->map.after(built_->starts[i].vertex);
    if (first != kNone) visit(now(i, first));
  });
  changed_->added.tree.visit_near_first(place, passes, [&](std::uint32_t i) { visit(changed_->added[i]); });
}

}  // namespace arcway::internal
