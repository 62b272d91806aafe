#pragma once

#include <optional>
#include <span>
#include <vector>

#include "arcway/path.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

/// A path as a chain of the circles it turns on, joined by their directed bitangents. The first circle is tangent to
/// the line through the start along its heading, the last one to that through the goal. These two are placed by the
/// straight lengths before and behind them; the others are free.
struct CircleChain {
  Pose start;
  Pose goal;
  double lead_in = 0.0;             ///< straight from the start to the first circle [m], >= 0
  double lead_out = 0.0;            ///< straight from the last circle to the goal [m], >= 0
  std::vector<TurnCircle> circles;  ///< at least two

  /// The first circle for a straight of `lead` [m] before it, and the last one for such a straight behind it.
  [[nodiscard]] TurnCircle first_circle(double lead, double radius, Side side) const;
  [[nodiscard]] TurnCircle last_circle(double lead, double radius, Side side) const;
  /// The straight to the goal behind the last circle.
  [[nodiscard]] Bitangent last_line(double lead) const;
  /// Moves the first and the last circle to where their radii and the straights put them.
  void place_ends();
};

/// The chain of a path of arcs and lines. Neighboring arcs on one circle count as one. Turns by more than a full circle
/// are lost.
/// @return nothing for fewer than two circles.
std::optional<CircleChain> chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal);
/// Overload that writes into a chain whose memory is used again.
/// @return false for fewer than two circles.
bool chain_of(std::span<const PathSegment> path, const Pose& start, const Pose& goal, CircleChain& chain);

/// The directed bitangent of two circles. Circles that touch, up to rounding, are joined where they touch.
/// @return nothing if they have no bitangent.
std::optional<Bitangent> joint_of(const TurnCircle& from, const TurnCircle& to);

/// The straight lines of a chain, one more than circles: through the start, between the circles, through the goal.
/// Error of both ends of a line: a few units in the last place of the coordinates and radii.
/// @return nothing if two neighbors have no bitangent, see joint_of.
std::optional<std::vector<Bitangent>> lines_of(const CircleChain& chain);
/// Overload that writes into a vector whose memory is used again.
/// @return false if two neighbors have no bitangent.
bool lines_of(const CircleChain& chain, std::vector<Bitangent>& lines);

/// The path along the lines of a chain. Its arcs are shorter than a full circle; there are no segments of zero length.
Path path_of(const CircleChain& chain, std::span<const Bitangent> lines);
/// Overload that writes into a path whose memory is used again.
void path_of(const CircleChain& chain, std::span<const Bitangent> lines, Path& path);

}  // namespace arcway::internal
