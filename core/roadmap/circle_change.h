#pragma once

#include <cstdint>
#include <vector>

#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/geometry/near_boxes.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// Turn circles before and after a change of the world, and where what was found out about them still holds. Immutable.
class CircleChange {
 public:
  /// A world's circles and the rows that they are of.
  struct Circles {
    const World& world;
    const VisibilityRows& rows;
    const TurnCircles& circles;
  };
  /// Asks for all rows of both. Precondition: circles of the same radii.
  /// @param steps  of is_still_around.
  CircleChange(const Circles& before, const Circles& after, const WorldChange& change, const Footprint& grown_body,
               std::uint32_t steps);

  /// The same circle before, or after, or kNone. Circles that stay keep their order.
  [[nodiscard]] std::uint32_t before(std::uint32_t circle) const { return before_[circle]; }
  [[nodiscard]] std::uint32_t after(std::uint32_t circle_before) const { return after_[circle_before]; }

  /// Whether nothing came or went where a body can reach on circles round this vertex.
  [[nodiscard]] bool is_quiet_at(VertexId v) const { return quiet_[v] != 0; }
  /// Whether that is so and the vertex has the neighbors that it had.
  [[nodiscard]] bool keeps_row(VertexId v) const { return quiet_[v] == kKeepsRow; }
  /// Only if all vertices that are so many steps away keep their rows, and all between any two of them is quiet.
  [[nodiscard]] bool is_still_around(VertexId v) const { return still_[v] != 0; }
  /// Whether nothing came or went where a body can reach between circles round two vertices.
  [[nodiscard]] bool is_quiet_between(VertexId u, VertexId v) const {
    return !places_.may_meet(world_.vertex(u), world_.vertex(v));
  }

 private:
  enum Quiet : std::uint8_t { kNotQuiet, kQuiet, kKeepsRow };
  void match(const Circles& before, const Circles& after, const std::vector<VertexId>& moved);
  void find_still(const VisibilityRows& rows, std::uint32_t steps);

  World world_;
  std::vector<std::uint32_t> before_, after_;
  NearBoxes places_;
  std::vector<std::uint8_t> quiet_, still_;  // by vertex
};

}  // namespace arcway::internal
