#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/stop_clock.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"
#include "core/model/outlines.h"
#include "core/model/side_radii.h"
#include "core/refine/arc_chain.h"
#include "core/refine/banded_ldlt.h"
#include "core/refine/chain_bounds.h"
#include "core/refine/chain_contacts.h"
#include "core/refine/chain_terms.h"
#include "core/refine/chain_unknowns.h"

namespace arcway::internal {

/// A chain of arcs with all that holds it: its bounds, its contacts and its unknowns; and the linear system of a step
/// of all unknowns. Keeps its memory for the next chain.
struct ChainSystem {
  static constexpr double kStiffness = 1.0;  ///< of the chain's equations in the matrix [s/m^2]

  ArcChain chain, trial;  ///< now, and after a step that is tried
  GearSpeeds speeds;
  SideRadii tightest{0.0};  ///< radii of turns
  double unit = 0.0;        ///< length of the body [m]
  std::vector<Bound> bounds;
  ChainContacts contacts;
  ChainUnknowns unknowns;
  BandedLdlt matrix;
  std::vector<double> right, step;  ///< by unknowns; a step is a solution for `right`
  std::vector<Vec2> tensions;       ///< of lines

  /// Begins with `chain`, whose arcs and lines are placed. False if the clock is over before its contacts are found.
  /// @param bodies  that keep off the obstacles.
  [[nodiscard]] bool begin(const Vehicle& vehicle, const ChainContacts::Bodies& bodies,
                           const ChainContacts::Around& around);

  /// Numbers of the unknowns of the arc or line of a contact.
  [[nodiscard]] const Numbers& numbers_at(const ChainContacts::Place& place) const {
    return place.is_on_line() ? unknowns.of_line(place.index()) : unknowns.of_arc(place.index());
  }
  [[nodiscard]] const Numbers& numbers_of(const Bound& bound) const {
    return bound.is_of_line() ? unknowns.of_line(bound.index) : unknowns.of_arc(bound.index);
  }
  [[nodiscard]] const ChainSpeeds& speeds_on(const Bound& bound) const {
    return speeds.in(bound.is_of_line() ? chain.lines[bound.index].gear : chain.arcs[bound.index].gear);
  }
  [[nodiscard]] BoundValue value(const Bound& bound, const ArcChain& of) const {
    return value_of(bound, of, speeds_on(bound), tightest);
  }

  /// Makes the trial: the chain moved by a share of the step. A chain in both gears is closed by a few more steps with
  /// the factors of the matrix.
  /// @return false if parts cannot be placed, or one would have no length in its gear.
  bool move(double share);
  /// Moves a chain in both gears as little as joins its parts up to rounding. Step and factors are lost.
  /// @return false if that fails.
  [[nodiscard]] bool close();
  /// Closes it at the end, when radii may be smaller than allowed, and lines and turns less than nothing, by next to
  /// nothing. Such radii become the smallest ones, and such lines and arcs have no length.
  /// @return false if that fails.
  [[nodiscard]] bool settle();
  /// How far the body moves at most from the chain to the trial [m], as seen at the ends and middles of arcs.
  [[nodiscard]] double movement() const;

 private:
  void place_speeds();
  void move_by(std::span<const double> by, double share, ArcChain& to) const;
  bool close_by_factors(ArcChain& open);
  // An unknown that keeps its value, or two that keep their difference.
  struct Held {
    int number, other;
  };
  bool close_but_for(std::span<const Held> held);
  void hold_turn(std::size_t arc);
  void put_on_limits(double least, double least_turn);

  double closed_ = 0.0;          // gaps that are no larger count as none [m]
  std::vector<double> closing_;  // steps
  std::vector<Held> held_;
  std::vector<double> squares_;  // of speeds, at the ends of arcs
};

/// Moves a chain as little as frees it of small overlaps, whatever its time: a few steps of least squares. What remains
/// is for the exact queries to find. The unknowns' numbers stay, step and tensions are lost.
/// @param clock  asked before each step but the first.
void resolve_overlaps(ChainSystem& system, const StopClock& clock = {});

}  // namespace arcway::internal
