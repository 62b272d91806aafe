#pragma once

#include <vector>

#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// How the vertices of two worlds correspond after one or several changes, in memory that depends on what changed only.
/// Vertices that stay keep their order; those of added obstacles follow them, in front of the bounds'. Immutable.
class VertexMap {
 public:
  explicit VertexMap(const WorldChange& change);
  /// @param removed  the vertices of each removed obstacle, before the change, ascending.
  /// @param added    the added vertices, after it.
  VertexMap(std::vector<World::VertexRange> removed, World::VertexRange added);

  /// The vertex after the changes; kNone if it was removed. O(log obstacles removed).
  [[nodiscard]] VertexId after(VertexId before) const;
  /// The vertex before the changes; kNone if it was added. O(log obstacles removed).
  [[nodiscard]] VertexId before(VertexId after) const;
  [[nodiscard]] bool is_added(VertexId after) const { return first_added_ <= after && after < end_added_; }

  /// This map, followed by that of another change. What was added and removed again leaves no trace.
  [[nodiscard]] VertexMap then(const VertexMap& next) const;

  /// The number of first vertices after the changes that are, in this map and in another one from the same world, the
  /// same ones of before.
  [[nodiscard]] VertexId common_with(const VertexMap& other) const;

  /// The vertices of each removed obstacle, before the changes, ascending.
  [[nodiscard]] const std::vector<World::VertexRange>& removed() const { return removed_; }
  /// The added vertices, after the changes.
  [[nodiscard]] World::VertexRange added() const { return {first_added_, end_added_}; }

 private:
  std::vector<World::VertexRange> removed_;
  std::vector<VertexId> removed_up_to_;  // number of vertices removed in front of each of these ranges; and of all
  VertexId first_added_, end_added_;
};

}  // namespace arcway::internal
