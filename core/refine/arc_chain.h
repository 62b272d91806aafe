#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "core/refine/circle_chain.h"

namespace arcway::internal {

/// A path of arcs and lines as the numbers that an optimizer moves: a chain whose turns are driven in several arcs.
/// Arcs are numbered from 0 on, and line i lies before arc i. A *tied* line has no length: the arcs beside it touch.
/// Headings are those of the body, in either gear. The vehicle stops between a line and an arc of different gears.
struct ArcChain {
  struct Arc {
    Vec2 center;
    double radius;
    double sign;         ///< +1: the center lies to the left of the body
    double entry, exit;  ///< squares of the speeds at its ends [m^2/s^2]
    double gear = 1.0;   ///< +1 forwards, -1 backwards
    /// +1: the heading grows along the arc.
    [[nodiscard]] double turning() const { return gear * sign; }
  };
  struct Line {
    double heading;  ///< not wrapped: all turns are differences of headings
    double length;
    bool is_tied;
    Vec2 ahead = Vec2::Zero();  ///< along the heading, see join
    double gear = 1.0;          ///< as of arcs; 0 where tied arcs are of different gears
    /// How far it leads ahead of the body, negative backwards [m].
    [[nodiscard]] double along() const { return gear * length; }
  };

  Pose start, goal;
  double entry = 0.0, exit = 0.0;  ///< squares of the speeds there [m^2/s^2]
  std::vector<Arc> arcs;
  std::vector<Line> lines;  ///< one more than arcs; the headings of the first and the last one are given
  bool is_joined = true;    ///< long lines follow from circles, see join; else all moves freely and is closed later

  /// The turn on arc i [rad].
  [[nodiscard]] double turn(std::size_t i) const {
    return arcs[i].turning() * (lines[i + 1].heading - lines[i].heading);
  }
  /// Whether the vehicle stops where arc i begins, or where it ends.
  [[nodiscard]] bool stops_before(std::size_t i) const { return lines[i].gear != arcs[i].gear; }
  [[nodiscard]] bool stops_behind(std::size_t i) const { return lines[i + 1].gear != arcs[i].gear; }
  /// What lacks for line i to join the circles beside it [m].
  [[nodiscard]] Vec2 gap(std::size_t i) const {
    const Line& line = lines[i];
    return behind(i) - before(i) - line.along() * line.ahead - offset(i) * perpendicular(line.ahead);
  }
  /// How far the reference point is to the right of the center before line i.
  [[nodiscard]] double sideways(std::size_t i) const { return i > 0 ? arcs[i - 1].sign * arcs[i - 1].radius : 0.0; }
  /// The signed difference of the radii beside line i, which its centers lie apart across it.
  [[nodiscard]] double offset(std::size_t i) const { return (i < arcs.size() ? sideways(i + 1) : 0.0) - sideways(i); }
  /// The center before line i, or the start; and the one behind it, or the goal.
  [[nodiscard]] Vec2 before(std::size_t i) const { return i > 0 ? arcs[i - 1].center : start.position(); }
  [[nodiscard]] Vec2 behind(std::size_t i) const { return i < arcs.size() ? arcs[i].center : goal.position(); }

  /// Puts the parts of the path together again after some have moved. Long lines follow from the circles beside them;
  /// of arcs that are joined by short lines, one keeps its place and the others follow. That is the tightest one, or
  /// the one next to start or goal.
  /// Precondition: is_joined.
  /// @return false if a line cannot be placed.
  bool join();
  /// Whether all turns and all lines that are not tied have more than no length, in their gear.
  [[nodiscard]] bool is_drivable() const;
};

/// How turns are cut into several arcs of one radius.
struct TurnCuts {
  int parts;      ///< of a turn; one more of a large one
  double least;   ///< turn that is cut [rad]
  double widest;  ///< radius from which on turns are as fast as lines, and stay whole [m]
};
/// Cuts the turns of a chain. Lines that are next to nothing become a little longer.
/// @param lines  of the chain.
/// @return false if the chain has no line that is long enough to give way, or a part is driven backwards.
bool cut_turns(const CircleChain& chain, std::span<const Bitangent> lines, const TurnCuts& cuts, ArcChain& result);
/// Cuts the turns of a path in both gears. Its lines are not joined: those that are next to nothing become a little
/// longer. Where the vehicle goes straight on and straight back, it goes less far.
/// @return false for a path without arcs that are longer.
bool cut_turns(std::span<const PathSegment> path, const TurnCuts& cuts, ArcChain& result);

/// A part of a chain as a motion: line i is part 2 i, arc i is part 2 i + 1.
PathSegment segment_of(const ArcChain& chain, std::size_t part);
/// All of a chain's motions that have a length. Takes the place of what was in the path.
void path_of(const ArcChain& chain, Path& path);

/// The circles of a chain of arcs. Arcs that touch do so up to rounding, and neighbors of one radius become one.
void circles_of(const ArcChain& arcs, CircleChain& result);

}  // namespace arcway::internal
