#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "arcway/path.h"
#include "core/base/infinity.h"

namespace arcway::internal {

/// Number of words of at most five arcs and lines in both gears. The shortest path of a car between any two poses is
/// among them [Reeds and Shepp 1990, (8.1) to (8.11)]. C is an arc, S a line and | a gear change: CSC (8), C|C|C (4),
/// C|CC and CC|C (8), CC|CC (4), C|CC|C (4), C|CSC and CSC|C (16), C|CSC|C (4).
inline constexpr std::size_t kReedsSheppWords = 48;

/// The goal of a word seen from its start, lengths in radii. What several words ask for is computed once.
class ReedsSheppTarget {
 public:
  ReedsSheppTarget() = default;
  ReedsSheppTarget(const Vec2& goal, double heading, double sine, double cosine);

  [[nodiscard]] double heading() const { return heading_; }
  /// From the center of the left circle at the start to that of the left one, or of the right one, at the goal.
  [[nodiscard]] const Vec2& to_left() const { return to_left_; }
  [[nodiscard]] const Vec2& to_right() const { return to_right_; }
  [[nodiscard]] double left_distance() const;
  [[nodiscard]] double left_direction() const;
  /// The turn of an arc that touches both left circles, backwards [rad]; at most 4 radii must be between the centers.
  [[nodiscard]] double left_bend() const;

 private:
  double heading_ = 0.0;
  Vec2 to_left_{0.0, 0.0}, to_right_{0.0, 0.0};
  mutable double left_distance_ = -1.0;  // negative: not known yet
  mutable std::optional<double> left_direction_, left_bend_;
};

/// All words between two poses: cheaper than each by itself. Not to be shared by threads.
class ReedsSheppWords {
 public:
  /// @throws std::invalid_argument if the radius is not finite and > 0.
  ReedsSheppWords(const Pose& start, const Pose& goal, double radius);

  /// See reeds_shepp_length. Infinity may also stand for a word that is longer than `most` [m].
  [[nodiscard]] double length(std::size_t word, double most = kInfinity) const;
  /// See reeds_shepp_path.
  [[nodiscard]] std::optional<Path> path(std::size_t word) const;

 private:
  struct Letter {
    char kind;
    double length;  // signed, in radii
  };
  struct Solution {
    std::array<Letter, 5> letters;
    std::size_t count;
  };
  [[nodiscard]] std::optional<Solution> solve(std::size_t word) const;

  Pose start_;
  double radius_;
  std::array<ReedsSheppTarget, 8> views_;  // driven the other way, in a mirror, from the goal, or several of these
};

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
