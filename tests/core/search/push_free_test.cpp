#include "core/search/push_free.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "arcway/angle.h"
#include "arcway/query_set.h"
#include "core/collision/motion_free.h"
#include "tests/support/boxes.h"
#include "tests/support/lazy_maps.h"

namespace arcway::internal {
namespace {

Ring turned(Ring ring, double by, const Vec2& moved) {
  const Vec2 ahead = direction_of(by);
  for (Vec2& p : ring) p = moved + Vec2(p.x() * ahead + p.y() * perpendicular(ahead));
  return ring;
}

Pose turned(const Pose& pose, double by, const Vec2& moved) {
  const Vec2 ahead = direction_of(by), p = moved + Vec2(pose.x * ahead + pose.y * perpendicular(ahead));
  return {p.x(), p.y(), pose.heading + by};
}

// Two posts, a little to the left of a straight line, with 2 mm beside the body and its margin on either side.
World two_posts(double aside, double by, const Vec2& moved) {
  const Vehicle vehicle;
  const double half = vehicle.footprint(0.5 * vehicle.safety_margin()).left + 0.002;
  return World({{turned(test::box(6.0, aside + half, 6.4, aside + half + 2.0).outer, by, moved), {}},
                {turned(test::box(6.1, aside - half - 2.0, 6.5, aside - half).outer, by, moved), {}}});
}

PushSpace space_of(const Roadmap& map) { return {map.vehicle, map.body, *map.outlines, *map.queries.sweep}; }

TEST(PushFree, LeadsThroughAGapBesideThePath) {
  const Vehicle vehicle;
  for (const double aside : {0.05, -0.1})
    for (const double by : {0.0, 37.0 * std::numbers::pi / 180.0}) {
      const Vec2 moved(by == 0.0 ? 0.0 : 1000.0, -by);
      const Roadmap map = test::lazy_map(two_posts(aside, by, moved), vehicle);
      const Pose start = turned({0.0, 0.0, 0.0}, by, moved), goal = turned({12.0, 0.0, 0.0}, by, moved);
      const Path line{{start, 12.0, 0.0}};
      ASSERT_FALSE(motion_free(*map.queries.sweep, map.body, line));
      const auto path = push_free(line, goal, space_of(map), {});
      ASSERT_TRUE(path) << aside << " turned by " << by;
      EXPECT_TRUE(motion_free(*map.queries.sweep, map.body, *path));
      const Pose end = path->back().end();
      EXPECT_EQ(path->front().start.position(), start.position());
      EXPECT_LT((end.position() - goal.position()).norm(), 1e-8);
      EXPECT_LT(std::abs(wrap_signed(end.heading - goal.heading)), 1e-8);
      for (const PathSegment& s : *path) EXPECT_LE(std::abs(s.curvature), (1.0 + 1e-12) / vehicle.min_turning_radius());
    }
}

// A path that backs off in its middle ends beside the goal once that part is left out.
TEST(PushFree, MovesTheEndToTheGoalInBothGears) {
  const Vehicle vehicle;
  const double bend = 0.9 / vehicle.min_turning_radius();
  const Roadmap map = test::lazy_map(World({test::box(30.0, 30.0, 31.0, 31.0)}), vehicle);
  Path path;
  Pose end{1.0, 2.0, 0.5};
  for (const PathSegment& motion : {PathSegment{{}, 3.0, bend}, PathSegment{{}, 0.2, -bend, Gear::kReverse},
                                    PathSegment{{}, 1.0, bend}, PathSegment{{}, 2.0, 0.0, Gear::kReverse}}) {
    path.push_back({end, motion.length, motion.curvature, motion.gear});
    end = path.back().end();
  }
  path.erase(path.begin() + 1);
  const auto pushed = push_free(path, end, space_of(map), {});
  ASSERT_TRUE(pushed);
  EXPECT_EQ(cusps_of(*pushed), 1u);
  EXPECT_EQ(pushed->front().start, path.front().start);
  EXPECT_LT((pushed->back().end().position() - end.position()).norm(), 1e-8);
  EXPECT_LT(std::abs(wrap_signed(pushed->back().end().heading - end.heading)), 1e-8);
  EXPECT_TRUE(pushed->back().is_line());  // it need not bend
}

TEST(PushFree, GivesUpWhereTheBodyDoesNotFit) {
  const Vehicle vehicle;
  const double half = vehicle.footprint().left - 0.02;
  const Roadmap map =
      test::lazy_map(World({test::box(6.0, half, 6.4, 3.0), test::box(6.0, -3.0, 6.4, -half)}), vehicle);
  EXPECT_FALSE(push_free({{{0.0, 0.0, 0.0}, 12.0, 0.0}}, {12.0, 0.0, 0.0}, space_of(map), {}));
}

TEST(PushFree, LeavesAFreePathAsItIs) {
  const Vehicle vehicle;
  const Roadmap map = test::lazy_map(World({test::box(6.0, 3.0, 6.4, 4.0)}), vehicle);
  const Path line{{{0.0, 0.0, 0.0}, 12.0, 0.0}};
  const auto path = push_free(line, {12.0, 0.0, 0.0}, space_of(map), {});
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 1u);
  EXPECT_DOUBLE_EQ(path->front().length, 12.0);
}

}  // namespace
}  // namespace arcway::internal
