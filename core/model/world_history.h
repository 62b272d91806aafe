#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// How a world came from another one, its origin, by changes: what tells the parts that two worlds of one origin have
/// in common, in memory that depends on what has changed.
class WorldHistory {
 public:
  /// Of no origin: has nothing in common with any.
  WorldHistory() = default;
  /// Of a world that is an origin from now on.
  /// @param origin  a number that no other world or origin has; not 0.
  /// @param so_far  of the same world; of no origin if it was not made by a change.
  WorldHistory(std::uint64_t origin, const WorldHistory& so_far)
      : origin_(origin),
        world_(so_far.world_ != 0 ? so_far.world_ : origin),
        world_before_(so_far.world_before_),
        last_(so_far.last_) {}
  /// After one more change, by which no vertex has become covered yet, or is covered no more.
  /// @param world  a number that no other world or origin has; not 0.
  /// @param convex  convex vertices of the origin, ascending.
  WorldHistory(std::uint64_t world, const WorldHistory& before, const VertexMap& change,
               std::shared_ptr<const HugeVector<VertexId>> convex);
  /// Takes note of the vertices after the last change that were there before, but covered then and not now, or the
  /// other way round.
  void flip(std::span<const VertexId> flipped);

  /// From the origin to the world.
  [[nodiscard]] const VertexMap& map() const { return map_; }

  /// A number of first vertices that two worlds have in common, with their positions and edges, but for those of
  /// obstacles that were added in one of the two. kNone: all; 0 if they have different origins.
  [[nodiscard]] VertexId aligned_with(const WorldHistory& other) const;
  /// The vertices that the origin has as well and that are covered in one of the two worlds only, ascending. None if
  /// the two have different origins.
  [[nodiscard]] std::vector<VertexId> flipped_from(const WorldHistory& other) const;

  /// The change that made this world of another one. Precondition: follows_at_once.
  [[nodiscard]] const VertexMap& last_change() const { return last_; }
  /// Whether this world was made of another one by one change.
  [[nodiscard]] bool follows_at_once(const WorldHistory& other) const {
    return world_before_ == other.world_ && world_before_ != 0;
  }

  /// Whether two worlds have one origin.
  [[nodiscard]] bool has_origin_of(const WorldHistory& other) const { return origin_ == other.origin_ && origin_ != 0; }
  /// The convex vertices of the origin, covered or not, ascending; null if nothing has changed since.
  [[nodiscard]] const std::shared_ptr<const HugeVector<VertexId>>& convex_of_origin() const { return convex_; }

 private:
  std::uint64_t origin_ = 0, world_ = 0, world_before_ = 0;
  VertexMap last_{{}, {}};
  VertexMap map_{{}, {}};
  std::shared_ptr<const HugeVector<VertexId>> convex_;
  std::vector<VertexId> flipped_;  // of the origin, ascending: whether they are covered differs from there
};

}  // namespace arcway::internal
