#pragma once

#include <cstdint>
#include <vector>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// How far a body that is free at a pose drives on a line or an arc before it touches an edge of the world: computed
/// from the edges near by, however wide the arc is. Rounded: a motion proposed by it is decided by the sweep query.
/// Not thread-safe: keeps the edges of one place.
class ContactReach {
 public:
  /// @param outlines  must outlive this.
  ContactReach(const Outlines& outlines, const Footprint& body);

  /// Looks at the edges that motions of length `most` from a pose may touch. O(log n + edges near by).
  void begin(const Pose& pose, double most);

  /// Length of the motion from the pose until the body touches an edge, at most that given to `begin` and less than one
  /// full turn [m]. O(edges near by).
  /// @param curvature  positive to the left of the body; 0: a line.
  [[nodiscard]] double operator()(double curvature, Gear gear) const;

  /// Edges that all motions so far were compared with: what they cost.
  [[nodiscard]] std::uint64_t edges_compared() const { return edges_compared_; }

 private:
  [[nodiscard]] double along_line(Gear gear) const;

  struct Edge {
    double distance;  // from the reference point
    LineSegment segment;
  };

  const Outlines* outlines_;
  Footprint body_;
  double around_;  // the body lies within, of its reference point
  double most_ = 0.0;
  mutable std::uint64_t edges_compared_ = 0;
  std::vector<Edge> edges_;  // in the frame of the body, nearest first
};

}  // namespace arcway::internal
