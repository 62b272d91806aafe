#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/expansion/bucket_index.h"
#include "accel/expansion/free_space_triangulation.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Follows straight lines from any point through the triangles of a free-space triangulation, exactly. Immutable and
/// thread-safe.
class LineOfSightTrace {
 public:
  /// @param map  lists left edges, and outlives this. O(n log n), about 200 bytes a vertex.
  explicit LineOfSightTrace(const FreeSpaceTriangulation& triangulation);

  /// Where a line of sight ends.
  struct End {
    enum class Kind : std::uint8_t {
      kReached,   ///< at the target
      kBoundary,  ///< before it, at a wall
      kCorner,    ///< before it, at a point behind which lies the inside of an obstacle
      kFrame      ///< before it, beyond all obstacles
    };
    Kind kind;
    std::uint32_t right, left;  ///< points: the wall's ends as seen from the start, or the corner twice
  };
  /// From p towards q != p; beyond q if `endless`.
  /// @param triangles  those at p, at least one.
  [[nodiscard]] End trace(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles, bool endless) const;

  /// The same from a point where no triangle is, if edges lead from there to q outside of all obstacles. O(n).
  [[nodiscard]] std::optional<End> trace_along_edges(const Vec2& p, const Vec2& q, bool endless) const;

  /// The triangles, by first half-edge, that have p inside or on their boundary: none in the inside of obstacles, on a
  /// common edge of two, and beyond the frame.
  void triangles_at(const Vec2& p, std::vector<std::uint32_t>& triangles) const;
  /// Those at a point, each by the first half-edge of the triangle + which of its corners it is.
  [[nodiscard]] std::span<const std::uint32_t> corners_at(std::uint32_t point) const { return corners_.of(point); }
  /// The point at p, or kNone.
  [[nodiscard]] std::uint32_t point_at(const Vec2& p, std::span<const std::uint32_t> triangles) const;

  /// Corners of a triangle, counter-clockwise.
  [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::uint32_t k) const {
    return triangulation_.half_edges()[triangle + (k + 1) % 3].point;
  }
  /// The half-edge out of a triangle between its corner k and the next one; kNone: a wall, or the frame.
  [[nodiscard]] std::uint32_t half_edge_out(std::uint32_t triangle, std::uint32_t k) const {
    return triangulation_.half_edges()[triangle + (k + 1) % 3].left;
  }
  /// Whether a point is a corner of the frame.
  [[nodiscard]] bool is_frame(std::uint32_t point) const {
    return point < 2 || point + 2 >= triangulation_.points().size();
  }

  /// Appends a point, and those behind it that the line from p through it passes before it ends.
  void append_points_on(const Vec2& p, std::uint32_t point, std::vector<std::uint32_t>& points) const;

 private:
  class Line;
  /// From where the line passes a point.
  [[nodiscard]] End trace_from_point(const Line& line, std::uint32_t point) const;
  /// To the end, or the next point on the line.
  /// @param right  left end of the edge that the half-edge is in, which the line crosses.
  [[nodiscard]] std::optional<End> trace_through(const Line& line, std::uint32_t half_edge, std::uint32_t right,
                                                 std::uint32_t left, std::uint32_t& next_point) const;
  [[nodiscard]] End boundary_between(std::uint32_t right, std::uint32_t left) const;
  [[nodiscard]] std::uint32_t next_along_edge(const Line& line, std::uint32_t point) const;

  const FreeSpaceTriangulation& triangulation_;
  BoxTree triangles_;
  BucketIndex corners_;  // first half-edge of a triangle + which corner
};

}  // namespace arcway::internal
