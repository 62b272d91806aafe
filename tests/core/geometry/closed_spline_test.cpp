#include "arcway/closed_spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "arcway/angle.h"
#include "arcway/world.h"
#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

std::vector<Vec2> circle_points(const Vec2& center, double radius, std::size_t count) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(center + radius * direction_of(kTwoPi * static_cast<double>(i) / static_cast<double>(count)));
  return points;
}

ClosedSpline random_spline(test::RandomInputs& random) {
  const Vec2 center = random.point(-50.0, 50.0);
  const auto points = test::random_star(random, center, 4.0, 9.0, static_cast<std::size_t>(random.integer(4, 12)));
  return ClosedSpline(points);
}

double distance_to(const Vec2& p, const Ring& ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + t * (b - a) - p).norm());
  }
  return least;
}

TEST(ClosedSpline, GoesThroughItsPointsWithTwoContinuousDerivatives) {
  test::RandomInputs random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec2> points;
    for (std::int64_t i = random.integer(3, 9); i > 0; --i) points.push_back(random.point(-10.0, 10.0));
    const ClosedSpline spline(points);
    ASSERT_EQ(spline.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t next = (i + 1) % points.size();
      EXPECT_EQ(spline.at(static_cast<double>(i)), points[i]);
      const CubicBezier &a = spline.pieces()[i], &b = spline.pieces()[next];
      // Per unit of chord length.
      const double h = (points[next] - points[i]).norm(),
                   k = (points[(next + 1) % points.size()] - points[next]).norm();
      EXPECT_LT((a.derivative(1.0) / h - b.derivative(0.0) / k).norm(), 1e-11) << trial;
      EXPECT_LT((a.second_derivative(1.0) / (h * h) - b.second_derivative(0.0) / (k * k)).norm(), 1e-9) << trial;
    }
  }
}

TEST(ClosedSpline, ComesCloseToACircleWithTheFourthPowerOfItsSpacing) {
  double last = 0.0;
  for (const std::size_t count : {8u, 16u, 32u, 64u}) {
    const ClosedSpline spline(circle_points({3, 4}, 5.0, count));
    double error = 0.0;
    for (int i = 0; i <= 1000; ++i)
      error = std::max(error, std::abs((spline.at(i / 1000.0 * static_cast<double>(count)) - Vec2(3, 4)).norm() - 5.0));
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 16.0, 3.0);
    }
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

TEST(ClosedSpline, PartsAndHalvesLieOnTheCurve) {
  const CubicBezier curve{{Vec2(0, 0), Vec2(1, 4), Vec2(6, 5), Vec2(7, -2)}};
  const CubicBezier part = curve.part(0.3, 0.8);
  const auto halves = curve.halves();
  for (double u = 0.0; u <= 1.0; u += 0.125) {
    EXPECT_LT((part.at(u) - curve.at(0.3 + 0.5 * u)).norm(), 1e-14);
    EXPECT_LT((halves[0].at(u) - curve.at(0.5 * u)).norm(), 1e-14);
    EXPECT_LT((halves[1].at(u) - curve.at(0.5 + 0.5 * u)).norm(), 1e-14);
  }
}

