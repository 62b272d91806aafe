#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/model/vertex_map.h"
#include "core/model/world_history.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// The convex vertices of a world, covered or not, ascending, as pieces of the list of its origin: a list in memory
/// that depends on what has changed since. Immutable.
class ConvexVertices {
 public:
  /// @param of_origin  convex vertices of the origin of this world; null: they are not known, and all are listed.
  ConvexVertices(const World& world, std::shared_ptr<const HugeVector<VertexId>> of_origin);

  [[nodiscard]] std::size_t size() const { return count_; }
  /// O(log changes).
  [[nodiscard]] VertexId operator[](std::size_t i) const;
  /// The place of a vertex in the list; size() if it is not there. O(log vertices).
  [[nodiscard]] std::size_t index_of(VertexId v) const;

 private:
  // Some that follow each other, and are in one of the two arrays.
  struct Piece {
    std::size_t index;  // of the first one
    VertexId first;     // no later than that one
    std::size_t at;     // in the array
    bool is_of_origin;
    VertexId shift;  // of the array's vertices from those of this world
  };
  // The vertices [first, last) of this world, which are those of the origin that begin at a vertex.
  void append_of_origin(const World::VertexRange& range, VertexId begin);
  // Vertices that the origin has not.
  void append_own(const World& world, const World::VertexRange& range);
  [[nodiscard]] std::span<const VertexId> array_of(const Piece& piece) const {
    return piece.is_of_origin ? std::span<const VertexId>(*of_origin_) : std::span<const VertexId>(own_);
  }

  std::shared_ptr<const HugeVector<VertexId>> of_origin_;
  HugeVector<VertexId> own_;
  std::vector<Piece> pieces_;  // none is empty
  std::size_t count_ = 0;
};

/// How the base circles of a world are numbered. It is what remains of them for worlds after changes. Immutable.
class CircleNumbers {
 public:
  /// @param later  history of a world after changes; if it has the same origin, this takes memory for what has changed
  ///   since there only, and for circles around two vertices.
  CircleNumbers(const World& world, const TurnCircles& circles, const WorldHistory& later);

  /// The index that a base circle of a world after changes has here; kNone if it is not here.
  /// @param map  from this world to that one.
  [[nodiscard]] std::uint32_t before(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const;
  /// The index that a circle has after changes; kNone if it is not there.
  [[nodiscard]] std::uint32_t after(std::uint32_t circle, const TurnCircles& after, const VertexMap& map) const;

 private:
  ConvexVertices convex_;
  std::size_t around_ = 0;         // number of circles around one vertex alone
  std::vector<TurnCircle> pairs_;  // around two vertices, by both
};

}  // namespace arcway::internal
