#include "core/motion/gear_words.h"

#include <limits>

namespace arcway::internal {

namespace {

// What is driven backwards from a pose to another is driven forwards the other way.
bool is_backwards(std::size_t word) { return word >= kReedsSheppWords + kDubinsWords.size(); }

std::optional<DubinsPath> dubins(std::size_t word, const Pose& start, const Pose& goal, double radius) {
  const DubinsWord which = kDubinsWords[(word - kReedsSheppWords) % kDubinsWords.size()];
  return is_backwards(word) ? dubins_word(which, goal, start, radius) : dubins_word(which, start, goal, radius);
}

}  // namespace

double gear_word_length(std::size_t word, const Pose& start, const Pose& goal, double radius) {
  if (word < kReedsSheppWords) return reeds_shepp_length(word, start, goal, radius);
  const auto path = dubins(word, start, goal, radius);
  return path ? length_of(path->segments()) : std::numeric_limits<double>::infinity();
}

std::optional<Path> gear_word_path(std::size_t word, const Pose& start, const Pose& goal, double radius) {
  if (word < kReedsSheppWords) return reeds_shepp_path(word, start, goal, radius);
  const auto path = dubins(word, start, goal, radius);
  if (!path) return std::nullopt;
  return is_backwards(word) ? reversed(path->segments()) : Path(path->segments().begin(), path->segments().end());
}

}  // namespace arcway::internal
