#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/expansion/by_site.h"
#include "accel/expansion/sight_map.h"
#include "core/geometry/box_tree.h"

namespace arcway::internal {

/// Follows straight lines from any point through the triangles of a sight map, exactly. Immutable and thread-safe.
class SightTrace {
 public:
  /// @param map  lists left edges, and outlives this. O(n log n), about 200 bytes a vertex.
  explicit SightTrace(const SightMap& map);

  /// Where a line of sight ends.
  struct End {
    enum class Kind : std::uint8_t {
      kReached,  ///< at the target
      kWall,     ///< before it, at a wall
      kCorner,   ///< before it, at a site behind which lies the inside of an obstacle
      kFrame     ///< before it, beyond all obstacles
    };
    Kind kind;
    std::uint32_t right, left;  ///< sites: the wall's ends as seen from the start, or the corner twice
  };
  /// From p towards q != p; beyond q if `endless`.
  /// @param triangles  those at p, at least one.
  [[nodiscard]] End trace(const Vec2& p, const Vec2& q, std::span<const std::uint32_t> triangles, bool endless) const;

  /// The same from a point where no triangle is, if edges lead from there to q outside of all obstacles. O(n).
  [[nodiscard]] std::optional<End> trace_along_edges(const Vec2& p, const Vec2& q, bool endless) const;

  /// The triangles, by first door, that have p inside or on their boundary: none in the inside of obstacles, on a
  /// common edge of two, and beyond the frame.
  void triangles_at(const Vec2& p, std::vector<std::uint32_t>& triangles) const;
  /// Those at a site, each by the first door of the triangle + which of its corners it is.
  [[nodiscard]] std::span<const std::uint32_t> corners_at(std::uint32_t site) const { return corners_.of(site); }
  /// The site at p, or kNone.
  [[nodiscard]] std::uint32_t site_at(const Vec2& p, std::span<const std::uint32_t> triangles) const;

  /// Corners of a triangle, counter-clockwise.
  [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::uint32_t k) const {
    return map_.doors()[triangle + (k + 1) % 3].site;
  }
  /// The door out of a triangle between its corner k and the next one; kNone: a wall, or the frame.
  [[nodiscard]] std::uint32_t door_out(std::uint32_t triangle, std::uint32_t k) const {
    return map_.doors()[triangle + (k + 1) % 3].left;
  }
  /// Whether a site is a corner of the frame.
  [[nodiscard]] bool is_frame(std::uint32_t site) const { return site < 2 || site + 2 >= map_.sites().size(); }

  /// Appends a site, and those behind it that the line from p through it passes before it ends.
  void append_sites_on(const Vec2& p, std::uint32_t site, std::vector<std::uint32_t>& sites) const;

 private:
  class Line;
  /// From where the line passes a site.
  [[nodiscard]] End trace_from_site(const Line& line, std::uint32_t site) const;
  /// To the end, or the next site on the line.
  /// @param right  left end of the edge that the door is in, which the line crosses.
  [[nodiscard]] std::optional<End> trace_through(const Line& line, std::uint32_t door, std::uint32_t right,
                                                 std::uint32_t left, std::uint32_t& next_site) const;
  [[nodiscard]] End wall_between(std::uint32_t right, std::uint32_t left) const;
  [[nodiscard]] std::uint32_t next_along_edge(const Line& line, std::uint32_t site) const;

  const SightMap& map_;
  BoxTree triangles_;
  BySite corners_;  // first door of a triangle + which corner
};

}  // namespace arcway::internal
