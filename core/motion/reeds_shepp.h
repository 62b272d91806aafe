#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"

namespace arcway::internal {

/// Number of words of at most five arcs and lines in both gears. The shortest path of a car between any two poses is
/// among them [Reeds and Shepp 1990, (8.1) to (8.11)]. C is an arc, S a line and | a gear change: CSC (8), C|C|C (4),
/// C|CC and CC|C (8), CC|CC (4), C|CC|C (4), C|CSC and CSC|C (16), C|CSC|C (4).
inline constexpr std::size_t kReedsSheppWords = 48;

/// The path of one word, with arcs of the given radius [m] and of at most half a turn. Nothing where the word does not
/// exist. Segments of zero length are left out; start == goal gives an empty path for some words. Constant time. Error
/// of the end pose: some units in the last place of the coordinates and the radius.
/// @param word  below kReedsSheppWords.
/// @throws std::invalid_argument if the radius is not finite and > 0.
std::optional<Path> reeds_shepp_path(std::size_t word, const Pose& start, const Pose& goal, double radius);

/// Length of the path of one word [m]; infinity where it does not exist.
double reeds_shepp_length(std::size_t word, const Pose& start, const Pose& goal, double radius);

/// Length of the shortest path of a car between two poses without obstacles [m].
double reeds_shepp_distance(const Pose& start, const Pose& goal, double radius);

}  // namespace arcway::internal
