#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace arcway::internal
