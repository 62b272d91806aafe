#include "arcway/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace arcway::internal {
namespace {

TEST(PathSegment, Line) {
  const PathSegment line{{1.0, 2.0, std::atan2(3.0, 4.0)}, 10.0, 0.0};
  EXPECT_TRUE(line.is_line());
  EXPECT_NEAR(line.end().x, 9.0, 1e-14);
  EXPECT_NEAR(line.end().y, 8.0, 1e-14);
  EXPECT_EQ(line.end().heading, line.start.heading);
}

TEST(PathSegment, ArcsToBothSides) {
  const double quarter = std::numbers::pi / 2.0;
  const PathSegment left{{0.0, 0.0, 0.0}, 2.0 * quarter, 0.5};
  EXPECT_NEAR(left.end().x, 2.0, 1e-15);
  EXPECT_NEAR(left.end().y, 2.0, 1e-15);
  EXPECT_NEAR(left.end().heading, quarter, 1e-15);
  const PathSegment right{{0.0, 0.0, 0.0}, 2.0 * quarter, -0.5};
  EXPECT_NEAR(right.end().x, 2.0, 1e-15);
  EXPECT_NEAR(right.end().y, -2.0, 1e-15);
  EXPECT_NEAR(right.end().heading, -quarter, 1e-15);
}

TEST(PathSegment, AccurateAtTinyCurvature) {
  for (const double curvature : {1e-9, 1e-14, 1e-300}) {
    const PathSegment arc{{0.0, 0.0, 0.0}, 3.0, curvature};
    EXPECT_DOUBLE_EQ(arc.end().x, 3.0);
    EXPECT_DOUBLE_EQ(arc.end().y, 4.5 * curvature);
  }
}

TEST(PathSegment, HeadingIsNotWrapped) {
  const PathSegment circle{{5.0, 6.0, 3.0}, 2.0 * std::numbers::pi, 1.0};
  EXPECT_NEAR(circle.end().x, 5.0, 1e-14);
  EXPECT_NEAR(circle.end().y, 6.0, 1e-14);
  EXPECT_DOUBLE_EQ(circle.end().heading, 3.0 + 2.0 * std::numbers::pi);
}

TEST(PathSegment, BackwardsTheOtherWay) {
  const double quarter = std::numbers::pi / 2.0;
  const PathSegment back{{0.0, 0.0, 0.0}, 2.0 * quarter, 0.5, Gear::kReverse};  // center to the left
  EXPECT_NEAR(back.end().x, -2.0, 1e-15);
  EXPECT_NEAR(back.end().y, 2.0, 1e-15);
  EXPECT_NEAR(back.end().heading, -quarter, 1e-15);
  const PathSegment forwards = back.reversed();
  EXPECT_EQ(forwards.gear, Gear::kForward);
  EXPECT_EQ(forwards.curvature, back.curvature);
  EXPECT_EQ(forwards.start.heading, back.end().heading);
  for (const double s : {0.0, 1.0, back.length}) {
    EXPECT_NEAR((forwards.at(back.length - s).position() - back.at(s).position()).norm(), 0.0, 1e-15);
    EXPECT_NEAR(forwards.at(back.length - s).heading, back.at(s).heading, 1e-15);
  }
  EXPECT_EQ(back.forwards().start.x, forwards.start.x);
  EXPECT_EQ(forwards.forwards().start.x, forwards.start.x);
}

TEST(Path, Length) {
  EXPECT_EQ(length_of({}), 0.0);
  EXPECT_EQ(length_of(Path{{{}, 1.0, 0.0}, {{}, 2.5, 1.0}}), 3.5);
}

TEST(Path, MergesWhatLiesOnOneLineOrCircle) {
  Path path{{{1, 2, 0.3}, 2.0, 0.0}};
  const auto add = [&](double length, double curvature, Gear gear) {
    path.push_back({path.back().end(), length, curvature, gear});
  };
  add(1.0, 0.0, Gear::kForward);   // the same line
  add(1.0, 0.5, Gear::kForward);   // an arc
  add(2.0, 0.5, Gear::kForward);   // of the same circle
  add(10.0, 0.5, Gear::kForward);  // more than a full turn in all
  add(1.0, -0.5, Gear::kForward);  // to the other side
  add(1.0, -0.5, Gear::kReverse);  // and back
  add(0.5, 0.0, Gear::kReverse);
  path.push_back({{5, 5, 1.0}, 1.0, 0.0, Gear::kReverse});  // of another heading
  const Path whole = merged(path);
  ASSERT_EQ(whole.size(), 7u);
  EXPECT_EQ(whole[0].length, 3.0);
  EXPECT_EQ(whole[1].length, 3.0);
  EXPECT_EQ(whole[2].length, 10.0);
  EXPECT_EQ(whole.back().start.heading, 1.0);
  EXPECT_NEAR(length_of(whole), length_of(path), 1e-12);
  EXPECT_EQ(cusps_of(whole), cusps_of(path));
  for (std::size_t i = 0; i + 2 < whole.size(); ++i)
    EXPECT_NEAR((whole[i].end().position() - whole[i + 1].start.position()).norm(), 0.0, 1e-12) << i;
  EXPECT_TRUE(merged({}).empty());
}

TEST(Path, Cusps) {
  const PathSegment ahead{{}, 1.0, 0.0};
  const PathSegment back{{}, 1.0, 0.0, Gear::kReverse};
  EXPECT_EQ(cusps_of({}), 0u);
  EXPECT_EQ(cusps_of(Path{back, back}), 0u);
  EXPECT_EQ(cusps_of(Path{ahead, back, back, ahead}), 2u);
}

TEST(Path, HasThePoseAtAnArcLength) {
  const PathSegment line{{1.0, 2.0, 0.0}, 3.0, 0.0};
  const Path path{line, {line.end(), 2.0, 0.5}, {{}, 0.0, 0.0}};
  EXPECT_EQ(path.length(), 5.0);
  EXPECT_EQ(path.at(0).x, 1.0);  // in meters, no index
  EXPECT_EQ(path.at(2).x, 3.0);
  EXPECT_EQ(path.at(2.5).x, 3.5);
  EXPECT_EQ(path.at(4.0).heading, 0.5);
  EXPECT_EQ(path.at(3.0).x, 4.0);
  EXPECT_THROW(static_cast<void>(path.at(5.01)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(path.at(-1e-9)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(path.at(std::nan(""))), std::out_of_range);
  EXPECT_THROW(static_cast<void>(Path{}.at(0.0)), std::out_of_range);
}

// Whether path[index] compiles.
template <class Index>
concept IndexesPaths = requires(const Path& path, Index index) {
  path[index];
};

TEST(Path, IsNotIndexedByArcLengths) {
  static_assert(IndexesPaths<std::size_t> && IndexesPaths<int>);
  static_assert(!IndexesPaths<double> && !IndexesPaths<float>);
}

TEST(Polyline, HasAllJointsAndNoLongSteps) {
  const PathSegment line{{1.0, 2.0, 0.0}, 3.0, 0.0};
  const Path path{line, {line.end(), 2.0, 0.5}};
  const std::vector<Vec2> joints = polyline(path, std::numeric_limits<double>::infinity());
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[1], line.end().position());
  EXPECT_EQ(joints[2], path.back().end().position());
  const std::vector<Vec2> points = polyline(path, 0.8);
  ASSERT_EQ(points.size(), 4u + 3u + 1u);
  EXPECT_EQ(points[1].x(), 1.75);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LE((points[i] - points[i - 1]).norm(), 0.8);
  EXPECT_TRUE(polyline({}, 1.0).empty());
  EXPECT_THROW(polyline(path, 0.0), std::invalid_argument);
  EXPECT_THROW(polyline(path, std::nan("")), std::invalid_argument);
  EXPECT_THROW(polyline(path, 1e-9), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal
