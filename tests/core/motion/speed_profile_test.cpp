#include "core/motion/speed_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>

namespace arcway::internal {
namespace {

Vehicle slow_vehicle() {
  VehicleParameters p;
  p.max_acceleration = 2.0;
  p.turn_speed = LateralAccelerationLimit{2.0};
  return Vehicle(p);
}

double limit_of(const PathSegment& s, const Vehicle& v) {
  return s.is_line() ? v.max_speed() : v.turn_speed(1.0 / std::abs(s.curvature));
}

/// Time of the fastest profile on a fine grid: a backward and a forward pass, constant acceleration within a cell.
double grid_time(const Path& path, const Vehicle& vehicle, double v0, double v1) {
  constexpr int kCells = 20000;
  std::vector<double> limits, lengths;
  for (const PathSegment& s : path) {
    for (int i = 0; i < kCells; ++i) {
      limits.push_back(limit_of(s, vehicle));
      lengths.push_back(s.length / kCells);
    }
  }
  const std::size_t n = limits.size();
  std::vector<double> v(n + 1);
  for (std::size_t i = 1; i < n; ++i) v[i] = std::min(limits[i - 1], limits[i]);
  v[0] = v0;
  v[n] = v1;
  const double a = vehicle.max_acceleration();
  for (std::size_t i = n; i-- > 0;) v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2.0 * a * lengths[i]));
  for (std::size_t i = 0; i < n; ++i) v[i + 1] = std::min(v[i + 1], std::sqrt(v[i] * v[i] + 2.0 * a * lengths[i]));
  double time = 0.0;
  for (std::size_t i = 0; i < n; ++i) time += 2.0 * lengths[i] / (v[i] + v[i + 1]);
  return time;
}

TEST(SegmentTime, TopSpeedReached) {
  // From rest to 4 m/s and back at 2 m/s^2: 2 s over 4 m each; the other 12 m at 4 m/s.
  EXPECT_DOUBLE_EQ(segment_time(20.0, 0.0, 4.0, 0.0, 2.0), 7.0);
  EXPECT_DOUBLE_EQ(segment_time(12.0, 3.0, 3.0, 3.0, 2.0), 4.0);
}

TEST(SegmentTime, TopSpeedNotReached) {
  EXPECT_DOUBLE_EQ(segment_time(4.0, 0.0, 100.0, 0.0, 1.0), 4.0);
  // 1 -> 3 -> 2 m/s at 1 m/s^2: 4 m and 2.5 m.
  EXPECT_DOUBLE_EQ(segment_time(6.5, 1.0, 12.0, 2.0, 1.0), 3.0);
}

TEST(SegmentTime, BothFormsMeetWhereTheTopSpeedIsJustReached) {
  EXPECT_NEAR(segment_time(8.0, 0.0, 4.0, 0.0, 2.0), 4.0, 1e-15);
  EXPECT_NEAR(segment_time(std::nextafter(8.0, 0.0), 0.0, 4.0, 0.0, 2.0), 4.0, 1e-14);
}

TEST(SegmentTime, TinySegmentTakesItsLengthOverItsSpeed) {
  EXPECT_NEAR(segment_time(1e-12, 5.0, 12.0, 5.0, 2.0) / (1e-12 / 5.0), 1.0, 1e-12);
}

TEST(SegmentPhases, TopSpeedReached) {
  const SegmentPhases phases = segment_phases(20.0, 2.0, 4.0, 0.0, 2.0);
  EXPECT_EQ(phases.peak, 4.0);
  EXPECT_DOUBLE_EQ(phases.accelerating, 3.0);
  EXPECT_DOUBLE_EQ(phases.holding, 13.0);
  EXPECT_DOUBLE_EQ(phases.braking, 4.0);
}

TEST(SegmentPhases, TopSpeedNotReached) {
  const SegmentPhases phases = segment_phases(6.5, 1.0, 12.0, 2.0, 1.0);
  EXPECT_DOUBLE_EQ(phases.peak, 3.0);
  EXPECT_DOUBLE_EQ(phases.accelerating, 4.0);
  EXPECT_EQ(phases.holding, 0.0);
  EXPECT_DOUBLE_EQ(phases.braking, 2.5);
}

