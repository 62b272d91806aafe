#include "core/motion/gear_words.h"

#include <limits>

namespace arcway::internal {

namespace {

// What is driven backwards from a pose to another is driven forwards the other way.
bool is_backwards(std::size_t word) { return word >= kReedsSheppWords + kDubinsWords.size(); }

std::optional<DubinsPath> dubins(std::size_t word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  const DubinsWord which = kDubinsWords[(word - kReedsSheppWords) % kDubinsWords.size()];
  return is_backwards(word) ? dubins_word(which, goal, start, radii) : dubins_word(which, start, goal, radii);
}

}  // namespace

double gear_word_length(std::size_t word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  if (word < kReedsSheppWords) return reeds_shepp_length(word, start, goal, radii.larger());
  const auto path = dubins(word, start, goal, radii);
  return path ? length_of(path->segments()) : std::numeric_limits<double>::infinity();
}

std::optional<Path> gear_word_path(std::size_t word, const Pose& start, const Pose& goal, const SideRadii& radii) {
  if (word < kReedsSheppWords) return reeds_shepp_path(word, start, goal, radii.larger());
  const auto path = dubins(word, start, goal, radii);
  if (!path) return std::nullopt;
  return is_backwards(word) ? reversed(path->segments()) : Path(path->segments().begin(), path->segments().end());
}

}  // namespace arcway::internal
