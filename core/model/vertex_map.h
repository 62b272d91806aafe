#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "arcway/world.h"
#include "arcway/world_change.h"

namespace arcway::internal {

/// How the vertices of two worlds correspond after one or several changes, in memory that depends on what changed only.
/// Vertices that stay keep their order. Those of an added obstacle are in the place of a removed one that has as many,
/// or follow all others, in front of the bounds'. Immutable.
class VertexMap {
 public:
  explicit VertexMap(const WorldChange& change);
  /// @param removed  the vertices of each removed obstacle, before the change, ascending.
  /// @param added    the vertices of each added obstacle, after it, ascending.
  VertexMap(std::vector<World::VertexRange> removed, std::vector<World::VertexRange> added);

  /// The vertex after the changes; kNone if it was removed. O(log obstacles removed or added).
  [[nodiscard]] VertexId after(VertexId before) const;
  /// The vertex before the changes; kNone if it was added. O(log obstacles removed or added).
  [[nodiscard]] VertexId before(VertexId after) const;
  [[nodiscard]] bool is_added(VertexId after) const { return added_.holds(after); }

  /// Whether all vertices that stay keep their numbers, as added obstacles are in the places of removed ones.
  [[nodiscard]] bool keeps_numbers() const;

  /// This map, followed by that of another change. What was added and removed again leaves no trace.
  [[nodiscard]] VertexMap then(const VertexMap& next) const;

  /// A number of first vertices after the changes that are, here and in another map from the same world, the same ones
  /// of before, but for those that were added in one of the two. kNone: all are.
  [[nodiscard]] VertexId aligned_with(const VertexMap& other) const;
  /// The vertices of each obstacle that was added here or in another map, ascending.
  [[nodiscard]] std::vector<World::VertexRange> added_in_either(const VertexMap& other) const;

  /// The vertices of each removed obstacle, before the changes, ascending.
  [[nodiscard]] const std::vector<World::VertexRange>& removed() const { return removed_.all; }
  /// The vertices of each added obstacle, after the changes, ascending.
  [[nodiscard]] const std::vector<World::VertexRange>& added() const { return added_.all; }
  [[nodiscard]] VertexId removed_count() const { return removed_.up_to.back(); }
  [[nodiscard]] VertexId added_count() const { return added_.up_to.back(); }

  /// Calls kept({first, last}, before) for each longest range of vertices after the changes that follow each other from
  /// a vertex before them on, and added({first, last}) for each added obstacle, ascending.
  /// @param vertices  number of vertices after the changes.
  template <class Kept, class Added>
  void visit(VertexId vertices, Kept&& kept, Added&& added) const {
    VertexId here = 0, there = 0;
    std::size_t next_removed = 0;
    const auto visit_kept = [&](VertexId end) {
      while (here < end) {
        VertexId last = end;
        if (next_removed < removed_.all.size()) last = std::min(end, here + removed_.all[next_removed].first - there);
        if (here < last) kept(World::VertexRange{here, last}, there);
        there += last - here;
        here = last;
        while (next_removed < removed_.all.size() && removed_.all[next_removed].first == there)
          there = removed_.all[next_removed++].last;
      }
    };
    for (const World::VertexRange& range : added_.all) {
      visit_kept(range.first);
      added(range);
      here = range.last;
    }
    visit_kept(vertices);
  }

 private:
  // Ranges of vertices of one world that another one has not, ascending.
  struct Ranges {
    explicit Ranges(std::vector<World::VertexRange> ranges);
    [[nodiscard]] bool holds(VertexId v) const;
    /// The number of vertices in front of one that is in none of the ranges, without those that are.
    [[nodiscard]] VertexId place_of(VertexId v) const;
    /// The vertex in none of the ranges that has this many others in front of it that are not, either.
    [[nodiscard]] VertexId at(VertexId place) const;

    std::vector<World::VertexRange> all;
    std::vector<VertexId> up_to;  // number of vertices in ranges in front of each of these; and of all
  };
  Ranges removed_, added_;
};

}  // namespace arcway::internal
