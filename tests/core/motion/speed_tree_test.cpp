#include "core/motion/speed_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/motion/speed_profile.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// A vehicle whose speed on an arc says what the radius is.
Vehicle slow_in_turns(double acceleration) {
  VehicleParameters parameters;
  parameters.max_acceleration = acceleration;
  parameters.turn_speed = LateralAccelerationLimit{2.0};
  return Vehicle(parameters);
}

Path random_path(test::RandomInputs& random, std::size_t segments) {
  Path path;
  for (std::size_t i = 0; i < segments; ++i) {
    const double length = random.integer(0, 9) == 0 ? 0.0 : random.uniform(0.1, random.integer(0, 1) == 0 ? 3.0 : 30.0);
    path.push_back({{}, length, i % 2 == 0 ? 1.0 / random.uniform(1.3, 40.0) : 0.0});
  }
  return path;
}

double limit_on(const Vehicle& vehicle, const PathSegment& s) {
  return s.is_line() ? vehicle.max_speed() : vehicle.turn_speed(1.0 / s.curvature);
}

std::uint32_t add_path(SpeedTree& tree, const Vehicle& vehicle, const Path& path, double last_limit,
                       std::uint32_t joint = 0) {
  for (std::size_t i = 0; i < path.size(); ++i)
    joint = tree.add(joint, path[i].length, limit_on(vehicle, path[i]),
                     i + 1 < path.size() ? limit_on(vehicle, path[i + 1]) : last_limit);
  return joint;
}

TEST(SpeedTree, AgreesWithTheSpeedProfileAtEveryEndSpeed) {
  test::RandomInputs random(3);
  SpeedTree tree;
  for (int i = 0; i < 2000; ++i) {
    const Vehicle vehicle = slow_in_turns(i % 2 == 0 ? 2.0 : 50.0);
    tree.reset(vehicle.max_acceleration());
    const Path path = random_path(random, static_cast<std::size_t>(random.integer(1, 12)));
    const SpeedTree::Joint& end = tree[add_path(tree, vehicle, path, vehicle.max_speed())];
    for (const double speed : {0.0, 0.3 * end.speed, random.unit() * end.speed, end.speed}) {
      const double time = speed_profile(path, vehicle, {0.0, speed}).total_time;
      EXPECT_NEAR(tree.time_at(end, speed), time, 1e-9 * (1.0 + time)) << i;
    }
    EXPECT_NEAR(tree.time_at(end, end.speed), end.time, 1e-9 * (1.0 + end.time));
  }
}

TEST(SpeedTree, WhatOnePathDominatesIsNeverFasterInTheEnd) {
  test::RandomInputs random(8);
  SpeedTree tree;
  int dominated = 0, faster = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vehicle vehicle = slow_in_turns(2.0);
    tree.reset(vehicle.max_acceleration());
    const Path first = random_path(random, 4);
    Path second = first;  // near ties are what is hard
    for (PathSegment& s : second) s.length *= random.uniform(0.8, 1.25);
    const double limit = vehicle.turn_speed(random.uniform(1.3, 40.0));
    const std::uint32_t a = add_path(tree, vehicle, first, limit);
    const std::uint32_t b = add_path(tree, vehicle, second, limit);
    if (!tree.dominates(tree[a], tree[b])) continue;
    ++dominated;
    for (int k = 0; k < 5; ++k) {
      Path rest = random_path(random, static_cast<std::size_t>(random.integer(1, 5)));
      rest.front() = {{}, rest.front().length, 2.0 / (limit * limit)};
      const double from_a = tree[add_path(tree, vehicle, rest, 0.0, a)].time;
      const double from_b = tree[add_path(tree, vehicle, rest, 0.0, b)].time;
      EXPECT_LE(from_a, from_b + 1e-9) << i;
      if (from_a < from_b) ++faster;
    }
  }
  EXPECT_GT(dominated, 5000);
  EXPECT_GT(faster, 20000);
}

