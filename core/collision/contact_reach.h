#pragma once

#include <cstdint>
#include <vector>

#include "arcway/path.h"
#include "arcway/vec2.h"
#include "arcway/vehicle.h"
#include "core/model/outlines.h"
#include "core/zones/one_way_zones.h"

namespace arcway::internal {

/// Distance to contact: how far a body that is free at a pose drives on a line or an arc before it touches an edge, or
/// is driven against a one-way zone. It compares with the edges near by, however wide the arc is. Results are rounded:
/// motions are decided by the sweep query. Not thread-safe: it keeps the edges near one pose.
class ContactReach {
 public:
  /// @param outlines  must outlive this, as must the shape of the body.
  /// @param zones  null: none. Must outlive this.
  /// @param forwards  the gear in which motions are driven that lead forwards from a pose: kReverse if they are driven
  ///   back to it.
  ContactReach(const Outlines& outlines, const Body& body, const OneWayZones* zones = nullptr,
               Gear forwards = Gear::kForward);

  /// Collects the edges that motions of length `most` [m] from a pose may touch. O(log n + edges near by).
  void begin(const Pose& pose, double most);

  /// Length of the motion from the pose of `begin` until the body touches an edge or a zone forbids it [m]. At most the
  /// length given to `begin`, and less than a full turn. O(edges near by).
  /// @param curvature  [1/m], positive to the left of the body; 0: a line.
  [[nodiscard]] double operator()(double curvature, Gear gear) const;

  /// Number of edges compared with motions so far, as a measure of cost.
  [[nodiscard]] std::uint64_t edges_compared() const { return edges_compared_; }

 private:
  [[nodiscard]] double until_contact(double curvature, Gear gear) const;
  [[nodiscard]] double along_line(Gear gear) const;
  [[nodiscard]] double of_shape_along_line(Gear gear) const;
  [[nodiscard]] double distance_to_body(const LineSegment& edge) const;

  struct Edge {
    double distance;  // from the body, at least
    LineSegment segment;
  };

  const Outlines* outlines_;
  Body body_;
  const OneWayZones* zones_;
  Gear forwards_;
  Pose pose_;      // of `begin`
  double around_;  // radius about the reference point that holds the body [m]
  double most_ = 0.0;
  mutable std::uint64_t edges_compared_ = 0;
  std::vector<Edge> edges_;  // in the frame of the body, those nearest to it first
};

}  // namespace arcway::internal
