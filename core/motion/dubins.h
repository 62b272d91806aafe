#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "arcway/path.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

enum class DubinsWord { kLSL, kRSR, kLSR, kRSL, kRLR, kLRL };
inline constexpr std::array<DubinsWord, 6> kDubinsWords = {DubinsWord::kLSL, DubinsWord::kRSR, DubinsWord::kLSR,
                                                           DubinsWord::kRSL, DubinsWord::kRLR, DubinsWord::kLRL};

/// The segments of a Dubins word, three at most.
struct DubinsPath {
  std::array<PathSegment, 3> parts;
  std::size_t count = 0;
  [[nodiscard]] std::span<const PathSegment> segments() const { return std::span(parts).first(count); }
};

/// The path of one Dubins word between two poses, with arcs of the given radii [Dubins 1957; closed forms of Shkel and
/// Lumelsky 2001]. The shortest path is one of these words for different radii as well [Bakolas and Tsiotras 2011].
/// Nothing where the word does not exist. Segments of zero length are left out; start == goal gives an empty path for
/// LSL and RSR. Constant time. Error of the end pose: a few units in the last place of the coordinates.
/// @throws std::invalid_argument if a radius is not finite and > 0.
std::optional<DubinsPath> dubins_word(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii);
/// Length of the path of dubins_word [m]; infinity where the word does not exist.
double dubins_length(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii);
/// The path of dubins_word as a Path.
std::optional<Path> dubins_path(DubinsWord word, const Pose& start, const Pose& goal, const SideRadii& radii);

}  // namespace arcway::internal
