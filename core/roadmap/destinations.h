#pragma once

#include <cstdint>
#include <vector>

#include "arcway/path.h"
#include "arcway/stop_clock.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// The vertices to which bitangents from a turn circle may lead. It asks for rows near the circle. Thread-safe.
class Destinations {
 public:
  /// @param rows, circles  must outlive this.
  Destinations(const World& world, const VisibilityRows& rows, const TurnCircles& circles)
      : world_(world), rows_(rows), circles_(circles) {}

  /// A vertex at the end of a bitangent, and the side to which a path turns there.
  struct Arrival {
    VertexId vertex;
    Side side;
    VertexId before;
    std::uint32_t passed;  ///< vertices between it and the circle
  };

  /// The vertices to which bitangents from a circle may lead:
  /// - the neighbors of its vertex in the reduced graph;
  /// - vertices behind those, past at most kMostPassed others, where a path would turn away from each vertex in
  ///   between;
  /// - vertices that a point could not turn at without passing the next vertex of an obstacle, but a body can.
  ///
  /// O(k^2) in the degree k of the vertices; all but some k of the steps are a product and a comparison.
  /// @throws Canceled if the clock is over before all are found.
  [[nodiscard]] std::vector<Arrival> from(const TurnCircle& circle, const StopClock& clock = {}) const;

  /// The neighbor of v on its ring from which a path comes that has the obstacle on a side. kNone if the two are not
  /// joined in the graph.
  [[nodiscard]] VertexId vertex_before(VertexId v, Side side) const;

  /// Number of vertices that a bitangent may pass without a turn. A larger number makes rows grow along every jagged
  /// wall of a scanned map, and finds no more paths.
  static constexpr std::uint32_t kMostPassed = 2;
  /// Number of edges between a circle's vertex and a destination: those past vertices, and one before either end.
  static constexpr std::uint32_t kMostSteps = kMostPassed + 3;

 private:
  void append_beside(const TurnCircle& circle, std::vector<Arrival>& arrivals) const;
  // The circle of the smallest radius.
  [[nodiscard]] const TurnCircle& own_circle(VertexId v, Side side) const {
    return circles_.all()[circles_.first_around(v, side)];
  }

  World world_;
  const VisibilityRows& rows_;
  const TurnCircles& circles_;
};

}  // namespace arcway::internal
