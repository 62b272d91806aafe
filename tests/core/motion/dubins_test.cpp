#include "core/motion/dubins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "arcway/angle.h"
#include "core/base/infinity.h"

namespace arcway::internal {
namespace {

void expect_reaches(const Path& path, const Pose& start, const Pose& goal, double tolerance) {
  const Pose end = path.empty() ? start : path.back().end();
  EXPECT_NEAR(end.x, goal.x, tolerance);
  EXPECT_NEAR(end.y, goal.y, tolerance);
  EXPECT_NEAR(wrap_signed(end.heading - goal.heading), 0.0, tolerance);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_NEAR((path[i - 1].end().position() - path[i].start.position()).norm(), 0.0, 1e-15);
    EXPECT_EQ(path[i - 1].end().heading, path[i].start.heading);
  }
  for (const PathSegment& segment : path) EXPECT_GT(segment.length, 0.0);
}

/// Length / radius as Shkel and Lumelsky print it, in their coordinates (d, alpha, beta).
std::optional<double> printed_length(DubinsWord word, const Pose& start, const Pose& goal, double radius) {
  const double dx = goal.x - start.x;
  const double dy = goal.y - start.y;
  const double d = std::hypot(dx, dy) / radius;
  const double theta = std::atan2(dy, dx);
  const double a = wrap_positive(start.heading - theta);
  const double b = wrap_positive(goal.heading - theta);
  const double sa = std::sin(a), ca = std::cos(a), sb = std::sin(b), cb = std::cos(b), cab = std::cos(a - b);
  double t = 0.0, p = 0.0, q = 0.0;
  switch (word) {
    case DubinsWord::kLSL:
      p = std::sqrt(std::max(0.0, 2 + d * d - 2 * cab + 2 * d * (sa - sb)));
      t = -a + std::atan2(cb - ca, d + sa - sb);
      q = b - std::atan2(cb - ca, d + sa - sb);
      break;
    case DubinsWord::kRSR:
      p = std::sqrt(std::max(0.0, 2 + d * d - 2 * cab + 2 * d * (sb - sa)));
      t = a - std::atan2(ca - cb, d - sa + sb);
      q = -b + std::atan2(ca - cb, d - sa + sb);
      break;
    case DubinsWord::kLSR: {
      const double square = -2 + d * d + 2 * cab + 2 * d * (sa + sb);
      if (square < 0) return std::nullopt;
      p = std::sqrt(square);
      const double angle = std::atan2(-ca - cb, d + sa + sb) - std::atan2(-2.0, p);
      t = -a + angle;
      q = -b + angle;
      break;
    }
    case DubinsWord::kRSL: {
      const double square = -2 + d * d + 2 * cab - 2 * d * (sa + sb);
      if (square < 0) return std::nullopt;
      p = std::sqrt(square);
      const double angle = std::atan2(ca + cb, d - sa - sb) - std::atan2(2.0, p);
      t = a - angle;
      q = b - angle;
      break;
    }
    case DubinsWord::kRLR: {
      const double cosine = (6 - d * d + 2 * cab + 2 * d * (sa - sb)) / 8;
      if (std::abs(cosine) > 1) return std::nullopt;
      p = kTwoPi - std::acos(cosine);
      t = a - std::atan2(ca - cb, d - sa + sb) + p / 2;
      q = a - b - t + p;
      break;
    }
    case DubinsWord::kLRL: {
      const double cosine = (6 - d * d + 2 * cab + 2 * d * (sb - sa)) / 8;
      if (std::abs(cosine) > 1) return std::nullopt;
      p = kTwoPi - std::acos(cosine);
      t = -a + std::atan2(cb - ca, d + sa - sb) + p / 2;
      q = b - a - t + p;
      break;
    }
  }
  return wrap_positive(t) + p + wrap_positive(q);
}

TEST(Dubins, RandomWordsHaveThePrintedLengthsAndEndAtTheGoal) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-6.0, 6.0), angle(-7.0, 7.0);
  std::array<int, 6> found{};
  for (int round = 0; round < 3000; ++round) {
    const Pose start{place(random), place(random), angle(random)};
    const Pose goal{place(random), place(random), angle(random)};
    const double radius = 0.3 + std::abs(place(random)) / 3.0;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto path = dubins_path(kDubinsWords[i], start, goal, radius);
      const auto length = printed_length(kDubinsWords[i], start, goal, radius);
      ASSERT_EQ(path.has_value(), length.has_value()) << "word " << i << " round " << round;
      if (!path) continue;
      ++found[i];
      EXPECT_NEAR(length_of(*path), *length * radius, 1e-7) << "word " << i << " round " << round;
      expect_reaches(*path, start, goal, 1e-12);
    }
  }
  for (const int count : found) EXPECT_GT(count, 300);
}