TEST(SpeedTree, AgreesWithTheSpeedProfileFromAMovingStart) {
  test::RandomInputs random(6);
  SpeedTree tree;
  SpeedProfile profile;
  int possible = 0, impossible = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vehicle vehicle = slow_in_turns(2.0);
    const Path path = random_path(random, static_cast<std::size_t>(random.integer(1, 8)));
    const double start = random.uniform(0.0, vehicle.max_speed());
    tree.reset(vehicle.max_acceleration(), TimeModel::kProfile, start);
    const SpeedTree::Joint& end = tree[add_path(tree, vehicle, path, vehicle.max_speed())];
    const double most = std::isinf(end.time) ? limit_on(vehicle, path.back()) : end.speed;
    for (const double speed : {0.0, 0.3 * most, random.unit() * most, most}) {
      const double time = travel_time(path, vehicle, {start, speed}, profile);
      ++(std::isinf(time) ? impossible : possible);
      if (std::isinf(time)) {
        EXPECT_TRUE(std::isinf(tree.time_at(end, speed))) << i;
      } else {
        EXPECT_NEAR(tree.time_at(end, speed), time, 1e-9 * (1.0 + time)) << i;
      }
    }
  }
  EXPECT_GT(possible, 1000);
  EXPECT_GT(impossible, 1000);
}

TEST(SpeedTree, AStartThatIsTooFastForItsFirstSegmentLeadsNowhere) {
  SpeedTree tree;
  tree.reset(2.0, TimeModel::kProfile, 5.0);
  const std::uint32_t slow = tree.add(0, 100.0, 2.0, 12.0);
  EXPECT_TRUE(std::isinf(tree[tree.add(slow, 10.0, 12.0, 0.0)].time));
  EXPECT_TRUE(std::isinf(tree[tree.add(0, 100.0, 4.9, 12.0)].time));
  EXPECT_FALSE(std::isinf(tree[tree.add(0, 100.0, 5.0, 12.0)].time));
}

// The rests of paths are short: what matters is whether they can brake, and get as fast as the goal asks.
TEST(SpeedTree, WhatOnePathDominatesIsNeverFasterBetweenMovingEnds) {
  test::RandomInputs random(18);
  SpeedTree tree;
  SpeedProfile profile;
  int dominated = 0, possible = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vehicle vehicle = slow_in_turns(2.0);
    Path first = random_path(random, 3);
    for (PathSegment& s : first) s.length *= 0.2;
    Path second = first;
    for (PathSegment& s : second) s.length *= random.uniform(0.7, 1.4);
    const double start = random.uniform(0.0, limit_on(vehicle, first.front()));
    const double goal = i % 2 == 0 ? 0.0 : random.uniform(0.0, 8.0);
    tree.reset(vehicle.max_acceleration(), TimeModel::kProfile, start, goal);
    const double limit = vehicle.turn_speed(random.uniform(1.3, 40.0));
    const std::uint32_t a = add_path(tree, vehicle, first, limit);
    const std::uint32_t b = add_path(tree, vehicle, second, limit);
    if (std::isinf(tree[b].time) || !tree.dominates(tree[a], tree[b])) continue;
    ++dominated;
    for (int k = 0; k < 5; ++k) {
      Path rest = random_path(random, static_cast<std::size_t>(random.integer(1, 4)));
      for (PathSegment& s : rest) s.length *= 0.2;
      rest.front() = {{}, rest.front().length, 2.0 / (limit * limit)};
      const auto time_of = [&](Path path) {
        path.insert(path.end(), rest.begin(), rest.end());
        return travel_time(path, vehicle, {start, goal}, profile);
      };
      const double from_b = time_of(second);
      if (std::isinf(from_b)) continue;
      ++possible;
      EXPECT_LE(time_of(first), from_b + 1e-9) << i;
    }
  }
  EXPECT_GT(dominated, 3000);
  EXPECT_GT(possible, 3000);
}

TEST(SpeedTree, SlackMakesUpForALaterStart) {
  test::RandomInputs random(5);
  SpeedTree tree;
  const Vehicle vehicle = slow_in_turns(2.0);
  int dominated = 0;
  for (int i = 0; i < 1000; ++i) {
    tree.reset(vehicle.max_acceleration());
    const double limit = vehicle.turn_speed(random.uniform(1.3, 40.0));
    const Path path = random_path(random, 4), other = random_path(random, 4);
    const std::uint32_t later = add_path(tree, vehicle, path, limit, tree.add_stop(0, 0.5));
    const std::uint32_t now = add_path(tree, vehicle, path, limit);
    EXPECT_FALSE(tree.dominates(tree[later], tree[now], 0.4));
    EXPECT_TRUE(tree.dominates(tree[later], tree[now], 0.6));
    const std::uint32_t b = add_path(tree, vehicle, other, limit);
    if (tree.dominates(tree[now], tree[b])) {
      ++dominated;
      EXPECT_TRUE(tree.dominates(tree[now], tree[b], 0.1));
      EXPECT_TRUE(tree.dominates(tree[later], tree[b], 0.5 + 1e-9));
    }
  }
  EXPECT_GT(dominated, 200);
}

