#pragma once

#include <cstdint>
#include <vector>

#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/geometry/near_boxes.h"
#include "core/model/vertex_map.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// Where obstacles were added or removed, and all around by a distance [m].
NearBoxes places_of(const WorldChange& change, double reach);

/// The turn circles before and after a change of the world, and where results about them still hold. Immutable.
class CircleChange {
 public:
  /// The circles of a world, and the rows they were made from.
  struct Circles {
    const World& world;
    const VisibilityRows& rows;
    const TurnCircles& circles;
  };
  /// Matches the circles of two worlds. It asks for all rows of both. Precondition: circles of the same radii.
  /// @param steps  number of edges that is_unchanged_around looks at.
  CircleChange(const Circles& before, const Circles& after, const WorldChange& change, const Footprint& grown_body,
               std::uint32_t steps);

  /// The index of a circle before the change, or after it; kNone if it is new, or gone. Circles that stay keep their
  /// order.
  [[nodiscard]] std::uint32_t before(std::uint32_t circle) const { return before_[circle]; }
  [[nodiscard]] std::uint32_t after(std::uint32_t circle_before) const { return after_[circle_before]; }

  /// Whether no obstacle was added or removed where a body can reach on circles around this vertex.
  [[nodiscard]] bool is_unchanged_at(VertexId v) const { return kept_[v] != Kept::kNothing; }
  /// Whether the vertex is unchanged and has the neighbors that it had.
  [[nodiscard]] bool keeps_row(VertexId v) const { return kept_[v] == Kept::kRow; }
  /// Whether all vertices within `steps` edges keep their rows, and the space between any two of them is unchanged.
  [[nodiscard]] bool is_unchanged_around(VertexId v) const { return is_unchanged_around_[v] != 0; }
  /// Whether no obstacle was added or removed where a body can reach between circles around two vertices.
  [[nodiscard]] bool is_unchanged_between(VertexId u, VertexId v) const {
    return !places_.may_meet(world_.vertex(u), world_.vertex(v));
  }

 private:
  // What a vertex keeps: its surroundings, and its row of the reduced graph as well.
  enum class Kept : std::uint8_t { kNothing, kSurroundings, kRow };
  void match(const Circles& before, const Circles& after, const VertexMap& map);
  void find_unchanged_around(const VisibilityRows& rows, std::uint32_t steps);

  World world_;
  std::vector<std::uint32_t> before_, after_;
  NearBoxes places_;                               // where obstacles were added or removed
  std::vector<Kept> kept_;                         // by vertex
  std::vector<std::uint8_t> is_unchanged_around_;  // by vertex
};

}  // namespace arcway::internal