// The turn from a pose's heading by which a path gets to a place, found by trial: `miss(turn)` is 0 there.
template <class Miss, class Found>
void for_roots(Miss&& miss, Found&& found) {
  constexpr int kSteps = 720;
  double low = 0.0, at_low = miss(low);
  for (int i = 1; i <= kSteps; ++i) {
    double high = kTwoPi * i / kSteps;
    const double at_high = miss(high);
    if (at_low == 0.0) found(low);
    if (at_low * at_high < 0.0) {
      double a = low, b = high;
      while (b - a > 1e-14) (miss(0.5 * (a + b)) * at_low > 0.0 ? a : b) = 0.5 * (a + b);
      found(a);
    }
    low = high;
    at_low = at_high;
  }
}

Vec2 center_of(const Pose& pose, double side, double radius) {
  return pose.position() + side * radius * perpendicular(direction_of(pose.heading));
}

// The shortest path of two arcs and a line or of three arcs, by trial of the first arc. The middle arc of three may be
// as short as it likes.
double shortest_by_trial(const Pose& start, const Pose& goal, const SideRadii& radii) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const double s0 : {1.0, -1.0})
    for (const double s1 : {1.0, -1.0}) {
      const double r0 = radii.on(s0), r1 = radii.on(s1), middle = radii.on(-s0);
      const Vec2 last = center_of(goal, s1, r1);
      const auto behind_first = [&](double turn) { return PathSegment{start, turn * r0, s0 / r0}.end(); };
      for_roots(
          [&](double turn) {
            const Pose at = behind_first(turn);
            return cross(direction_of(at.heading), Vec2(last - at.position())) - s1 * r1;
          },
          [&](double turn) {
            const Pose at = behind_first(turn);
            const double line = direction_of(at.heading).dot(last - at.position());
            const double rest = wrap_positive(s1 * (goal.heading - at.heading));
            if (line >= 0.0) shortest = std::min(shortest, turn * r0 + line + rest * r1);
          });
      if (s0 != s1) continue;
      for_roots([&](double turn) { return (center_of(behind_first(turn), -s0, middle) - last).norm() - r1 - middle; },
                [&](double turn) {
                  const Pose at = behind_first(turn);
                  const Vec2 away = (last - center_of(at, -s0, middle)).normalized();
                  const double joint = std::atan2(away.y(), away.x()) - s0 * 0.5 * kPi;  // the heading there
                  const double second = wrap_positive(-s0 * (joint - at.heading));
                  const double third = wrap_positive(s1 * (goal.heading - at.heading + s0 * second));
                  const PathSegment arc{at, second * middle, -s0 / middle};
                  const Pose end = PathSegment{arc.end(), third * r1, s1 / r1}.end();
                  if ((end.position() - goal.position()).norm() < 1e-6)
                    shortest = std::min(shortest, turn * r0 + arc.length + third * r1);
                });
    }
  return shortest;
}

