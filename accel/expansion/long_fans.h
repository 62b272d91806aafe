#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "accel/base/big_vector.h"
#include "accel/expansion/free_space_triangulation.h"
#include "arcway/stop_clock.h"

namespace arcway::internal {

/// Long fans of a free-space triangulation: many consecutive triangles around one point, the *pivot*.
///
/// A ray that passes the pivot crosses the fan's triangles up to the first corner that is not beyond the ray. This
/// class finds that corner in O(log² k) of k triangles, instead of one by one.
///
/// A fan's rim is the chain of the triangles' other corners, counter-clockwise around the pivot, less than half a turn.
/// A binary tree of blocks lies over the rim. Each block stores the part of its corners' convex hull that faces the
/// pivot. If the hull corner nearest to the ray lies beyond it, the whole block does.
class LongFans {
 public:
  struct Fan {
    std::uint32_t pivot;
    std::uint32_t first_half_edge;  ///< offset into the half-edges of all fans
    std::uint32_t triangles;        ///< one less than the corners of the rim
    std::uint32_t first_hull;       ///< offset into the hulls of all fans
  };
  /// A triangle of a fan.
  struct Place {
    const Fan* fan;
    std::uint32_t triangle;
  };

  /// No fans.
  LongFans() = default;
  /// Finds the fans of at least `least` triangles. O(n log n) for n triangles; about 24 bytes a vertex and 12 bytes a
  /// triangle of a long fan.
  /// @throws Canceled once the clock is over.
  LongFans(const FreeSpaceTriangulation& triangulation, std::uint32_t least, const StopClock& clock = {});

  [[nodiscard]] bool empty() const { return fans_.empty(); }
  [[nodiscard]] std::size_t size() const { return fans_.size(); }
  /// The triangle behind a half-edge with the pivot at one end; a null fan if there is none.
  /// @tparam kStep  1: pivot at the left end, fan passed counter-clockwise; -1: pivot at the right end, clockwise.
  template <int kStep>
  [[nodiscard]] Place behind(std::uint32_t half_edge) const {
    const std::uint32_t at = place_[kStep > 0 ? half_edge : Triangulation::next(half_edge)];
    if (at == kNone) return {nullptr, 0};
    const Fan& fan = fans_[fan_of_[at]];
    return {&fan, at - fan.first_half_edge};
  }
  /// Half-edge into a triangle.
  template <int kStep>
  [[nodiscard]] std::uint32_t half_edge(const Fan& fan, std::uint32_t triangle) const {
    const std::uint32_t half_edge = half_edges_[fan.first_half_edge + triangle];
    return kStep > 0 ? half_edge : Triangulation::previous(half_edge);
  }
  /// The last triangle in the direction of passing.
  template <int kStep>
  [[nodiscard]] static std::uint32_t last_triangle(const Fan& fan) {
    return kStep > 0 ? fan.triangles - 1 : 0;
  }

  /// The first triangle, from `from` on, whose far corner stops a ray; nothing if none does.
  /// @param stops  (point) -> whether it does not lie beyond the ray.
  /// @param rises  (point, point) -> whether the second is nearer to the pivot's side of the ray. Exact.
  template <int kStep, class Stops, class Rises>
  [[nodiscard]] std::optional<std::uint32_t> first_stop(const Fan& fan, std::uint32_t from, const Stops& stops,
                                                        const Rises& rises) const {
    constexpr std::int64_t kFarCorner = kStep > 0 ? 1 : 0;  // of triangle 0
    const std::int64_t corner = first_corner<kStep>(fan, from + kFarCorner, stops, rises);
    if (corner < 0 || corner >= corners(fan)) return std::nullopt;
    return static_cast<std::uint32_t>(corner - kFarCorner);
  }

 private:
  static constexpr std::uint32_t kLeaf = 16;  // corners

  [[nodiscard]] static std::uint32_t corners(const Fan& fan) { return fan.triangles + 1; }
  [[nodiscard]] std::uint32_t point(const Fan& fan, std::uint32_t corner) const {
    return rim_[fan.first_half_edge + static_cast<std::size_t>(&fan - fans_.data()) + corner];
  }
  /// Number of full blocks of a level.
  [[nodiscard]] static std::uint32_t blocks(const Fan& fan, std::uint32_t level) {
    return corners(fan) / (kLeaf << level);
  }
  [[nodiscard]] static std::uint32_t levels(const Fan& fan) {
    return static_cast<std::uint32_t>(std::bit_width(corners(fan) / kLeaf));
  }
  [[nodiscard]] std::span<const std::uint32_t> hull(const Fan& fan, std::uint32_t level, std::uint32_t block) const {
    std::uint32_t index = fan.first_hull + block;
    for (std::uint32_t l = 0; l < level; ++l) index += blocks(fan, l);
    return std::span(hull_points_).subspan(hull_starts_[index], hull_starts_[index + 1] - hull_starts_[index]);
  }
  /// The first corner of a rim, from `from` on, that stops a ray; -1 or the number of corners if none does.
  template <int kStep, class Stops, class Rises>
  [[nodiscard]] std::int64_t first_corner(const Fan& fan, std::int64_t from, const Stops& stops,
                                          const Rises& rises) const;
  /// The corner of a hull that lies nearest to the pivot's side.
  template <class Rises>
  [[nodiscard]] static std::uint32_t nearest(std::span<const std::uint32_t> hull, const Rises& rises);

  void add_fan(const FreeSpaceTriangulation& triangulation, std::span<const std::uint32_t> half_edges,
               StopTicker& ticker);
  void add_hulls(const FreeSpaceTriangulation& triangulation, const Fan& fan, StopTicker& ticker);

  std::vector<Fan> fans_;
  BigVector<std::uint32_t> place_;  ///< by half-edge with a pivot at its left end: index of the triangle; else kNone
  std::vector<std::uint32_t> half_edges_;  ///< by triangle
  std::vector<std::uint32_t> fan_of_;
  std::vector<std::uint32_t> rim_;  ///< points by fan and corner
  std::vector<std::uint32_t> hull_starts_{0};
  std::vector<std::uint32_t> hull_points_;
};

template <class Rises>
std::uint32_t LongFans::nearest(std::span<const std::uint32_t> hull, const Rises& rises) {
  std::size_t low = 0, high = hull.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (rises(hull[middle], hull[middle + 1])) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return hull[low];
}

// Blocks double as long as they are passed, and are halved where one is not.
template <int kStep, class Stops, class Rises>
std::int64_t LongFans::first_corner(const Fan& fan, std::int64_t from, const Stops& stops, const Rises& rises) const {
  const std::int64_t end = kStep > 0 ? std::int64_t{corners(fan)} : -1;
  const std::uint32_t most_levels = levels(fan);
  std::int64_t at = from;
  std::uint32_t level = 0;
  while (at != end) {
    const std::int64_t border = kStep > 0 ? at : at + 1, size = std::int64_t{kLeaf} << level;
    const bool is_at_border = border % kLeaf == 0;
    if (is_at_border && level < most_levels && border % size == 0) {
      const auto block = static_cast<std::uint32_t>(kStep > 0 ? border / size : border / size - 1);
      if (block < blocks(fan, level) && !stops(nearest(hull(fan, level, block), rises))) {
        at += kStep * size;
        ++level;
        continue;
      }
    }
    if (is_at_border && level > 0) {
      --level;
      continue;
    }
    do {
      if (stops(point(fan, static_cast<std::uint32_t>(at)))) return at;
      at += kStep;
    } while (at != end && (kStep > 0 ? at : at + 1) % kLeaf != 0);
  }
  return end;
}

}  // namespace arcway::internal
