#include "core/motion/gear_words.h"

namespace arcway::internal {

namespace {

// What is driven backwards from a pose to another is driven forwards the other way.
bool is_backwards(std::size_t word) { return word >= kReedsSheppWords + kDubinsWords.size(); }

DubinsWord dubins_word_of(std::size_t word) { return kDubinsWords[(word - kReedsSheppWords) % kDubinsWords.size()]; }

}  // namespace

GearWords::GearWords(const Pose& start, const Pose& goal, const SideRadii& radii)
    : start_(start), goal_(goal), radii_(radii), reeds_shepp_(start, goal, radii.larger()) {}

double GearWords::length(std::size_t word, double most) const {
  if (word < kReedsSheppWords) return reeds_shepp_.length(word, most);
  const bool backwards = is_backwards(word);
  return dubins_length(dubins_word_of(word), backwards ? goal_ : start_, backwards ? start_ : goal_, radii_);
}

std::optional<Path> GearWords::path(std::size_t word) const {
  if (word < kReedsSheppWords) return reeds_shepp_.path(word);
  const bool backwards = is_backwards(word);
  const auto path = dubins_word(dubins_word_of(word), backwards ? goal_ : start_, backwards ? start_ : goal_, radii_);
  if (!path) return std::nullopt;
  return backwards ? reversed(path->segments()) : Path(path->segments().begin(), path->segments().end());
}

}  // namespace arcway::internal
