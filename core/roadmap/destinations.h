#pragma once

#include <cstdint>
#include <vector>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// Where the straights from a turn circle may lead to. Asks for rows near the circle. Thread-safe.
class Destinations {
 public:
  /// @param rows, circles  must outlive this.
  Destinations(const World& world, const VisibilityRows& rows, const TurnCircles& circles)
      : world_(world), rows_(rows), circles_(circles) {}

  /// A vertex at the end of a straight, and the side to which a path turns there.
  struct Arrival {
    VertexId vertex;
    Side side;
    VertexId before;
    std::uint32_t passed;  ///< vertices between it and the circle
  };

  /// The vertices that the straights from a circle lead to: those that its own see, and some behind them, past a few
  /// vertices at most: where the straights to a vertex and to the one behind it would have a path turn away from the
  /// vertex in between. Also those that a body's straights lead to where a point's would pass the next vertex of an
  /// obstacle. O(k^2) in the degree k of the vertices, of which all but some k are a product and a comparison each.
  /// @throws Canceled if the clock is over before all are found.
  [[nodiscard]] std::vector<Arrival> from(const TurnCircle& circle, const StopClock& clock = {}) const;

  /// The neighbor on its ring from which a path comes that has the obstacle on a side; kNone if they are no neighbors
  /// in the graph.
  [[nodiscard]] VertexId vertex_before(VertexId v, Side side) const;

  /// Vertices that a straight leads past without a turn. With more of them, rows grow along every jagged wall of a
  /// scanned map without a path found more.
  static constexpr std::uint32_t kMostPassed = 2;
  /// Edges between a circle's vertex and one that it leads to: a vertex before the one and another before the other as
  /// well.
  static constexpr std::uint32_t kMostSteps = kMostPassed + 3;

 private:
  void append_beside(const TurnCircle& circle, std::vector<Arrival>& arrivals) const;
  // Of the smallest radius.
  [[nodiscard]] const TurnCircle& own_circle(VertexId v, Side side) const {
    return circles_.all()[circles_.first_around(v, side)];
  }

  World world_;
  const VisibilityRows& rows_;
  const TurnCircles& circles_;
};

}  // namespace arcway::internal
