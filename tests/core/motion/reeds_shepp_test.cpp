#include "core/motion/reeds_shepp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "core/motion/dubins.h"

namespace arcway::internal {
namespace {

constexpr double kQuarter = 0.5 * kPi;

/// "L+R-S-L-": what a path is made of.
std::string letters_of(const Path& path) {
  std::string text;
  for (const PathSegment& s : path) {
    text += s.is_line() ? 'S' : s.curvature > 0.0 ? 'L' : 'R';
    text += s.gear == Gear::kForward ? '+' : '-';
  }
  return text;
}

double miss(const Path& path, const Pose& start, const Pose& goal) {
  const Pose end = path.empty() ? start : path.back().end();
  return std::max((end.position() - goal.position()).norm(), std::abs(wrap_signed(end.heading - goal.heading)));
}

/// The words as printed, in all mirror images.
std::set<std::string> all_words() {
  std::set<std::string> words = {"L+S+L+",   "L+S+R+",   "L+R-L+",   "L+R-L-",   "L-R-L+",   "L+R+L-R-",
                                 "L+R-L-R+", "L+R-S-L-", "L-S-R-L+", "L+R-S-R-", "R-S-R-L+", "L+R-S-L-R+"};
  const auto add_images = [&words](char a, char b) {
    std::set<std::string> images;
    for (std::string word : words) {
      for (char& c : word) c = c == a ? b : c == b ? a : c;
      images.insert(word);
    }
    words.insert(images.begin(), images.end());
  };
  add_images('+', '-');
  add_images('L', 'R');
  return words;
}

/// A drive of one word: arcs of up to half a turn, those between two cusps and the middle ones as the word demands.
Path drive(const std::string& word, double radius, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.05, 0.95);
  const std::size_t n = word.size() / 2;
  const bool has_line = word.find('S') != std::string::npos;
  // The middle arcs of CC|CC turn by no more than a third of pi: beyond that another word is shorter.
  const bool one_cusp = n == 4 && word[1] == word[3];
  const double middle = share(random) * (one_cusp ? 2.0 / 3.0 : 1.0);
  Path path;
  for (std::size_t i = 0; i < n; ++i) {
    const char kind = word[2 * i];
    double length = share(random);
    if (kind == 'S') {
      length *= 4.0;
    } else {
      const bool outer = i == 0 || i + 1 == n;
      if (n == 4 && !has_line && !outer) length = middle;  // equal
      if (n >= 4 && has_line && !outer) length = 1.0;      // quarter turns
      length *= kQuarter;
    }
    path.push_back({path.empty() ? Pose{1.0, -2.0, 0.7} : path.back().end(), radius * length,
                    kind == 'S' ? 0.0 : (kind == 'L' ? 1.0 : -1.0) / radius,
                    word[2 * i + 1] == '+' ? Gear::kForward : Gear::kReverse});
  }
  return path;
}

TEST(ReedsShepp, FindsEveryDriveOfEveryWord) {
  std::mt19937 random(1);
  const auto words = all_words();
  ASSERT_EQ(words.size(), kReedsSheppWords);
  std::map<std::size_t, std::string> letters_of_index;
  for (const std::string& letters : words) {
    int found = 0;
    for (int round = 0; round < 200; ++round) {
      const Path driven = drive(letters, 1.5, random);
      const Pose start = driven.front().start, goal = driven.back().end();
      EXPECT_LE(reeds_shepp_distance(start, goal, 1.5), length_of(driven) + 1e-9) << letters;
      for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
        const auto path = reeds_shepp_path(word, start, goal, 1.5);
        if (!path || letters_of(*path) != letters) continue;
        ++found;
        const auto [known, added] = letters_of_index.insert({word, letters});
        EXPECT_EQ(known->second, letters) << "word " << word;
        EXPECT_LT(miss(*path, start, goal), 1e-9) << letters;
      }
    }
    EXPECT_GE(found, 200) << letters;
  }
  EXPECT_EQ(letters_of_index.size(), kReedsSheppWords);  // one index a word
}

// Words longer than asked for may be left out, no other ones, and lengths keep their bits.
TEST(ReedsShepp, FindsWordsUpToALength) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-8.0, 8.0), angle(-10.0, 10.0), size(0.5, 4.0);
  std::size_t longer = 0, left_out = 0;
  for (int round = 0; round < 1000; ++round) {
    const Pose start{100.0 + place(random), place(random), angle(random)};
    // Some headings differ by quarters of a turn, where arcs vanish.
    const double heading = round % 4 == 0 ? start.heading + kQuarter * std::floor(0.25 * (round % 16)) : angle(random);
    const Pose goal{100.0 + place(random), place(random), heading};
    const double radius = size(random);
    const ReedsSheppWords words(start, goal, radius);
    const double shortest = reeds_shepp_distance(start, goal, radius);
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const double length = reeds_shepp_length(word, start, goal, radius);
      EXPECT_EQ(words.length(word), length);
      EXPECT_EQ(words.length(word, length), length);
      if (!(length > shortest) || std::isinf(length)) continue;
      ++longer;
      const double found = words.length(word, shortest);
      EXPECT_TRUE(found == length || std::isinf(found));
      left_out += std::isinf(found) ? 1u : 0u;
    }
  }
  EXPECT_GT(2 * left_out, longer);
}

