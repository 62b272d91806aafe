#pragma once

#include <optional>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// A path as the circles that it turns on, in order, joined by their directed bitangents. The first circle is tangent
/// to the line through the start along its heading, the last one to that through the goal: they are placed by the
/// straight lengths before and behind them, the others are free.
struct CircleChain {
  Pose start;
  Pose goal;
  double lead_in = 0.0;             ///< straight from the start to the first circle [m], >= 0
  double lead_out = 0.0;            ///< straight from the last circle to the goal [m], >= 0
  std::vector<TurnCircle> circles;  ///< at least two

  /// The first circle for a straight length before it, and the last one for a straight length behind it.
  [[nodiscard]] TurnCircle first_circle(double lead, double radius, Side side) const;
  [[nodiscard]] TurnCircle last_circle(double lead, double radius, Side side) const;
  /// The straight to the goal behind the last circle.
  [[nodiscard]] Bitangent last_line(double lead) const;
  /// Moves the first and the last circle to where their radii and the leads put them.
  void place_ends();
};

/// The circles of a path of arcs and lines. Neighboring arcs of one circle count as one.
/// @returns nothing for fewer than two circles. Turns that a path makes by more than a full circle are lost.
std::optional<CircleChain> chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal);
/// The same into a chain whose memory is used again; false for fewer than two circles.
bool chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal, CircleChain& chain);

/// The directed bitangent of two circles. Circles that touch up to rounding are joined where they touch.
/// @returns nothing where they have no bitangent.
std::optional<Bitangent> joint_of(const TurnCircle& from, const TurnCircle& to);

/// The straight lines of a chain, one more than circles: through the start, between the circles, through the goal.
/// @returns nothing where two neighbors have no bitangent, see joint_of. Error of both ends: a few units in the last
///   place of the coordinates and radii.
std::optional<std::vector<Bitangent>> lines_of(const CircleChain& chain);
/// The same into a vector whose memory is used again; false where two neighbors have no bitangent.
bool lines_of(const CircleChain& chain, std::vector<Bitangent>& lines);

/// The path along the lines of a chain; arcs shorter than a full circle, no segments of zero length.
Path path_of(const CircleChain& chain, std::span<const Bitangent> lines);
/// The same into a path whose memory is used again.
void path_of(const CircleChain& chain, std::span<const Bitangent> lines, Path& path);

}  // namespace arcway::internal
