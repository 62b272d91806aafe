#pragma once

// Private to datasets: what the generators share.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "arcway/polygon.h"
#include "datasets/io/random.h"

namespace arcway::internal::detail {

/// A map under construction and how far it is.
struct Layout {
  Layout(std::size_t vertices, std::uint64_t seed) : random(seed), wanted(vertices) {}

  Random random;
  std::size_t wanted;      ///< vertices
  std::size_t placed = 0;  ///< vertices of obstacles and bounds
  MapFile map;

  void add(Ring outer, std::vector<Ring> holes = {}) {
    placed += outer.size();
    for (const Ring& hole : holes) placed += hole.size();
    map.obstacles.push_back({std::move(outer), std::move(holes)});
  }
  void set_bounds(Ring ring) {
    placed += ring.size();
    map.bounds = std::move(ring);
  }
  [[nodiscard]] std::size_t missing() const { return wanted > placed ? wanted - placed : 0; }
};

/// Takes `wanted` of `slots` slots at random when asked slot by slot.
class Selection {
 public:
  Selection(std::size_t wanted, std::size_t slots) : wanted_(wanted), slots_(slots) {}
  bool take(Random& random) {
    const bool taken = wanted_ > 0 && random.below(slots_) < wanted_;
    --slots_;
    if (taken) --wanted_;
    return taken;
  }

 private:
  std::size_t wanted_, slots_;
};

inline Ring box_ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// Counter-clockwise rectangle with its long axis along the unit vector `along`.
inline Ring rectangle_ring(const Vec2& center, const Vec2& along, double half_length, double half_width) {
  const Vec2 u = along * half_length, v = Vec2(-along.y(), along.x()) * half_width;
  return {center - u - v, center + u - v, center + u + v, center - u + v};
}

/// @throws std::invalid_argument unless `vertices` is from 100 to 10 million.
void check_vertices(const char* kind, std::size_t vertices);

/// Number of columns if `count` cells of this size are to fill about a square, at least 1.
std::size_t square_columns(std::size_t count, double cell_width, double cell_height);

/// Centers of discs that keep the gap from each other and from the square's sides: largest first, at random. Nothing
/// if the square is too full for that. O(discs) on average.
std::optional<std::vector<Vec2>> scatter_discs(Random& random, const std::vector<double>& radii, double side,
                                               double gap);

void lay_out_warehouse(Layout& layout);
void lay_out_parking(Layout& layout);
void lay_out_rooms(Layout& layout);
void lay_out_maze(Layout& layout);
void lay_out_city(Layout& layout);
void lay_out_islands(Layout& layout);
void lay_out_corridor(Layout& layout);
void lay_out_coastline(Layout& layout);

}  // namespace arcway::internal::detail
