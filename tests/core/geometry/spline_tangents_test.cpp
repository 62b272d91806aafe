#include "core/geometry/spline_tangents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "arcway/angle.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

// Off the circle by less than 1e-9 of its radius.
ClosedSpline circle(const Vec2& center, double radius, double phase = 0.1) {
  std::vector<Vec2> points;
  for (int i = 0; i < 256; ++i) points.push_back(center + radius * direction_of(phase + kTwoPi * i / 256.0));
  return ClosedSpline(points);
}

ClosedSpline wavy(test::RandomInputs& random, const Vec2& center, double inner) {
  return ClosedSpline(test::random_star(random, center, inner, 8.0, static_cast<std::size_t>(random.integer(5, 11))));
}

// Of the line through a and b, as heading of its normal and distance from the origin; the same for both directions.
Vec2 line_of(const Vec2& a, const Vec2& b) {
  Vec2 n = perpendicular(b - a).normalized();
  if (n.x() < -1e-9 || (std::abs(n.x()) <= 1e-9 && n.y() < 0.0)) n = -n;
  return n * (1000.0 + n.dot(a));
}

TEST(SplineTangents, FromAPointToACircleAreTheClosedForm) {
  const ClosedSpline curve = circle({3, 4}, 5.0);
  for (const Vec2& p : {Vec2(20, 4), Vec2(-3, 17), Vec2(3, 9.5), Vec2(1000, -700)}) {
    const std::vector<PointTangent> found = tangents_from(p, curve);
    ASSERT_EQ(found.size(), 2u);
    const double distance = (p - Vec2(3, 4)).norm();
    const double length = std::sqrt(distance * distance - 25.0);
    for (const PointTangent& tangent : found) {
      EXPECT_NEAR((tangent.touch - p).norm(), length, 1e-6);
      EXPECT_NEAR((tangent.touch - Vec2(3, 4)).norm(), 5.0, 1e-8);
      EXPECT_LT(std::abs(cross(curve.derivative(tangent.t), tangent.touch - p)), 1e-9 * length);
    }
    EXPECT_NE(found[0].onward, found[1].onward);
  }
  EXPECT_TRUE(tangents_from({3, 4}, curve).empty());
  EXPECT_TRUE(tangents_from({4, 6}, curve).empty());
}

