#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "accel/base/shared_pages.h"
#include "accel/expansion/occupants.h"
#include "accel/expansion/opened_triangulation.h"
#include "accel/expansion/straight_boundary.h"
#include "arcway/vec2.h"
#include "arcway/world.h"
#include "core/base/hash_of.h"

namespace arcway::internal {

/// Conservative visibility of a change: marks all nodes with a line of sight to some place, and some others.
///
/// A line of sight begins in the place. It leaves the last of its triangles that meet the place through one of their
/// sides, and then crosses half-edges. Each cone is bounded by the ends of that side, then by the two vertices that
/// split it last. A point beyond such a vertex, as seen from all corners of the place, is hidden. No line of sight
/// enters a triangle that meets the place, as it has left the last one, nor one through a side if the whole place lies
/// on the triangle's side of it. Else cones with wide bounds turn around the place, and see no end of triangles.
///
/// Occupants hide nothing.
class ChangeVisibility {
 public:
  /// @param triangulation  must have listed its left edges, and must outlive this.
  /// @param occupants  of that triangulation; may be null.
  explicit ChangeVisibility(const OpenedTriangulation& triangulation, const Occupants* occupants = nullptr)
      : opened_(triangulation), triangulation_(triangulation.triangulation()), occupants_(occupants) {}

  /// Marks the nodes that may see a point of the places. O(triangles log places + triangles seen), with blocks
  /// O(log triangles) a place in place of the first; marks all nodes once several times as many triangles are seen as
  /// exist.
  void mark_viewers(std::span<const Box> places);
  /// Marks the nodes that may be joined to a convex vertex by a tangent there, and some others: what lies opposite to
  /// the inside of its corner is not looked at.
  void mark_neighbors(const World& world, VertexId vertex);
  /// The nodes that may see one of the places.
  [[nodiscard]] const MarkedNumbers& viewers() const { return seen_; }
  /// Numbers of the occupants that may see one of the places, ascending.
  [[nodiscard]] std::vector<std::uint32_t> occupants() const;

 private:
  struct Range {
    std::uint32_t half_edge;
    std::uint32_t low, high;  ///< points that all rays pass on their left and right
  };
  struct HashOfKnown {
    std::size_t operator()(const std::array<std::uint32_t, 4>& cone) const {
      return hash_of(
          std::array<std::uint64_t, 2>{std::uint64_t{cone[0]} << 32 | cone[1], std::uint64_t{cone[2]} << 32 | cone[3]});
    }
  };
  // Where rays begin.
  struct Source {
    Source(const Box& the_place, std::uint32_t the_number);

    Box place;
    std::array<Vec2, 4> corners;  // of the place
    std::size_t corner_count;     // one of a point
    std::uint32_t number;         // of several
    std::array<Vec2, 2> beside;   // the vertices beside a convex one at the place
    bool is_vertex = false;
  };
  void expand_out_of(std::uint32_t first, const Source& source);
  void expand(const Source& source, const Range& range);
  // Whether a range out of a source is there and not known yet.
  [[nodiscard]] bool is_new(const Source& source, const Range& range);
  // Whether a point lies strictly opposite to the inside of the corner at a source.
  [[nodiscard]] static bool is_opposite(const Source& source, const Vec2& point);
  void mark_from(std::span<const Source> sources);
  void give_up();
  void follow_boundary(const PlanarMap::Edge& boundary);
  template <Sense kSense>
  void follow(const PlanarMap::Edge& boundary);
  void mark(std::uint32_t first_node);
  void see(std::span<const SharedTable::Item> occupants);
  // Whether a ray from a source that has left the triangles at the place may enter another one through a half-edge.
  [[nodiscard]] bool may_enter(const Source& source, std::uint32_t half_edge) const;
  [[nodiscard]] bool all_pass(const Source& source, std::uint32_t through, std::uint32_t point, int side) const;

  const OpenedTriangulation& opened_;
  const FreeSpaceTriangulation& triangulation_;
  const Occupants* occupants_;
  MarkedNumbers seen_;  // nodes
  std::vector<std::uint32_t> seen_occupants_;
  std::vector<Range> stack_;
  std::unordered_set<std::array<std::uint32_t, 4>, HashOfKnown> known_;  // cones: a source's number, and a range
  std::size_t steps_ = 0;
  bool gives_up_ = false;  // all nodes have been marked, and all occupants are seen
};

}  // namespace arcway::internal
