#pragma once

#include <array>
#include <optional>

#include "arcway/path.h"

namespace arcway::internal {

/// Two arcs, or lines, that lead from one pose to another and meet without a kink [Bolton 1975]. Of the curves of one
/// family that join two poses of a bending corridor they bend the least, so that they keep to its middle.
/// @param ratio  of the second tangent length to the first, > 0: which of the family.
/// @returns nothing if there is none driven forwards, or if an arc is tighter than `radius` or wider than
///   kWidestTurn times that without being straight. Constant time.
std::optional<std::array<PathSegment, 2>> biarc(const Pose& start, const Pose& goal, double ratio, double radius);

/// Arcs that are wider than this, in smallest turning radii, lose digits of their centers' coordinates.
inline constexpr double kWidestTurn = 1e4;

}  // namespace arcway::internal