TEST(SplineTangents, TouchingAtAGivenPointOfTheSplineIsFoundOnce) {
  // Symmetric about the x axis, points at the extremes: tangents from far right touch at points or between them.
  const ClosedSpline square({{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
  const std::vector<PointTangent> found = tangents_from({1, 5}, square);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT((found[0].touch - Vec2(1, 0)).norm(), 1e-9);
  EXPECT_EQ(tangents_from({5, 1}, square).size(), 2u);
  EXPECT_EQ(tangents_from({-5, -1}, square).size(), 2u);
}

// Counted independently: changes of sign of cross(c - p, c') over samples far denser than its roots lie.
TEST(SplineTangents, FromAPointAreAllFoundOnWavyCurves) {
  test::RandomInputs random(21);
  std::size_t most = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ClosedSpline curve = wavy(random, random.point(-5, 5), 3.0);
    const Vec2 p = random.point(-30, 30);
    std::vector<double> values;
    const int samples = 400 * static_cast<int>(curve.size());
    for (int i = 0; i < samples; ++i) {
      const double t = (i + 0.37) / 400.0;
      values.push_back(cross(curve.at(t) - p, curve.derivative(t)));
    }
    std::size_t changes = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      changes += (values[i] > 0.0) != (values[(i + 1) % values.size()] > 0.0);
    const std::vector<PointTangent> found = tangents_from(p, curve);
    EXPECT_EQ(found.size(), changes) << trial;
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 4u);
}

TEST(SplineTangents, CommonOnesOfTwoCirclesAreTheClosedForm) {
  const Vec2 a(0, 0), b(20, 5);
  const ClosedSpline first = circle(a, 5.0), second = circle(b, 3.0, 0.25);
  const std::vector<CommonTangent> found = common_tangents(first, second);
  ASSERT_EQ(found.size(), 4u);
  const double d2 = (b - a).squaredNorm();
  std::size_t crossing = 0;
  for (const CommonTangent& tangent : found) {
    crossing += tangent.crossing ? 1 : 0;
    const double reach = tangent.crossing ? 8.0 : 2.0;
    EXPECT_NEAR((tangent.second - tangent.first).norm(), std::sqrt(d2 - reach * reach), 1e-6);
    EXPECT_NEAR((tangent.first - a).norm(), 5.0, 1e-7);
    EXPECT_NEAR((tangent.second - b).norm(), 3.0, 1e-7);
    EXPECT_NEAR((tangent.first - a).dot(tangent.second - tangent.first), 0.0, 1e-4);  // directions are off by 1e-6
  }
  EXPECT_EQ(crossing, 2u);
}

TEST(SplineTangents, CommonOnesCountFourTwoOrNone) {
  EXPECT_EQ(common_tangents(circle({0, 0}, 5.0), circle({7, 0}, 4.0)).size(), 2u);  // the circles cross
  EXPECT_EQ(common_tangents(circle({0, 0}, 5.0), circle({1, 0}, 2.0)).size(), 0u);  // one inside the other
  EXPECT_EQ(common_tangents(circle({0, 0}, 5.0), circle({300, 0}, 5.0)).size(), 4u);
  EXPECT_THROW(common_tangents(circle({0, 0}, 5.0), circle({0, 0}, 5.0)), std::invalid_argument);
}

TEST(SplineTangents, CommonOnesAreSymmetric) {
  test::RandomInputs random(31);
  for (int trial = 0; trial < 12; ++trial) {
    const ClosedSpline a = wavy(random, {0, 0}, 5.0), b = wavy(random, {20, 6}, 5.0);
    const auto forth = common_tangents(a, b), back = common_tangents(b, a);
    EXPECT_GE(forth.size(), 4u);
    EXPECT_EQ(forth.size(), back.size()) << trial;
    for (const CommonTangent& tangent : forth) {
      const Vec2 direction = (tangent.second - tangent.first).normalized();
      EXPECT_LT(std::abs(cross(direction, a.derivative(tangent.t_first).normalized())), 1e-8);
      EXPECT_LT(std::abs(cross(direction, b.derivative(tangent.t_second).normalized())), 1e-8);
      EXPECT_TRUE(std::ranges::any_of(back, [&](const CommonTangent& other) {
        return (line_of(other.first, other.second) - line_of(tangent.first, tangent.second)).norm() < 1e-5 &&
               (other.second - tangent.first).norm() < 1e-5;
      })) << trial;
    }
  }
}

// Independently, point by point: from curve a at t, the tangents to b that leave along a's own tangent. Where the
// signed angle between a's tangent and one of b's changes sign from t to t + dt, there is a common tangent in between.
TEST(SplineTangents, CommonOnesAreAllFoundOnWavyCurves) {
  test::RandomInputs random(41);
  for (int trial = 0; trial < 6; ++trial) {
    const ClosedSpline a = wavy(random, {0, 0}, 4.0), b = wavy(random, {22, -5}, 4.0);
    // The tangent line of a at t meets b in a number of points that changes by two where it touches b.
    const int steps = 4000;
    const auto crossings = [&](double t) {
      const Vec2 p = a.at(t), d = a.derivative(t);
      int count = 0;
      bool last = cross(d, b.at(0.0) - p) > 0.0;
      const bool first = last;
      for (int i = 1; i < 3000; ++i) {
        const bool now = cross(d, b.at(static_cast<double>(b.size()) * i / 3000.0) - p) > 0.0;
        count += now != last ? 1 : 0;
        last = now;
      }
      return count + (last != first ? 1 : 0);
    };
    int changes = 0;
    const int start = crossings(0.001);
    int last = start;
    for (int i = 1; i < steps; ++i) {
      const int now = crossings(0.001 + static_cast<double>(a.size()) * i / steps);
      changes += std::abs(now - last) / 2;
      last = now;
    }
    changes += std::abs(start - last) / 2;
    EXPECT_EQ(common_tangents(a, b).size(), static_cast<std::size_t>(changes)) << trial;
  }
}

}  // namespace
}  // namespace arcway::internal
