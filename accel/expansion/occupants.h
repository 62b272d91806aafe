#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "accel/base/shared_pages.h"
#include "accel/expansion/opened_triangulation.h"
#include "arcway/vec2.h"
#include "arcway/world.h"
#include "core/model/vertex_map.h"

namespace arcway::internal {

/// Obstacles with vertices that a triangulation does not know, by the triangles and boundary edges at which they may
/// lie. An obstacle comes and goes in time that depends on what is near it only. Copies share what they have in common.
class Occupants {
 public:
  struct Occupant {
    std::uint32_t number;         ///< of no other occupant
    World::VertexRange vertices;  ///< in the present world
    Box box;                      ///< where it is known to be
  };

  /// Adds an obstacle wherever it may have vertices within a box.
  void add(const OpenedTriangulation& triangulation, const World::VertexRange& vertices, const Box& box);
  /// Adds those near a place to triangles that are new there.
  void spread(const OpenedTriangulation& triangulation, const Box& place);
  /// Goes on to the world after a change: removed ones go.
  void follow(const VertexMap& map);

  /// Numbers of those that may lie in a triangle, by its first half-edge.
  [[nodiscard]] std::span<const SharedTable::Item> in_triangle(std::uint32_t first) const {
    return in_triangles_.of(first / 3);
  }
  /// Numbers of those that may lie on a boundary edge, by the point that it leaves to the right; and some others.
  [[nodiscard]] std::span<const SharedTable::Item> at_point(std::uint32_t point) const { return at_points_.of(point); }
  [[nodiscard]] const Occupant& with_number(std::uint32_t number) const;
  /// Those of all, ascending.
  [[nodiscard]] std::vector<std::uint32_t> numbers() const;
  [[nodiscard]] std::size_t vertex_count() const;

 private:
  struct Places {
    std::vector<std::uint32_t> triangles, points;  // ascending
  };
  struct Known {
    Occupant occupant;
    std::shared_ptr<const Places> places;
  };
  [[nodiscard]] static Places places_of(const OpenedTriangulation& triangulation, const Box& box);
  void put(const OpenedTriangulation& triangulation, Known& known);
  void remove(const Known& known);

  SharedTable in_triangles_, at_points_;
  std::vector<Known> known_;  // ascending by number
  std::uint32_t next_number_ = 0;
};

}  // namespace arcway::internal
