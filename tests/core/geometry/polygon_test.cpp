#include "arcway/polygon.h"

#include <gtest/gtest.h>

#include "arcway/angle.h"
#include "core/geometry/predicates.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using Kind = RingConflict::Kind;
using test::RandomInputs;
using test::square;

void expect_conflict(const Polygon& polygon, Kind kind, std::size_t edge_a, std::size_t edge_b, const Vec2& place) {
  const auto conflict = find_conflict(polygon);
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->kind, kind);
  EXPECT_EQ(conflict->edge_a, edge_a);
  EXPECT_EQ(conflict->edge_b, edge_b);
  EXPECT_EQ(conflict->place, place);
}

TEST(Winding, IsExactForSliversFarFromTheOrigin) {
  const Ring ring{{1e7, 1e7}, {1e7 + 1, 1e7 + 1}, {1e7 + 2, std::nextafter(1e7 + 2, 2e7)}};
  EXPECT_EQ(winding(ring), 1);
  EXPECT_EQ(winding(test::reversed(ring)), -1);
  EXPECT_EQ(winding(Ring{{0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}}), 0);
}

TEST(Winding, IsTheSignOfTheArea) {
  RandomInputs random(1);
  for (std::size_t n = 3; n < 200; n += 7) {
    const Ring ring = test::random_star(random, {50, -20}, 0.5, 4.0, n + 2);
    EXPECT_EQ(winding(ring), 1);
    EXPECT_GT(signed_area(ring), 0.0);
    EXPECT_EQ(winding(test::reversed(ring)), -1);
  }
  EXPECT_DOUBLE_EQ(signed_area(square(1e6, 1e6, 3)), 9.0);
  // Two squares that share a corner, which is the lowest vertex of the one and inside no edge.
  EXPECT_EQ(winding(Ring{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}), 1);
}

TEST(FindConflict, AcceptsSimpleRingsPinchesAndCollinearVertices) {
  EXPECT_FALSE(find_conflict({square(0, 0, 1), {}}));
  EXPECT_FALSE(find_conflict({{{0, 0}, {1, 0}, {2, 0}, {2, 2}}, {}}));
  // Two lobes that meet in (1, 1), each time without crossing.
  EXPECT_FALSE(find_conflict({{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, {}}));
  // A vertex that touches an edge from within.
  EXPECT_FALSE(find_conflict({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {}}));
  // A hole that touches its outer ring with a vertex, and one whose corners all do.
  EXPECT_FALSE(find_conflict({square(0, 0, 4), {{{2, 0}, {3, 1}, {2, 2}, {1, 1}}}}));
  EXPECT_FALSE(find_conflict({square(0, 0, 4), {{{2, 0}, {4, 2}, {2, 4}, {0, 2}}}}));
}

TEST(FindConflict, FindsTheBowTie) {
  expect_conflict({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, Kind::kCrossing, 0, 2, {1, 1});
}

TEST(FindConflict, FindsChainsThatCrossInASharedVertex) {
  expect_conflict({{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}, {}}, Kind::kCrossing, 0, 3, {1, 1});
}

TEST(FindConflict, FindsAChainThatCrossesThroughAnEdge) {
  // Vertex (2, 0) lies on edge 0, its neighbors on either side of it.
  const auto conflict = find_conflict({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {1, -2}, {0, -2}}, {}});
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->kind, Kind::kCrossing);
  EXPECT_EQ(conflict->edge_a, 0u);
  EXPECT_EQ(conflict->place, Vec2(2, 0));
}

TEST(FindConflict, FindsOverlapsSpikesAndRepeatedVertices) {
  expect_conflict({{{0, 0}, {4, 0}, {2, 0}, {2, 3}}, {}}, Kind::kOverlap, 0, 1, {4, 0});
  expect_conflict({{{0, 0}, {4, 0}, {4, 4}, {4, 2}, {6, 2}, {0, 4}}, {}}, Kind::kOverlap, 1, 2, {4, 4});
  expect_conflict({{{0, 0}, {4, 0}, {4, 0}, {2, 3}}, {}}, Kind::kRepeatedVertex, 1, 1, {4, 0});
  expect_conflict({{{0, 0}, {4, 0}, {2, 3}, {0, 0}}, {}}, Kind::kRepeatedVertex, 3, 3, {0, 0});
}

TEST(FindConflict, NamesRings) {
  const auto conflict = find_conflict({square(0, 0, 4), {square(1, 1, 1), square(3, 1, 2)}});
  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->ring_a, 0u);
  EXPECT_EQ(conflict->edge_a, 1u);
  EXPECT_EQ(conflict->ring_b, 2u);
  EXPECT_EQ(conflict->edge_b, 0u);
}

TEST(FindConflict, FindsTheFirstOfAllPairsInLargeRings) {
  RandomInputs random(2);
  for (int round = 0; round < 30; ++round) {
    const auto n = static_cast<std::size_t>(random.integer(40, 300));
    Ring ring = test::random_star(random, {0, 0}, 5, 9, n);
    EXPECT_FALSE(find_conflict({ring, {}})) << "round " << round;
    const auto i = static_cast<std::size_t>(random.integer(0, std::ssize(ring) - 1));
    std::swap(ring[i], ring[(i + n / 3) % n]);
    std::size_t first_a = n;
    std::size_t first_b = n;
    for (std::size_t a = 0; a < n && first_a == n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        if (relate({ring[a], ring[a + 1]}, {ring[b], ring[(b + 1) % n]}) == SegmentRelation::kCrossing) {
          first_a = a;
          first_b = b;
          break;
        }
      }
    }
    const auto conflict = find_conflict({ring, {}});
    ASSERT_TRUE(conflict);
    EXPECT_EQ(conflict->edge_a, first_a);
    EXPECT_EQ(conflict->edge_b, first_b);
  }
}

TEST(Polygon, IsMadeOfFewNumbers) {
  const Ring ring{{1, 2}, {4, 2}, {4, 6}, {1, 6}};
  EXPECT_EQ(Polygon::rectangle({1, 2}, {4, 6}).outer, ring);
  EXPECT_EQ(Polygon::rectangle({4, 2}, {1, 6}).outer, ring);
  EXPECT_EQ(Polygon::rectangle(1, 2, 4, 6).outer, ring);
  EXPECT_EQ(Polygon::rectangle(Box{{1, 2}, {4, 6}}).outer, ring);
  EXPECT_EQ(Polygon::rectangle({2.5, 4}, 3, 4).outer, ring);
  const Polygon turned = Polygon::rectangle({0, 0}, 4.0, 2.0, kPi / 2);
  EXPECT_NEAR((turned.outer[0] - Vec2(1, -2)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((turned.outer[2] - Vec2(-1, 2)).norm(), 0.0, 1e-15);
  EXPECT_EQ(winding(turned.outer), 1);
  const Polygon hexagon = Polygon::regular({5, 6}, 2.0, 6);
  ASSERT_EQ(hexagon.outer.size(), 6u);
  EXPECT_EQ(hexagon.outer[0], Vec2(7, 6));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR((hexagon.outer[i] - hexagon.outer[(i + 1) % 6]).norm(), 2.0, 1e-14);
  EXPECT_EQ(winding(hexagon.outer), 1);
  EXPECT_NEAR((Polygon::regular({0, 0}, 1.0, 4, kPi / 2).outer[0] - Vec2(0, 1)).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace arcway::internal