// Speeds of a motion that reaches them [m/s], and its acceleration [m/s^2].
struct RandomMotion {
  explicit RandomMotion(std::mt19937& random)
      : top(0.1 + 10.0 * any(random)), a(0.5 + 5.0 * any(random)), v1(top * any(random)), v3(top * any(random)) {}
  [[nodiscard]] double least_length() const { return std::abs(v1 * v1 - v3 * v3) / (2.0 * a); }

  std::uniform_real_distribution<double> any{0.0, 1.0};
  double top, a, v1, v3;
};

TEST(SegmentPhases, AddUpToLengthAndTime) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    RandomMotion motion(random);
    auto& [any, top, a, v1, v3] = motion;
    const double length = motion.least_length() * (1.0 + 1e-12) + 10.0 * std::pow(any(random), 8.0);
    const auto [peak, accelerating, holding, braking] = segment_phases(length, v1, top, v3, a);
    EXPECT_LE(peak, top);
    EXPECT_NEAR(accelerating + holding + braking, length, 1e-14 * (length + top * top / a));
    const double time = 2.0 * accelerating / (v1 + peak) + holding / peak + 2.0 * braking / (peak + v3);
    EXPECT_NEAR(segment_time(length, v1, top, v3, a), time, 1e-14 * (time + top / a));
  }
}

TEST(LongestMotion, TakesTheTime) {
  std::mt19937 random(7);
  for (int i = 0; i < 1000; ++i) {
    RandomMotion motion(random);
    auto& [any, top, a, v1, v3] = motion;
    const double length = motion.least_length() + 50.0 * any(random);
    const double time = relaxed_segment_time(length, v1, top, v3, a);
    EXPECT_NEAR(longest_motion(time, v1, top, v3, a), length, 1e-9 * (1.0 + length)) << top << ' ' << v1 << ' ' << v3;
  }
}

TEST(LongestMotion, IsBoundedByTheTopSpeedWhereTheSpeedsAreOutOfReach) {
  EXPECT_EQ(longest_motion(0.5, 4.0, 5.0, 0.0, 1.0), 2.5);
  EXPECT_EQ(longest_motion(std::numeric_limits<double>::infinity(), 0.0, 5.0, 0.0, 1.0),
            std::numeric_limits<double>::infinity());
}

TEST(SpeedProfile, OneLineFromRestToRest) {
  const SpeedProfile profile = speed_profile(Path{{{}, 144.0, 0.0}}, Vehicle());
  EXPECT_EQ(profile.speeds, (std::vector<double>{0.0, 0.0}));
  EXPECT_NEAR(profile.total_time, 144.0 / 12.0 + 12.0 / 50.0, 1e-14);
}

TEST(SpeedProfile, EmptyPath) {
  const SpeedProfile profile = speed_profile({}, Vehicle());
  EXPECT_TRUE(profile.durations.empty());
  EXPECT_EQ(profile.speeds.size(), 1u);
  EXPECT_EQ(profile.total_time, 0.0);
  EXPECT_THROW(speed_profile({}, Vehicle(), {1.0, 0.0}), std::invalid_argument);
}

TEST(SpeedProfile, BrakesOverSeveralShortSegments) {
  const Vehicle vehicle = slow_vehicle();
  const Path path(10, PathSegment{{}, 0.25, 0.0});
  const SpeedProfile profile = speed_profile(path, vehicle);
  for (std::size_t i = 0; i <= 10; ++i) {
    EXPECT_NEAR(profile.speeds[i], std::sqrt(2.0 * 2.0 * 0.25 * static_cast<double>(std::min(i, 10 - i))), 1e-12);
  }
  EXPECT_NEAR(profile.total_time, 2.0 * std::sqrt(1.25), 1e-12);
}

TEST(SpeedProfile, ZeroLengthTakesNoTime) {
  const SpeedProfile profile = speed_profile(Path{{{}, 0.0, 0.0}, {{}, 1.0, 0.0}, {{}, 0.0, 0.5}}, slow_vehicle());
  EXPECT_EQ(profile.durations[0], 0.0);
  EXPECT_EQ(profile.durations[2], 0.0);
  EXPECT_NEAR(profile.total_time, std::sqrt(2.0), 1e-14);
}

