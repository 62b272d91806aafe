#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "arcway/executor.h"
#include "arcway/feasible_graph_snapshot.h"
#include "arcway/heading_set.h"
#include "arcway/query_set.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/vehicle.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/model/side_radii.h"
#include "core/roadmap/added_circles.h"
#include "core/roadmap/destinations.h"
#include "core/roadmap/feasible_graph_inputs.h"
#include "core/roadmap/link_rows.h"
#include "core/roadmap/turn_circle.h"
#include "core/roadmap/turn_circles.h"

namespace arcway::internal {

/// The turn circles of a world and the checks of a feasible graph on them: which headings on a circle are free, which
/// bitangents leave it, and whether the vehicle may drive one. Remembers no answer. Immutable, thread-safe.
class CircleChecks {
 public:
  /// @param executor  used during construction only.
  /// @throws std::invalid_argument if the radii are not as FeasibleGraphInputs says.
  CircleChecks(const FeasibleGraphInputs& inputs, const Executor& executor);
  /// The checks of a world after a change, from those before it, of the same vehicle and radii and without added
  /// circles.
  /// @param may_differ  see VisibilityRows::Changed.
  CircleChecks(const CircleChecks& before, const VertexMap& change, const FeasibleGraphInputs& after,
               std::span<const VertexId> may_differ);
  /// The circles of `base`, which has no added ones, and behind them added ones.
  /// @throws Canceled if the clock is over before all are there.
  CircleChecks(const CircleChecks& base, const Vehicle& vehicle, const AddedCircles& added,
               const StopClock& clock = {});
  CircleChecks(const CircleChecks&) = delete;
  CircleChecks& operator=(const CircleChecks&) = delete;

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const VisibilityRows& rows() const { return *rows_; }
  [[nodiscard]] const TurnCircles& circles() const { return circles_; }
  [[nodiscard]] const Destinations& destinations() const { return destinations_; }

  /// On a circle wider than the smallest only headings of a turn round its vertex: a right angle and some to either
  /// side. None on a circle that is not used.
  [[nodiscard]] HeadingSet free_headings(std::uint32_t circle) const;
  /// Headings of several circles that are used, in their order.
  void free_headings(std::span<const std::uint32_t> circles, std::span<HeadingSet> found) const;

  /// Bitangents that leave a circle at a free heading.
  /// @param free  the circle's free headings.
  /// @param around  if given, becomes the box of all vertices whose rows and circles decide about the bitangents. Where
  ///   none of those in the box has other neighbors, the bitangents are the same. Base circles only.
  /// @throws Canceled if the clock is over before all are found.
  [[nodiscard]] LinkRow departures(std::uint32_t circle, const HeadingSet& free, const StopClock& clock,
                                   Box* around = nullptr) const;

  /// Whether the swept rectangle of a link meets no obstacle.
  [[nodiscard]] bool is_free(const FeasibleLink& link) const;
  /// free[i] = 1 if links[i] is free.
  void are_free(std::span<const FeasibleLink> links, std::span<std::uint8_t> free) const;

 private:
  CircleChecks(const FeasibleGraphInputs& inputs, const SideRadii& smallest_radii, TurnCircles circles);
  [[nodiscard]] TurningBody body_on(std::uint32_t circle) const;
  [[nodiscard]] StraightBody swept_by(const FeasibleLink& link) const;
  void keep_at_vertex(std::uint32_t circle, HeadingSet& found) const;
  template <class Visitor>
  void visit_destinations(std::uint32_t circle, const StopClock& clock, Box* around, Visitor&& visit) const;

  World world_;
  QuerySet queries_;
  Vehicle vehicle_;               // has the shape of the body
  Body body_;                     // with half of the safety margin: what is checked
  std::array<bool, 2> is_round_;  // by side: whether F and the body's reach beside it lie on the body; else other
                                  // points of it touch the vertex first
  SideRadii smallest_radii_;
  std::shared_ptr<const VisibilityRows> rows_;
  TurnCircles circles_;
  Destinations destinations_;
};

}  // namespace arcway::internal
