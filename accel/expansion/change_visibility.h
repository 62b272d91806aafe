#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "accel/expansion/free_space_triangulation.h"
#include "arcway/vec2.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Boxes of triangles, and of boundary edges, that follow each other in memory: to find those near a place without
/// looking at all; and the convex hull, beyond which there are no triangles. Immutable. O(n log n) to build, two bytes
/// a vertex.
class TriangleBlocks {
 public:
  explicit TriangleBlocks(const FreeSpaceTriangulation& triangulation);

  /// Ranges of numbers, ascending.
  using Ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  /// All triangles whose box meets one of some boxes, and some others near them.
  [[nodiscard]] Ranges triangles_near(std::span<const Box> boxes) const { return triangles_.near(boxes); }
  /// All points that boundary edges leave whose box meets one of some boxes, and some others.
  [[nodiscard]] Ranges points_near(std::span<const Box> boxes) const { return points_.near(boxes); }
  /// Whether a box lies within the convex hull of all points.
  [[nodiscard]] bool hull_contains(const Box& box) const;

 private:
  // The boxes of things that follow each other.
  struct Blocks {
    explicit Blocks(std::size_t the_count) : count(the_count), boxes(the_count / kInBlock + 1) {}
    [[nodiscard]] Box& of(std::size_t i) { return boxes[i / kInBlock]; }
    void make_tree();
    [[nodiscard]] Ranges near(std::span<const Box> places) const;

    static constexpr std::size_t kInBlock = 64;
    std::size_t count;  // of things
    std::vector<Box> boxes;
    std::vector<std::uint32_t> in_tree;  // blocks that are not empty
    BoxTree tree;                        // of these
  };

  Blocks triangles_, points_;
  std::vector<Vec2> hull_;  // counter-clockwise
};

/// Some of the numbers below a count. Takes memory where some are, and a thousandth of a byte a number elsewhere.
class MarkedNumbers {
 public:
  explicit MarkedNumbers(std::size_t count) : count_(count), pages_(count / kInPage + 1) {}

  void mark(std::uint32_t n);
  void mark_all();
  /// Those marked, ascending.
  [[nodiscard]] std::vector<std::uint32_t> all() const;

 private:
  static constexpr std::size_t kInPage = 4096;
  using Page = std::array<std::uint8_t, kInPage>;

  std::size_t count_;
  std::vector<std::unique_ptr<Page>> pages_;  // null: none are marked there
};

/// Conservative visibility of a change: marks all nodes with a line of sight to some place, and some others.
///
/// A line of sight begins in the place. It leaves the last of its triangles that meet the place through one of their
/// sides, and then crosses half-edges. Each cone is bounded by the ends of that side, then by the two vertices that
/// split it last. A point beyond such a vertex, as seen from all corners of the place, is hidden. No line of sight
/// enters a triangle that meets the place, as it has left the last one, nor one through a side if the whole place lies
/// on the triangle's side of it. Else cones with wide bounds turn around the place, and see no end of triangles.
class ChangeVisibility {
 public:
  /// @param triangulation  must have listed its left edges.
  /// @param blocks  of the triangulation; may be null.
  explicit ChangeVisibility(const FreeSpaceTriangulation& triangulation, const TriangleBlocks* blocks = nullptr)
      : triangulation_(triangulation), blocks_(blocks), seen_(triangulation.nodes().size()) {}

  /// Marks the nodes that may see a point of the places. O(triangles log places + triangles seen), with blocks
  /// O(log triangles) a place in place of the first; marks all nodes once several times as many triangles are seen as
  /// exist.
  void mark_viewers(std::span<const Box> places);
  /// The nodes that may see one of the places, ascending.
  [[nodiscard]] std::vector<std::uint32_t> viewers() const { return seen_.all(); }

 private:
  struct Range {
    std::uint32_t half_edge;
    std::uint32_t low, high;  ///< points that all rays pass on their left and right
  };
  using Corners = std::array<std::uint32_t, 3>;  // points of a triangle's corners
  [[nodiscard]] Corners corners_of(std::size_t triangle) const;
  // Where rays begin.
  struct Source {
    Box place;
    std::array<Vec2, 4> corners;  // of the place
  };
  [[nodiscard]] Box box_of(std::span<const std::uint32_t> points) const;
  void expand_out_of(std::size_t triangle, const Corners& corners, const Box& place);
  void expand(const Source& source, Range range);
  void follow_boundary(const PlanarMap::Edge& boundary);
  void mark(std::uint32_t first_node);
  [[nodiscard]] bool meets(const Corners& corners, const Box& place) const;
  // Whether a ray from a source that has left the triangles at the place may enter another one through a half-edge.
  [[nodiscard]] bool may_enter(const Source& source, std::uint32_t half_edge) const;
  [[nodiscard]] bool all_pass(const Source& source, std::uint32_t through, std::uint32_t point, int side) const;

  const FreeSpaceTriangulation& triangulation_;
  const TriangleBlocks* blocks_;
  MarkedNumbers seen_;  // nodes
  std::vector<Range> stack_;
  std::size_t steps_ = 0;
  bool gives_up_ = false;  // all nodes have been marked
};

}  // namespace arcway::internal