TEST(Dubins, WordsOfTwoRadiiHoldTheShortestPathByTrial) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(-4.0, 4.0), angle(-7.0, 7.0), radius(0.3, 3.0);
  std::array<int, 6> fastest{};
  for (int round = 0; round < 1500; ++round) {
    const Pose start{place(random), place(random), angle(random)};
    const Pose goal{place(random), place(random), angle(random)};
    const SideRadii radii(radius(random), radius(random));
    double shortest = std::numeric_limits<double>::infinity();
    std::size_t word = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto path = dubins_path(kDubinsWords[i], start, goal, radii);
      if (!path) continue;
      expect_reaches(*path, start, goal, 1e-11);
      for (const PathSegment& s : *path)
        if (!s.is_line()) {
          EXPECT_DOUBLE_EQ(std::abs(s.curvature), 1.0 / radii.on(s.curvature));
        }
      if (length_of(*path) < shortest) shortest = length_of(*path), word = i;
    }
    ++fastest[word];
    EXPECT_NEAR(shortest, shortest_by_trial(start, goal, radii), 1e-6) << "round " << round;
  }
  for (const int count : fastest) EXPECT_GT(count, 15);
}

TEST(Dubins, WordsInAMirrorHaveTheirRadiiSwapped) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> place(-4.0, 4.0), angle(-7.0, 7.0), radius(0.3, 3.0);
  constexpr std::array kMirrored{DubinsWord::kRSR, DubinsWord::kLSL, DubinsWord::kRSL,
                                 DubinsWord::kLSR, DubinsWord::kLRL, DubinsWord::kRLR};
  for (int round = 0; round < 500; ++round) {
    const Pose start{place(random), place(random), angle(random)};
    const Pose goal{place(random), place(random), angle(random)};
    const SideRadii radii(radius(random), radius(random)), swapped(radii.right, radii.left);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto path = dubins_path(kDubinsWords[i], start, goal, radii);
      const auto other =
          dubins_path(kMirrored[i], {start.x, -start.y, -start.heading}, {goal.x, -goal.y, -goal.heading}, swapped);
      ASSERT_EQ(path.has_value(), other.has_value());
      if (path) {
        EXPECT_NEAR(length_of(*path), length_of(*other), 1e-12);
      }
    }
  }
}

TEST(Dubins, FarFromTheOrigin) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(0.0, 1700.0), near(-8.0, 8.0), angle(-3.0, 3.0);
  for (int round = 0; round < 1000; ++round) {
    const Pose start{place(random), place(random), angle(random)};
    const Pose far{place(random), place(random), angle(random)};
    const Pose close{start.x + near(random), start.y + near(random), angle(random)};
    for (const DubinsWord word : kDubinsWords) {
      if (const auto path = dubins_path(word, start, far, 2.5)) expect_reaches(*path, start, far, 1e-9);
      if (const auto path = dubins_path(word, start, close, 2.5)) expect_reaches(*path, start, close, 1e-9);
    }
  }
}

TEST(Dubins, KnownWords) {
  const Path ahead = dubins_path(DubinsWord::kLSL, {0, 0, 0}, {5, 0, 0}, 1.0).value();
  ASSERT_EQ(ahead.size(), 1u);
  EXPECT_TRUE(ahead[0].is_line());
  EXPECT_EQ(ahead[0].length, 5.0);
  // A step to the left of two radii over two: a quarter turn left, a quarter turn right.
  const Path step = dubins_path(DubinsWord::kLSR, {0, 0, 0}, {2, 2, 0}, 1.0).value();
  ASSERT_EQ(step.size(), 2u);
  EXPECT_NEAR(step[0].length, kPi / 2, 1e-14);
  EXPECT_EQ(step[0].curvature, 1.0);
  EXPECT_EQ(step[1].curvature, -1.0);
  EXPECT_FALSE(dubins_path(DubinsWord::kLSR, {0, 0, 0}, {0, 1.9, 0}, 1.0));
  EXPECT_FALSE(dubins_path(DubinsWord::kLRL, {0, 0, 0}, {4.1, 0, 0}, 1.0));
}