TEST(SpeedProfile, EqualsFineGridOnRandomPaths) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vehicle vehicle = slow_vehicle();
  for (int round = 0; round < 20; ++round) {
    Path path;
    for (int i = 0; i < 6; ++i) {
      const double length = std::pow(10.0, -2.0 + 3.5 * uniform(random));
      path.push_back({{}, length, uniform(random) < 0.4 ? 0.0 : 2.0 * uniform(random) - 1.0});
    }
    const SpeedProfile profile = speed_profile(path, vehicle);
    EXPECT_NEAR(profile.total_time / grid_time(path, vehicle, 0.0, 0.0), 1.0, 1e-4) << "round " << round;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double v1 = profile.speeds[i];
      const double v3 = profile.speeds[i + 1];
      EXPECT_LE(std::max(v1, v3), limit_of(path[i], vehicle));
      EXPECT_LE(std::abs(v1 * v1 - v3 * v3), 4.0 * path[i].length * (1.0 + 1e-12));
    }
  }
}

TEST(SpeedProfile, StopsWhereTheGearChanges) {
  const Vehicle vehicle;
  Path path{{{0, 0, 0}, 5.0, 0.0}};
  path.push_back({path.back().end(), 4.0, 0.2});
  const double ahead = speed_profile(path, vehicle).total_time;
  Path back{path[1].reversed(), path[0].reversed()};
  EXPECT_NEAR(speed_profile(back, vehicle).total_time, ahead, 1e-12);
  path.insert(path.end(), back.begin(), back.end());
  const SpeedProfile both = speed_profile(path, vehicle);
  EXPECT_EQ(both.speeds[2], 0.0);
  EXPECT_GT(both.speeds[1], 0.0);
  EXPECT_NEAR(both.total_time, 2.0 * ahead, 1e-12);
}

TEST(SpeedProfile, BackwardsWithItsOwnLimit) {
  const Vehicle vehicle({.max_speed = 6.0, .max_reverse_speed = 2.0, .max_acceleration = 4.0});
  const PathSegment line{{0, 0, 0}, 20.0, 0.0}, arc{{0, 0, 0}, 5.0, 0.2};
  EXPECT_EQ(speed_limit(line, vehicle), 6.0);
  EXPECT_EQ(speed_limit(line.reversed(), vehicle), 2.0);
  EXPECT_EQ(speed_limit(arc, vehicle), 6.0);
  EXPECT_EQ(speed_limit(arc.reversed(), vehicle), 2.0);
  const Path back{line.reversed()};
  EXPECT_DOUBLE_EQ(speed_profile(back, vehicle).total_time, 0.5 + 19.0 / 2.0 + 0.5);
}

TEST(SpeedProfile, EndSpeeds) {
  const Vehicle vehicle = slow_vehicle();
  const Path path{{{}, 4.0, 0.0}, {{}, 5.0, 0.0}};
  EXPECT_NEAR(speed_profile(path, vehicle, {0.0, 6.0}).total_time, 3.0, 1e-14);
  EXPECT_NEAR(speed_profile(path, vehicle, {6.0, 0.0}).total_time, 3.0, 1e-14);
  EXPECT_NEAR(speed_profile(path, vehicle, {2.0, 3.0}).total_time, grid_time(path, vehicle, 2.0, 3.0), 1e-4);
}

