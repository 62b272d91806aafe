#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// How a world came from another one, its origin, by changes: what tells the parts that two worlds of one origin have
/// in common, in memory that depends on what has changed. Immutable.
class WorldHistory {
 public:
  /// Of no origin: has nothing in common with any.
  WorldHistory() = default;
  /// Of an origin itself.
  /// @param origin  a number that no other one has; not 0.
  /// @param vertices  of its obstacles, without the bounds.
  WorldHistory(std::uint64_t origin, VertexId vertices) : origin_(origin), map_({}, {vertices, vertices}) {}
  /// After one more change.
  /// @param flipped  vertices after the change that were there before, but covered then and not now, or the other way
  ///   round.
  /// @param convex   convex vertices of the origin, ascending.
  WorldHistory(const WorldHistory& before, const VertexMap& change, const std::vector<VertexId>& flipped,
               std::shared_ptr<const HugeVector<VertexId>> convex);

  /// From the origin to the world.
  [[nodiscard]] const VertexMap& map() const { return map_; }

  /// A number of first vertices that two worlds have in common, with their positions and edges. 0 if they have
  /// different origins.
  [[nodiscard]] VertexId common_with(const WorldHistory& other) const;
  /// The vertices that the origin has as well and that are covered in one of the two worlds only, ascending. None if
  /// the two have different origins.
  [[nodiscard]] std::vector<VertexId> flipped_from(const WorldHistory& other) const;

  /// Whether two worlds have one origin.
  [[nodiscard]] bool has_origin_of(const WorldHistory& other) const { return origin_ == other.origin_ && origin_ != 0; }
  /// The convex vertices of the origin, covered or not, ascending; null if nothing has changed since.
  [[nodiscard]] const std::shared_ptr<const HugeVector<VertexId>>& convex_of_origin() const { return convex_; }

 private:
  std::uint64_t origin_ = 0;
  VertexMap map_{{}, {0, 0}};
  std::shared_ptr<const HugeVector<VertexId>> convex_;
  std::vector<VertexId> flipped_;  // of the origin, ascending: whether they are covered differs from there
};

}  // namespace arcway::internal
