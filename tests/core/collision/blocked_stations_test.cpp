#include "core/collision/blocked_stations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "arcway/angle.h"
#include "arcway/vehicle.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_bodies.h"

namespace arcway::internal {
namespace {

// Whether a convex polygon and an edge touch, by exact predicates: they cross, or an end lies inside.
bool touch(const std::vector<Vec2>& polygon, const LineSegment& edge) {
  bool inside = true, crosses = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    inside = inside && orientation(a, b, edge.a) >= 0;
    crosses = crosses || (orientation(a, b, edge.a) != orientation(a, b, edge.b) &&
                          orientation(edge.a, edge.b, a) != orientation(edge.a, edge.b, b));
  }
  return inside || crosses;
}

// The convex pieces of a body about F.
std::vector<Ring> pieces_of(const Body& body) {
  if (body.shape != nullptr) return {body.shape->pieces.begin(), body.shape->pieces.end()};
  return {{{-body.rear, -body.right}, {body.front, -body.right}, {body.front, body.left}, {-body.rear, body.left}}};
}

bool touches_at(const StraightBody& straight, double station, const LineSegment& edge) {
  const Vec2 ahead = direction_of(straight.from.heading);
  for (Ring piece : pieces_of(straight.body)) {
    for (Vec2& p : piece) p = straight.from.position() + (station + p.x()) * ahead + p.y() * perpendicular(ahead);
    if (touch(piece, edge)) return true;
  }
  return false;
}

TEST(BlockedStations, AreThoseAtWhichTheBodyTouchesTheEdge) {
  constexpr double kNear = 1e-9;  // of an end of a range, where samples say nothing [m]
  test::RandomInputs random(4);
  int blocked_samples = 0, free_samples = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vehicle vehicle = i % 2 == 0 ? Vehicle() : test::random_body_vehicle(random);
    const Body body = vehicle.body(i % 3 == 0 ? 0.4 : 0.0);
    const bool upright = i % 5 == 0;  // coincident directions
    const double heading = upright ? 0.5 * kPi * static_cast<double>(random.integer(0, 3)) : random.uniform(-kPi, kPi);
    const StraightBody straight{{random.uniform(-3, 3), random.uniform(-3, 3), heading}, random.uniform(0, 6), body};
    const LineSegment edge = upright ? LineSegment{random.grid_point(-4, 4), random.grid_point(-4, 4)}
                                     : LineSegment{random.point(-4, 4), random.point(-4, 4)};
    if (edge.a == edge.b) continue;
    std::vector<BlockedRange> blocked;
    append_blocked_stations(straight, edge, blocked);
    for (const BlockedRange& range : blocked) {
      EXPECT_GE(range.low, 0.0);
      EXPECT_LE(range.low, range.high);
      EXPECT_LE(range.high, straight.length);
    }
    for (int k = 0; k < 30; ++k) {
      const double station = random.uniform(0.0, straight.length);
      const auto is_at_an_end = [&](const BlockedRange& r) {
        return std::abs(station - r.low) < kNear || std::abs(station - r.high) < kNear;
      };
      if (std::ranges::any_of(blocked, is_at_an_end)) continue;
      const bool expected = touches_at(straight, station, edge);
      const bool found =
          std::ranges::any_of(blocked, [&](const BlockedRange& r) { return r.low <= station && station <= r.high; });
      ASSERT_EQ(found, expected) << "body " << i << " after " << station;
      ++(expected ? blocked_samples : free_samples);
    }
  }
  EXPECT_GT(blocked_samples, 2000);
  EXPECT_GT(free_samples, 2000);
}

TEST(BlockedStations, OfOverlappingRangesCountOnce) {
  std::vector<BlockedRange> ranges{{5.0, 7.0}, {0.0, 2.0}, {1.0, 3.0}, {5.5, 6.0}, {7.0, 7.5}};
  EXPECT_EQ(length_of_union(ranges), 5.5);
  ranges.clear();
  EXPECT_EQ(length_of_union(ranges), 0.0);
}

}  // namespace
}  // namespace arcway::internal
