#pragma once

#include <array>
#include <optional>

#include "arcway/path.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

/// A biarc: two arcs, or lines, that lead from one pose to another and meet without a kink [Bolton 1975]. Of the curves
/// that join two poses of a bending corridor it bends least, and so keeps to the middle.
/// @param ratio  of the second tangent length to the first, > 0: which biarc of the family.
/// @param radii  the smallest ones.
/// @return nothing if there is none driven forwards, or if an arc is tighter than these, or wider than kWidestTurn
///   times that without being straight. Constant time.
std::optional<std::array<PathSegment, 2>> biarc(const Pose& start, const Pose& goal, double ratio,
                                                const SideRadii& radii);

/// Widest radius of an arc, as a multiple of the smallest one. The centers of wider arcs lose digits of their
/// coordinates.
inline constexpr double kWidestTurn = 1e4;

}  // namespace arcway::internal