TEST(ClosedSpline, RefusesWhatIsNoCurve) {
  EXPECT_THROW(ClosedSpline({{0, 0}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(ClosedSpline({{0, 0}, {1, 1}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(ClosedSpline({{0, 0}, {1, 1}, {2, 0}, {0, 0}}), std::invalid_argument);
  const ClosedSpline spline({{0, 0}, {1, 1}, {2, 0}});
  EXPECT_THROW(circumscribed_ring(spline.pieces(), 0.0), std::invalid_argument);
  try {
    (void)circumscribed_ring(spline.pieces(), 1e-300);
    ADD_FAILURE() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("tolerance is 1e-300, must be at least "), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(circumscribed_ring(spline.pieces(), std::vector<double>(2, 0.1)), std::invalid_argument);
  EXPECT_THROW(circumscribed_ring(spline.pieces().first(2), 0.1), std::invalid_argument);
  EXPECT_THROW(circumscribed_ring(spline.pieces().first(0), 0.1), std::invalid_argument);
  EXPECT_THROW(ClosedSpline({{0, 0}, {1e200, 0}, {0, 1e200}}), std::invalid_argument);
}

// Points of the curve at a dense spacing h lie inside the ring, exactly. No point between two samples is farther from
// them than h times the largest derivative. A ring that leaves one out would have to come that near.
TEST(CircumscribedRing, ContainsTheCurveWithinItsTolerance) {
  test::RandomInputs random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const ClosedSpline spline = random_spline(random);
    for (const double tolerance : {1.0, 0.1, 0.01, 1e-4}) {
      const Ring ring = circumscribed_ring(spline.pieces(), tolerance);
      ASSERT_FALSE(find_conflict({ring, {}})) << trial << ' ' << tolerance;
      ASSERT_EQ(winding(ring), 1);
      std::vector<Vec2> samples;
      for (int i = 0; i < 600; ++i) {
        samples.push_back(spline.at(static_cast<double>(spline.size()) * i / 600.0));
        ASSERT_EQ(locate(samples.back(), ring), PointLocation::kInside) << trial << ' ' << tolerance << ' ' << i;
        ASSERT_LE(distance_to(samples.back(), ring), tolerance);
      }
      double spacing = 0.0;
      for (std::size_t i = 0; i < samples.size(); ++i)
        spacing = std::max(spacing, (samples[(i + 1) % samples.size()] - samples[i]).norm());
      for (const Vec2& p : ring) {  // and the ring stays near the curve
        double least = std::numeric_limits<double>::infinity();
        for (const Vec2& q : samples) least = std::min(least, (p - q).norm());
        ASSERT_LE(least, tolerance + spacing) << trial << ' ' << tolerance;
      }
    }
  }
}

TEST(CircumscribedRing, OfOneCubicThatComesBack) {
  const CubicBezier loop{{Vec2(0, 0), Vec2(3, 0), Vec2(0, 3), Vec2(0, 0)}};
  const CubicBezier back{{loop.p[3], loop.p[2], loop.p[1], loop.p[0]}};
  for (const bool backwards : {false, true}) {
    const CubicBezier& piece = backwards ? back : loop;
    const Ring ring = circumscribed_ring(std::span(&piece, 1), 0.01);
    ASSERT_GE(ring.size(), 8u);
    EXPECT_EQ(winding(ring), backwards ? -1 : 1);
    for (const Vec2& p : ring) {
      double least = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= 4000; ++i) least = std::min(least, (p - piece.at(i / 4000.0)).norm());
      EXPECT_LE(least, 0.011);
    }
  }
}

// Proves containment without samples: over a parameter interval the curve lies in the hull of its control points. The
// hulls are of pieces far smaller than the ring's edges. Each has its corners inside the ring, or within rounding of
// it.
TEST(CircumscribedRing, ContainsTheHullsOfSmallPieces) {
  test::RandomInputs random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const ClosedSpline spline = random_spline(random);
    const Ring ring = circumscribed_ring(spline.pieces(), 0.05);
    for (const CubicBezier& piece : spline.pieces()) {
      for (int i = 0; i < 256; ++i) {
        const CubicBezier part = piece.part(i / 256.0, (i + 1) / 256.0);
        for (const Vec2& p : part.p) {
          if (locate(p, ring) == PointLocation::kInside) continue;
          // A hull may stick out where the ring touches the curve, by no more than the hull is high.
          const double height = std::max(std::abs(cross(part.p[3] - part.p[0], part.p[1] - part.p[0])),
                                         std::abs(cross(part.p[3] - part.p[0], part.p[2] - part.p[0]))) /
                                (part.p[3] - part.p[0]).norm();
          ASSERT_LE(distance_to(p, ring), height) << trial;
        }
      }
    }
  }
}

CubicBezier line(const Vec2& a, const Vec2& b) { return {{a, a, b, b}}; }

TEST(CircumscribedRing, KeepsLinesAndCorners) {
  const Vec2 a(0, 0), b(8, 1), c(9, 7), d(4, 3), e(-1, 6);  // d is a reflex corner
  const Ring corners{a, b, c, d, e};
  EXPECT_EQ(circumscribed_ring(std::vector{line(a, b), line(b, c), line(c, d), line(d, e), line(e, a)}, 0.1), corners);
  test::RandomInputs random(11);
  int rings = 0;
  for (int trial = 0; trial < 200; ++trial) {
    // Sides that bend to either side, of a star with corners of both kinds.
    const auto points = test::random_star(random, random.point(-40.0, 40.0), 5.0, 9.0, 7);
    std::vector<CubicBezier> pieces;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 &p = points[i], &q = points[(i + 1) % points.size()];
      const Vec2 across = 0.15 * perpendicular(q - p);
      pieces.push_back({{p, p + 0.3 * (q - p) + random.uniform(-1.0, 1.0) * across,
                         p + 0.7 * (q - p) + random.uniform(-1.0, 1.0) * across, q}});
      if (random.integer(0, 2) == 0) pieces.back() = line(p, q);
    }
    for (const double tolerance : {0.1, 0.001}) {
      const Ring ring = circumscribed_ring(pieces, tolerance);
      if (find_conflict({ring, {}})) continue;  // sides may cross
      ++rings;
      for (const Vec2& p : points) EXPECT_NE(std::find(ring.begin(), ring.end(), p), ring.end());
      for (const CubicBezier& piece : pieces) {
        for (double u = 1.0 / 64.0; u < 1.0; u += 1.0 / 64.0) {
          const Vec2 p = piece.at(u);
          ASSERT_LE(distance_to(p, ring), tolerance);
          // Lines are the ring's own edges; a sample of one is off by rounding.
          if (locate(p, ring) == PointLocation::kOutside) {
            ASSERT_LE(distance_to(p, ring), 1e-13) << trial;
          }
        }
      }
    }
  }
  EXPECT_GT(rings, 300);
}

TEST(CircumscribedRing, OfALargeCurveHasALimit) {
  const std::vector<CubicBezier> large{CubicBezier{{Vec2(0, 0), Vec2(1e10, 0), Vec2(1e10, 1e10), Vec2(0, 1e10)}},
                                       line({0, 1e10}, {0, 0})};
  EXPECT_THROW(circumscribed_ring(large, 0.0101), std::invalid_argument);
  EXPECT_LT(circumscribed_ring(large, 1e4).size(), 10000u);
}

TEST(CircumscribedRing, OfAHoleLiesInsideTheHole) {
  // The obstacle lies to the left of a clockwise curve, which is outside of it.
  auto points = circle_points({0, 0}, 5.0, 12);
  std::reverse(points.begin(), points.end());
  const ClosedSpline hole(points);
  const Ring ring = circumscribed_ring(hole.pieces(), 0.02);
  EXPECT_EQ(winding(ring), -1);
  for (int i = 0; i < 500; ++i)
    EXPECT_NE(locate(hole.at(static_cast<double>(hole.size()) * i / 500.0), ring), PointLocation::kInside);
}

TEST(CircumscribedRing, NeedsFourTimesTheVerticesForASixteenthOfTheTolerance) {
  const ClosedSpline spline(circle_points({0, 0}, 20.0, 8));
  const auto vertices = [&](double tolerance) {
    return static_cast<double>(circumscribed_ring(spline.pieces(), tolerance).size());
  };
  EXPECT_NEAR(vertices(1e-5) / vertices(16e-5), 4.0, 1.0);
  EXPECT_LE(vertices(0.01), 400.0);
}

TEST(CircumscribedRing, IsFineWhereItIsAskedToBe) {
  const ClosedSpline spline(circle_points({0, 0}, 20.0, 8));
  std::vector<double> tolerances(8, 1.0);
  tolerances[2] = 1e-4;
  const Ring ring = circumscribed_ring(spline.pieces(), tolerances);
  EXPECT_LT(ring.size(), circumscribed_ring(spline.pieces(), 1e-4).size() / 4);
  for (int i = 0; i <= 100; ++i) EXPECT_LT(distance_to(spline.at(2.0 + i / 100.0), ring), 1e-4);
}

}  // namespace
}  // namespace arcway::internal
