#pragma once

#include <memory>
#include <span>
#include <vector>

#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/blocked_stations.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Where motions are driven closer to obstacles than a distance: where the body, grown by the distance, touches an
/// obstacle or the bounds. Speeds and gears do not matter. Lengths are exact, up to a few units in the last place: on a
/// line those of blocked stations, on an arc those of blocked headings, of the grown body. A body within an obstacle
/// that touches no edge is not noticed. Immutable; thread-safe.
class CloseLengths {
 public:
  /// @param outlines  of the world.
  /// @param distance  [m], > 0
  CloseLengths(const Vehicle& vehicle, std::shared_ptr<const Outlines> outlines, double distance);

  [[nodiscard]] double distance() const { return distance_; }
  /// The body grown by the distance.
  [[nodiscard]] const Body& body() const { return body_; }

  /// What F drives close on a segment [m]. O(log n + k log k) for k edges near by.
  [[nodiscard]] double on(const PathSegment& segment) const;
  /// The headings at which the grown body touches an obstacle on its circle: disjoint intervals, ascending [rad].
  [[nodiscard]] std::vector<HeadingInterval> headings_on(const TurningBody& turning) const;

 private:
  [[nodiscard]] double close_length(const StraightBody& straight) const;
  [[nodiscard]] double close_angle(const TurningBody& turning, double heading, double angle) const;
  [[nodiscard]] std::vector<HeadingInterval> headings_near(const TurningBody& turning, const Vec2& place,
                                                           double reach) const;

  Vehicle vehicle_;  // has the shape of the body
  std::shared_ptr<const Outlines> outlines_;
  double distance_;
  Body body_;
};

/// How much of a turn lies in a union of intervals [rad].
/// @param angle  of the turn from a heading to a side, >= 0.
double angle_within(std::span<const HeadingInterval> headings, double heading, Side side, double angle);

}  // namespace arcway::internal
