#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "core/model/side_radii.h"
#include "core/motion/dubins.h"
#include "core/motion/reeds_shepp.h"

namespace arcway::internal {

/// Words in both gears between two poses: those of Reeds and Shepp, then those of Dubins, driven forwards and driven
/// backwards, which never change gear. Words of Reeds and Shepp have one radius, the larger one of both sides.
inline constexpr std::size_t kGearWords = kReedsSheppWords + 2 * kDubinsWords.size();

/// Length of the path of one word [m]; infinity where it does not exist.
/// @param word  below kGearWords.
/// @throws std::invalid_argument if a radius is not finite and > 0.
double gear_word_length(std::size_t word, const Pose& start, const Pose& goal, const SideRadii& radii);

/// The path of one word, with arcs of the given radii; nothing where the word does not exist. Constant time.
/// @throws std::invalid_argument if a radius is not finite and > 0.
std::optional<Path> gear_word_path(std::size_t word, const Pose& start, const Pose& goal, const SideRadii& radii);

}  // namespace arcway::internal
