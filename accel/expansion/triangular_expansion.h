#pragma once

#include <cstdint>
#include <vector>

#include "accel/expansion/sight_map.h"
#include "accel/expansion/sight_trace.h"

namespace arcway::internal {

/// What a point sees in all directions, by triangular expansion [Bungiu et al. 2014] through a sight map. Every
/// decision is exact. Immutable and thread-safe.
class TriangularExpansion {
 public:
  /// What is seen through an edge of a triangle, between two directions towards sites; without the limits themselves.
  struct View {
    std::uint32_t right, left;  ///< ends of the edge
    std::uint32_t door;         ///< kNone: a wall
    std::uint32_t low, high;    ///< sites that limit the directions
    Vec2 to_low, to_high;       ///< from the point, rounded
  };
  /// Memory of a question, kept for the next one.
  struct Scratch {
    std::vector<std::uint32_t> triangles;  ///< those at the point, to be set before
    std::vector<std::uint32_t> sites;
    std::vector<View> views, walls;
    std::vector<View> postponed;
  };

  /// @param map, trace  of the same map; outlive this.
  TriangularExpansion(const SightMap& map, const SightTrace& trace)
      : map_(map), trace_(trace), sure_(map.sure_cross_product()) {}

  /// Sets `walls`: what p sees of walls and of the frame, counter-clockwise from +x, `door` being kNone; and appends to
  /// `sites` those that are seen on the way. O(triangles seen).
  void find_walls(const Vec2& p, Scratch& scratch) const;
  /// Sets `sites`: all that p sees, without its own one, in no order, some of them several times. O(triangles seen).
  /// @param own  the site at p, or kNone.
  void find_sites(const Vec2& p, std::uint32_t own, Scratch& scratch) const;

 private:
  void find_views(const Vec2& p, Scratch& scratch) const;
  void look_through(const Vec2& p, const View& view, Scratch& scratch) const;
  void follow_lines_between_walls(const Vec2& p, Scratch& scratch) const;
  void follow_edges_between_obstacles(const Vec2& p, std::uint32_t own, Scratch& scratch) const;
  [[nodiscard]] int side(const Vec2& p, std::uint32_t site, const Vec2& to_site, const SightMap::Door& triangle) const;
  [[nodiscard]] bool is_on(const Vec2& p, std::uint32_t site, std::uint32_t limit) const;
  [[nodiscard]] bool is_of_one_wall(std::uint32_t site) const;

  const SightMap& map_;
  const SightTrace& trace_;
  double sure_;  ///< SightMap::sure_cross_product
};

}  // namespace arcway::internal
