#pragma once

#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "core/base/infinity.h"
#include "core/model/side_radii.h"
#include "core/motion/dubins.h"
#include "core/motion/reeds_shepp.h"

namespace arcway::internal {

/// Number of words in both gears between two poses: those of Reeds and Shepp, then those of Dubins, driven forwards and
/// driven backwards, which never change gear. Words of Reeds and Shepp have one radius, the larger one of both sides.
inline constexpr std::size_t kGearWords = kReedsSheppWords + 2 * kDubinsWords.size();

/// These words between two poses. Not to be shared by threads.
class GearWords {
 public:
  /// @throws std::invalid_argument if a radius is not finite and > 0.
  GearWords(const Pose& start, const Pose& goal, const SideRadii& radii);

  /// Length of the path of one word [m]; infinity where it does not exist, and maybe where it is longer than `most`
  /// [m].
  /// @param word  below kGearWords.
  [[nodiscard]] double length(std::size_t word, double most = kInfinity) const;
  /// The path of one word, with arcs of the given radii; nothing where the word does not exist. Constant time.
  [[nodiscard]] std::optional<Path> path(std::size_t word) const;

 private:
  Pose start_, goal_;
  SideRadii radii_;
  ReedsSheppWords reeds_shepp_;
};

}  // namespace arcway::internal