TEST(SpeedProfile, RefusesEndSpeedsOutOfReach) {
  const Vehicle vehicle = slow_vehicle();
  const Path path{{{}, 9.0, 0.0}};
  EXPECT_THROW(speed_profile(path, vehicle, {-1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(speed_profile(path, vehicle, {0.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(speed_profile(path, vehicle, {12.5, 0.0}), std::invalid_argument);
  EXPECT_THROW(speed_profile(path, vehicle, {6.001, 0.0}), std::invalid_argument);
  EXPECT_THROW(speed_profile(path, vehicle, {0.0, 6.001}), std::invalid_argument);
}

TEST(SpeedProfile, EqualsFineGridBetweenMovingEnds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vehicle vehicle = slow_vehicle();
  SpeedProfile profile;
  int possible = 0;
  for (int round = 0; round < 100; ++round) {
    Path path;
    for (int i = 0; i < 4; ++i)
      path.push_back(
          {{}, std::pow(10.0, -1.0 + 2.0 * uniform(random)), uniform(random) < 0.4 ? 0.0 : uniform(random) - 0.5});
    const EndSpeeds ends{uniform(random) * limit_of(path.front(), vehicle),
                         uniform(random) * limit_of(path.back(), vehicle)};
    const double time = travel_time(path, vehicle, ends, profile);
    if (std::isinf(time)) {
      EXPECT_THROW(speed_profile(path, vehicle, ends), std::invalid_argument);
      continue;
    }
    ++possible;
    EXPECT_EQ(profile.speeds.front(), ends.start);
    EXPECT_EQ(profile.speeds.back(), ends.goal);
    EXPECT_NEAR(time / grid_time(path, vehicle, ends.start, ends.goal), 1.0, 1e-4) << round;
  }
  EXPECT_GT(possible, 20);
  EXPECT_LT(possible, 90);
}

// The rest of a plan that brakes as hard as it can, off by rounding. The first segment is short.
TEST(SpeedProfile, BrakesHarderByNextToNothingWhereRoundingAsksForIt) {
  const Vehicle vehicle = slow_vehicle();
  SpeedProfile profile;
  for (const double longer : {1.0 - 1e-8, 1.0 - 3e-7, 1.0 - 1e-6}) {
    const Path path{{{}, 0.05, 0.0}, {{}, 8.95 * longer, 0.0}};
    const double time = travel_time(path, vehicle, {6.0, 0.0}, profile);
    EXPECT_EQ(std::isinf(time), longer < 1.0 - 5e-7) << longer;
    if (std::isinf(time)) continue;
    EXPECT_NEAR(time, 3.0, 2e-6);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double change = profile.speeds[i] * profile.speeds[i] - profile.speeds[i + 1] * profile.speeds[i + 1];
      EXPECT_LE(change, 4.0 * path[i].length * (1.0 + 5e-7)) << i;
    }
  }
}

TEST(SpeedProfile, EndSpeedsAreNegativeBackwards) {
  const Vehicle vehicle = slow_vehicle();
  const Path ahead{{{}, 4.0, 0.0}, {{4, 0, 0}, 5.0, 0.2}}, back = reversed(ahead);
  SpeedProfile profile;
  const double time = travel_time(ahead, vehicle, {1.0, 2.0}, profile);
  EXPECT_NEAR(travel_time(back, vehicle, {-2.0, -1.0}, profile), time, 1e-12);
  EXPECT_EQ(profile.speeds.front(), 2.0);
  EXPECT_TRUE(std::isinf(travel_time(back, vehicle, {2.0, -1.0}, profile)));
  EXPECT_TRUE(std::isinf(travel_time(ahead, vehicle, {1.0, -2.0}, profile)));
  EXPECT_EQ(travel_time({}, vehicle, {-2.0, -2.0}, profile), 0.0);
  EXPECT_TRUE(std::isinf(travel_time({}, vehicle, {2.0, -2.0}, profile)));
}

TEST(SpeedProfile, FillsAProfileThatWasInUse) {
  const Vehicle vehicle = slow_vehicle();
  const Path path{{{}, 4.0, 0.0}, {{}, 5.0, 0.5}, {{}, 3.0, 0.0}};
  SpeedProfile used = speed_profile(path, vehicle);
  for (std::size_t n = 0; n <= path.size(); ++n) {
    const auto part = std::span(path).first(n);
    const SpeedProfile fresh = speed_profile(part, vehicle);
    travel_time(part, vehicle, {}, used);
    EXPECT_EQ(used.speeds, fresh.speeds);
    EXPECT_EQ(used.durations, fresh.durations);
    EXPECT_EQ(used.total_time, fresh.total_time);
  }
}

}  // namespace
}  // namespace arcway::internal
