#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/expansion/bucket_index.h"
#include "accel/expansion/free_space_triangulation.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Follows a straight line from any point through the triangles of a free-space triangulation. Exact, immutable and
/// thread-safe.
class LineOfSightTrace {
 public:
  /// @param triangulation  must have listed its left edges, and must outlive this. O(n log n), about 200 bytes a
  ///   vertex.
  explicit LineOfSightTrace(const FreeSpaceTriangulation& triangulation);

  /// Where a line of sight ends.
  struct End {
    enum class Kind : std::uint8_t {
      kReached,   ///< at the target
      kBoundary,  ///< before it, at a boundary edge
      kCorner,    ///< before it, at a point with the inside of an obstacle behind
      kFrame      ///< before it, beyond all obstacles
    };
    Kind kind;
    std::uint32_t right, left;  ///< ends of the boundary edge as seen from the start, or the corner twice
  };
  /// Follows the line from p towards q != p, to q or, if `endless`, beyond it.
  /// @param triangles  the triangles at p, at least one.
  [[nodiscard]] End trace(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles, bool endless) const;

  /// Follows the line from a point that lies in no triangle, along edges that lead to q outside all obstacles. Empty if
  /// no edge does. O(n).
  [[nodiscard]] std::optional<End> trace_along_edges(const Vec2& p, const Vec2& q, bool endless) const;

  /// Triangles that contain p inside or on their boundary, each given by its first half-edge. There are none inside
  /// obstacles, on a common edge of two obstacles, and beyond the frame.
  void triangles_at(const Vec2& p, std::vector<std::uint32_t>& triangles) const;
  /// Corners at a point. Each is the triangle's first half-edge plus the index of the corner.
  [[nodiscard]] std::span<const std::uint32_t> corners_at(std::uint32_t point) const { return corners_.of(point); }
  /// Index of the point at p among the triangles' corners, or kNone.
  [[nodiscard]] std::uint32_t point_at(const Vec2& p, std::span<const std::uint32_t> triangles) const;

  /// Corners of a triangle, counter-clockwise.
  [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::uint32_t k) const {
    return triangulation_.half_edges()[triangle + (k + 1) % 3].point;
  }
  /// Half-edge out of a triangle between its corner k and the next one; kNone on the boundary and on the frame.
  [[nodiscard]] std::uint32_t half_edge_out(std::uint32_t triangle, std::uint32_t k) const {
    return triangulation_.half_edges()[triangle + (k + 1) % 3].left;
  }
  /// Whether a point is a corner of the frame.
  [[nodiscard]] bool is_frame(std::uint32_t point) const {
    return point < 2 || point + 2 >= triangulation_.points().size();
  }

  /// Appends a point and all further points that the line from p through it passes before it ends.
  void append_points_on(const Vec2& p, std::uint32_t point, std::vector<std::uint32_t>& points) const;

 private:
  class Line;
  /// Follows the line onward from a point on it.
  [[nodiscard]] End trace_from_point(const Line& line, std::uint32_t point) const;
  /// Follows the line through a half-edge to its end, or to the next point on the line.
  /// @param right, left  ends of the edge that the line crosses.
  [[nodiscard]] std::optional<End> trace_through(const Line& line, std::uint32_t half_edge, std::uint32_t right,
                                                 std::uint32_t left, std::uint32_t& next_point) const;
  [[nodiscard]] End boundary_between(std::uint32_t right, std::uint32_t left) const;
  [[nodiscard]] std::uint32_t next_along_edge(const Line& line, std::uint32_t point) const;

  const FreeSpaceTriangulation& triangulation_;
  BoxTree triangles_;
  BucketIndex corners_;  // first half-edge of a triangle + index of the corner
};

}  // namespace arcway::internal