TEST(Dubins, PureArcIsOneSegment) {
  for (const Pose& start : {Pose{0, 0, 0}, Pose{1700.1, -345.6, 2.2}, Pose{3.3, 1700.7, -1.1}}) {
    for (double turn = 0.1; turn < 6.2; turn += 0.37) {
      const PathSegment left{start, 2.5 * turn, 1.0 / 2.5};
      const Path by_left = dubins_path(DubinsWord::kLSL, start, left.end(), 2.5).value();
      ASSERT_EQ(by_left.size(), 1u);
      EXPECT_NEAR(by_left[0].length, left.length, 1e-11);
      const PathSegment right{start, 2.5 * turn, -1.0 / 2.5};
      const Path by_right = dubins_path(DubinsWord::kRSR, start, right.end(), 2.5).value();
      ASSERT_EQ(by_right.size(), 1u);
      EXPECT_NEAR(by_right[0].length, right.length, 1e-11);
    }
  }
}

TEST(Dubins, VanishingArcsMakeNoFullTurn) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(-1700.0, 1700.0), turn(0.1, 3.0);
  for (int round = 0; round < 2000; ++round) {
    const Pose start{place(random), place(random), turn(random)};
    const PathSegment line{start, 0.01 + turn(random), 0.0};
    const PathSegment arc{line.end(), turn(random), 0.5};
    EXPECT_NEAR(length_of(dubins_path(DubinsWord::kLSL, start, arc.end(), 2.0).value()), line.length + arc.length,
                1e-9);
    const PathSegment first{start, turn(random), -0.5};
    const PathSegment second{first.end(), turn(random), 0.0};
    EXPECT_NEAR(length_of(dubins_path(DubinsWord::kRSR, start, second.end(), 2.0).value()),
                first.length + second.length, 1e-9);
  }
}

// Headings as an odometer counts them: of many turns fewer digits are left.
TEST(Dubins, PureArcsAreThatWhateverTurnsHeadingsHave) {
  for (const double turns : {0.0, 5.0, 20.0, 100.0, 1e4, 1e5})
    for (int i = 1; i < 300; ++i) {
      const PathSegment arc{{0, 0, 0.01 * i + turns * kTwoPi}, 0.005 * i * 1.3, 1.0 / 1.3};
      const auto path = dubins_path(DubinsWord::kLSL, arc.start, arc.end(), 1.3);
      ASSERT_TRUE(path);
      ASSERT_NEAR(length_of(*path), arc.length, 1e-13 * (1.0 + turns)) << turns << ' ' << i;
    }
}

TEST(Dubins, StartIsGoal) {
  for (const Pose& pose : {Pose{0, 0, 0}, Pose{1699.3, -12.7, 2.9}}) {
    EXPECT_TRUE(dubins_path(DubinsWord::kLSL, pose, pose, 1.5).value().empty());
    EXPECT_TRUE(dubins_path(DubinsWord::kRSR, pose, pose, 1.5).value().empty());
    const Path circle = dubins_path(DubinsWord::kLRL, pose, pose, 1.5).value();
    EXPECT_NEAR(length_of(circle), 1.5 * kTwoPi, 1e-12);
    expect_reaches(circle, pose, pose, 1e-9);
  }
}

TEST(Dubins, RefusesRadiiThatAreNone) {
  for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)dubins_path(DubinsWord::kLSL, {}, {}, radius), std::invalid_argument);
  }
}

TEST(Dubins, LengthsAreThoseOfThePaths) {
  const SideRadii radii(1.0, 1.5);
  for (int i = 0; i < 300; ++i) {
    const Pose start{0.1 * i, 1.0, 0.05 * i}, goal{3.0 * std::sin(i), 4.0 * std::cos(2.0 * i), 1.7 * i};
    for (const DubinsWord word : kDubinsWords) {
      const auto path = dubins_word(word, start, goal, radii);
      EXPECT_EQ(dubins_length(word, start, goal, radii), path ? length_of(path->segments()) : kInfinity);
    }
  }
}

}  // namespace
}  // namespace arcway::internal
