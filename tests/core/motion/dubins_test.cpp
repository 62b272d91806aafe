#include "core/motion/dubins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "arcway/angle.h"

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

}  // namespace
}  // namespace arcway::internal
