#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/wedge/sight_map.h"

namespace [[gnu::visibility("default")]] arcway {

/// Where triangles follow each other between two convex walls, and one cannot but go on from the first to the last:
/// what is seen there is found by binary search, along each of the walls, instead of triangle by triangle.
///
/// A wall is followed over vertices with plain nodes only, from left to right or from right to left: it turns by less
/// than half a circle. A strip that does otherwise is several.
class Strips {
 public:
  /// Seen by somebody who enters it. Walls are the nodes that they reach, one after the other.
  struct Strip {
    std::uint32_t exit;         ///< the door behind its last triangle
    std::uint32_t first_left;   ///< the wall on the left: this node, the next one around the obstacle, ...
    std::uint32_t left_count;   ///< so many
    std::uint32_t first_right;  ///< the wall on the right: this node, the one before it, ...
    std::uint32_t right_count;
    std::uint32_t first_turn;  ///< see left_before
  };

  /// One of a strip's walls, as the nodes that are passed.
  struct Wall {
    const SightMap::Node* first;
    int step;  ///< 1 on the left, -1 on the right
    std::uint32_t count;
    [[nodiscard]] const SightMap::Node& node(std::uint32_t i) const {
      return first[step * static_cast<std::ptrdiff_t>(i)];
    }
    /// Which way a point q lies from the ray from s through p: +1 behind the wall's side of it, -1 on the other side.
    [[nodiscard]] int turn(const Vec2& s, const Vec2& p, const Vec2& q) const;
    /// The node that limits what is seen from s past the first nodes; kNone if that is the end of the door before them.
    /// @param passed  nodes of the wall that were passed before s, if s is on the other wall: 0 if it is not.
    /// @param guess   a node that may be near it, or kNone.
    [[nodiscard]] std::uint32_t limit_from(const Vec2& s, std::uint32_t nodes, std::uint32_t passed,
                                           std::uint32_t guess = kNone) const;
  };

  /// None.
  Strips() = default;
  /// Those of at least so many triangles. O(triangles), the same for any executor.
  Strips(const SightMap& map, std::uint32_t least, const Executor& executor = SerialExecutor());

  [[nodiscard]] bool empty() const { return strips_.empty(); }
  [[nodiscard]] std::size_t size() const { return strips_.size(); }
  /// That which is entered by a door, nullptr if none is.
  [[nodiscard]] const Strip* behind(std::uint32_t door) const {
    const Mark& mark = marks_[door / kDoorsPerMark];
    const std::uint64_t bit = std::uint64_t{1} << door % kDoorsPerMark;
    if ((mark.doors & bit) == 0) return nullptr;
    return &strips_[mark.before + static_cast<std::uint32_t>(std::popcount(mark.doors & (bit - 1)))];
  }

  [[nodiscard]] static Wall left_wall(const SightMap& map, const Strip& strip) {
    return {map.nodes().data() + strip.first_left, 1, strip.left_count};
  }
  [[nodiscard]] static Wall right_wall(const SightMap& map, const Strip& strip) {
    return {map.nodes().data() + strip.first_right, -1, strip.right_count};
  }
  /// How many nodes of the right wall are passed before the one of the left wall with this index.
  [[nodiscard]] std::uint32_t right_before(const Strip& strip, std::uint32_t left) const {
    return turns_[strip.first_turn + left];
  }
  [[nodiscard]] std::uint32_t left_before(const Strip& strip, std::uint32_t right) const {
    const auto turns = std::span(turns_).subspan(strip.first_turn, strip.left_count);
    return static_cast<std::uint32_t>(std::upper_bound(turns.begin(), turns.end(), right) - turns.begin());
  }

 private:
  static constexpr std::uint32_t kDoorsPerMark = 64;
  struct Mark {
    std::uint64_t doors = 0;   ///< by bit, whether a strip begins there
    std::uint32_t before = 0;  ///< strips that begin at doors before these
  };

  std::vector<Mark> marks_;           // of 64 doors each
  std::vector<Strip> strips_;         // in the order of their doors
  std::vector<std::uint32_t> turns_;  // by node of a left wall
};

/// Those that take less time to be found and passed than their triangles one by one. None unless most vertices are on
/// long convex walls.
Strips worthwhile_strips(const World& world, const SightMap& map, const Executor& executor = SerialExecutor());

}  // namespace arcway