TEST(SpeedTree, OneOfTwoPathsMostlyDominates) {
  test::RandomInputs random(9);
  SpeedTree tree;
  const Vehicle vehicle = slow_in_turns(2.0);
  int undecided = 0;
  for (int i = 0; i < 1000; ++i) {
    tree.reset(vehicle.max_acceleration());
    const double limit = vehicle.turn_speed(random.uniform(1.3, 40.0));
    const std::uint32_t a = add_path(tree, vehicle, random_path(random, 6), limit);
    const std::uint32_t b = add_path(tree, vehicle, random_path(random, 6), limit);
    if (!tree.dominates(tree[a], tree[b]) && !tree.dominates(tree[b], tree[a])) ++undecided;
  }
  EXPECT_LT(undecided, 200);
}

// The paths by the many circles around a pillar, which a search has to tell from each other, are compared exactly too.
TEST(SpeedTree, ThePathThatIsShorterByAHairDominates) {
  test::RandomInputs random(4);
  SpeedTree tree;
  for (const double acceleration : {0.5, 2.0, 50.0}) {
    const Vehicle vehicle = slow_in_turns(acceleration);
    int dominated = 0;
    for (int i = 0; i < 1000; ++i) {
      tree.reset(vehicle.max_acceleration());
      const double limit = vehicle.turn_speed(random.uniform(1.3, 40.0));
      const Path path = random_path(random, 6);
      Path longer = path;
      for (PathSegment& s : longer) s.length *= 1.0 + 1e-4;
      const std::uint32_t a = add_path(tree, vehicle, path, limit);
      const std::uint32_t b = add_path(tree, vehicle, longer, limit);
      if (tree.dominates(tree[a], tree[b])) ++dominated;
    }
    EXPECT_GT(dominated, 980) << acceleration;
  }
}

TEST(SpeedTree, StopsAddUpTheTimesBetweenThem) {
  const Vehicle vehicle = slow_in_turns(2.0);
  test::RandomInputs random(8);
  for (int round = 0; round < 100; ++round) {
    const Path before = random_path(random, 4), behind = random_path(random, 4);
    SpeedTree tree;
    tree.reset(vehicle.max_acceleration());
    // As fast as may be up to the joint where it must stop after all.
    const std::uint32_t moving = add_path(tree, vehicle, before, vehicle.max_speed());
    const std::uint32_t stop = tree.add_stop(moving, 1.5);
    EXPECT_EQ(tree[stop].speed, 0.0);
    EXPECT_NEAR(tree[stop].time, speed_profile(before, vehicle).total_time + 1.5, 1e-9);
    const std::uint32_t end = tree.add_stop(add_path(tree, vehicle, behind, vehicle.max_speed(), stop), 0.0);
    EXPECT_NEAR(tree[end].time, tree[stop].time + speed_profile(behind, vehicle).total_time, 1e-9);
  }
}

TEST(SpeedTree, SegmentTimesTakeJointsAtTheirLimits) {
  const Vehicle vehicle({.max_speed = 12.0, .turn_speed = ConstantTurnSpeed{8.0}, .max_acceleration = 2.0});
  const double a = vehicle.max_acceleration();
  SpeedTree tree;
  tree.reset(a, TimeModel::kSegments);
  const std::uint32_t line = tree.add(0, 40.0, 12.0, 8.0);
  EXPECT_DOUBLE_EQ(tree[line].time, segment_time(40.0, 0.0, 12.0, 8.0, a));
  const std::uint32_t arc = tree.add(line, 5.0, 8.0, 12.0);
  EXPECT_EQ(tree[arc].speed, 8.0);
  EXPECT_DOUBLE_EQ(tree[arc].time - tree[line].time, 5.0 / 8.0);
  // Too short to stop on: the true profile brakes before.
  const std::uint32_t stop = tree.add(arc, 1.0, 12.0, 0.0);
  EXPECT_EQ(tree[stop].speed, 0.0);
  EXPECT_EQ(tree.time_at(tree[stop], 0.0), tree[stop].time);
  const Path path{{{0, 0, 0}, 40.0, 0.0}, {{40, 0, 0}, 5.0, 0.1}, {{45, 0, 0}, 1.0, 0.0}};
  EXPECT_LT(tree[stop].time, speed_profile(path, vehicle).total_time);
  EXPECT_TRUE(tree.dominates(tree[line], tree[arc]));
  EXPECT_FALSE(tree.dominates(tree[arc], tree[line]));
}

}  // namespace
}  // namespace arcway::internal
