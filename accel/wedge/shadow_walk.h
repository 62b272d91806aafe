#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/wedge/sight_map.h"

namespace arcway {

/// Finds the nodes from which some point near a place may be seen: all that see one, and others.
///
/// A line of sight from the place leaves the last triangle that meets it through a side that leads away, and then
/// passes through doors. The points of that triangle stand for those of the place. Between doors, sights are limited
/// by the two vertices that they have last been split at: what lies beyond one as seen from all corners of the triangle
/// is in its shadow.
class ShadowWalk {
 public:
  /// @param map  with its left edges listed.
  explicit ShadowWalk(const SightMap& map) : map_(map), seen_(map.nodes().size(), 0) {}

  void look_from(const Box& place);
  /// By node, 1 if it may see one of the places.
  [[nodiscard]] const std::vector<std::uint8_t>& seen() const { return seen_; }

 private:
  struct Range {
    std::uint32_t door;
    std::uint32_t low, high;  ///< sites that all rays pass on the left, on the right; kNone: none
  };
  void walk(const std::uint32_t (&corners)[3], Range range);
  void follow_walls(const Box& place);
  void mark(std::uint32_t first_node);
  [[nodiscard]] bool meets(const std::uint32_t (&corners)[3], const Box& place) const;
  [[nodiscard]] bool all_pass(const std::uint32_t (&corners)[3], std::uint32_t limit, std::uint32_t site,
                              int side) const;

  const SightMap& map_;
  std::vector<std::uint8_t> seen_;
  std::vector<Range> stack_;
  std::size_t steps_ = 0;
};

}  // namespace arcway