TEST(ReedsShepp, EveryWordEndsAtTheGoal) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-8.0, 8.0), angle(-10.0, 10.0), size(0.5, 4.0);
  for (int round = 0; round < 5000; ++round) {
    const Pose start{100.0 + place(random), place(random), angle(random)};
    const Pose goal{100.0 + place(random), place(random), angle(random)};
    const double radius = size(random);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t word = 0; word < kReedsSheppWords; ++word) {
      const auto path = reeds_shepp_path(word, start, goal, radius);
      const double length = reeds_shepp_length(word, start, goal, radius);
      EXPECT_EQ(path.has_value(), std::isfinite(length));
      if (!path) continue;
      EXPECT_LT(miss(*path, start, goal), 1e-9) << "word " << word << " " << letters_of(*path);
      EXPECT_NEAR(length_of(*path), length, 1e-9);
      for (std::size_t i = 0; i < path->size(); ++i) {
        const PathSegment& s = (*path)[i];
        EXPECT_GT(s.length, 0.0);
        EXPECT_LE(s.length * std::abs(s.curvature), kPi + 1e-9);
        if (i > 0) {
          EXPECT_EQ((*path)[i - 1].end().heading, s.start.heading);
        }
      }
      shortest = std::min(shortest, length);
    }
    EXPECT_EQ(shortest, reeds_shepp_distance(start, goal, radius));
    EXPECT_NEAR(shortest, reeds_shepp_distance(goal, start, radius), 1e-9);
    for (const DubinsWord word : kDubinsWords) {
      if (const auto path = dubins_path(word, start, goal, radius)) {
        EXPECT_LE(shortest, length_of(*path) + 1e-9);
      }
    }
  }
}

TEST(ReedsShepp, NoDriveOfArcsAndLinesIsShorter) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_int_distribution<int> kind(-1, 1), gear(0, 1), count(1, 7);
  for (int round = 0; round < 100000; ++round) {
    Path path;
    for (int i = count(random); i > 0; --i) {
      const double curvature = kind(random);
      const double most = curvature == 0.0 ? 3.0 : 2.0;
      path.push_back({path.empty() ? Pose{} : path.back().end(), most * share(random), curvature,
                      gear(random) == 1 ? Gear::kForward : Gear::kReverse});
    }
    ASSERT_LE(reeds_shepp_distance(path.front().start, path.back().end(), 1.0), length_of(path) + 1e-9)
        << letters_of(path);
  }
}

// Of a line of which little is left the direction is little known: an arc may then seem to vanish.
TEST(ReedsShepp, NoArcAndShortLineIsShorter) {
  for (const double line : {1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.1})
    for (const double angle : {1e-12, 1e-8, 1e-4, 0.5})
      for (int i = 0; i < 200; ++i)
        for (const double side : {1.0, -1.0}) {
          const PathSegment arc{{0, 0, 0.03 * i}, angle, side}, ahead{arc.end(), line, 0.0};
          const Path drive{arc, ahead};
          const Pose goal = drive.back().end();
          const double length = length_of(drive);
          ASSERT_LE(reeds_shepp_distance(arc.start, goal, 1.0), length + 1e-7 * std::sqrt(length))
              << line << ' ' << angle << ' ' << i;
          for (std::size_t word = 0; word < kReedsSheppWords; ++word)
            if (const auto path = reeds_shepp_path(word, arc.start, goal, 1.0)) {
              ASSERT_LT(miss(*path, arc.start, goal), 1e-7) << line << ' ' << angle << ' ' << letters_of(*path);
            }
        }
}

TEST(ReedsShepp, SimpleCases) {
  EXPECT_EQ(reeds_shepp_distance({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 1.0), 0.0);
  EXPECT_NEAR(reeds_shepp_distance({0, 0, 0}, {5, 0, 0}, 1.0), 5.0, 1e-12);
  EXPECT_NEAR(reeds_shepp_distance({0, 0, 0}, {-5, 0, 0}, 1.0), 5.0, 1e-12);
  EXPECT_NEAR(reeds_shepp_distance({0, 0, 0}, {0, 2, kPi}, 1.0), kPi, 1e-12);
  EXPECT_NEAR(reeds_shepp_distance({0, 0, 0}, {0, 0, kPi}, 1.0), kPi, 1e-9);  // three arcs of a third
  for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(reeds_shepp_distance({}, {}, radius), std::invalid_argument);
  }
}

}  // namespace
}  // namespace arcway::internal
