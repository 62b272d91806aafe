#pragma once

#include <memory>
#include <span>
#include <vector>

#include "arcway/clearance_preference.h"
#include "arcway/heading_set.h"
#include "arcway/path.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "core/collision/blocked_stations.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// What driving close to obstacles costs: see ClearancePreference. It does not depend on speeds or gears. Close lengths
/// are exact, up to a few units in the last place: on a line those of blocked stations, on an arc those of blocked
/// headings, of the grown body. A body within an obstacle that touches no edge is not noticed. Immutable; thread-safe.
class ClearanceCost {
 public:
  /// @param outlines  of the world.
  ClearanceCost(const Vehicle& vehicle, std::shared_ptr<const Outlines> outlines,
                const ClearancePreference& preference);

  [[nodiscard]] const ClearancePreference& preference() const { return preference_; }
  /// The body grown by the preferred distance.
  [[nodiscard]] const Body& body() const { return body_; }

  /// What F drives close on a segment [m]. O(log n + k log k) for k edges near by.
  [[nodiscard]] double close_length(const PathSegment& segment) const;
  /// The cost of that [s].
  [[nodiscard]] double of(const PathSegment& segment) const { return preference_.cost * close_length(segment); }
  /// The cost of a path [s].
  [[nodiscard]] double of(std::span<const PathSegment> path) const;
  /// The headings at which the grown body touches an obstacle on its circle: disjoint intervals, ascending [rad].
  [[nodiscard]] std::vector<HeadingInterval> close_headings(const TurningBody& turning) const;

 private:
  [[nodiscard]] double close_length(const StraightBody& straight) const;
  [[nodiscard]] double close_angle(const TurningBody& turning, double heading, double angle) const;
  [[nodiscard]] std::vector<HeadingInterval> headings_near(const TurningBody& turning, const Vec2& place,
                                                           double reach) const;

  Vehicle vehicle_;  // has the shape of the body
  std::shared_ptr<const Outlines> outlines_;
  ClearancePreference preference_;
  Body body_;
};

/// How much of a turn lies in a union of intervals [rad].
/// @param angle  of the turn from a heading to a side, >= 0.
double angle_within(std::span<const HeadingInterval> headings, double heading, Side side, double angle);

/// The cost of driving close on a path [s]; 0 without a preference.
/// @param cost  may be null.
inline double clearance_cost(const ClearanceCost* cost, std::span<const PathSegment> path) {
  return cost == nullptr ? 0.0 : cost->of(path);
}

}  // namespace arcway::internal
