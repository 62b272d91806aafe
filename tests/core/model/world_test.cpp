#include "arcway/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "tests/support/known_obstacles.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/random_inputs.h"
#include "tests/support/same_worlds.h"

namespace arcway::internal {
namespace {

using test::RandomInputs;
using test::square;

struct Refusal {
  std::string message;
  ObstacleId obstacle = kNone;
};
Refusal world_refusal(std::vector<Polygon> obstacles, std::optional<Ring> bounds = std::nullopt) {
  try {
    World(std::move(obstacles), std::move(bounds));
  } catch (const WorldError& error) {
    return {error.what(), error.obstacle()};
  }
  return {"accepted"};
}
std::string message_for(Ring ring) { return world_refusal({{std::move(ring), {}}}).message; }

TEST(WorldErrors, NameObstacleRingVertexAndValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message_for({{0, 0}, {1, nan}, {1, 1}}), "obstacle 0, ring 0, vertex 1: y is nan");
  EXPECT_EQ(message_for({{0, 0}, {1, 0}, {-infinity, 1}}), "obstacle 0, ring 0, vertex 2: x is -inf");
  EXPECT_EQ(message_for({{0, 0}, {1e200, 0}, {1, 1}}),
            "obstacle 0, ring 0, vertex 1: x is 1e+200, its magnitude must be 0 or from 1e-100 to 1e+100");
  EXPECT_EQ(message_for({{0, 0}, {1, -1e-200}, {1, 1}}),
            "obstacle 0, ring 0, vertex 1: y is -1e-200, its magnitude must be 0 or from 1e-100 to 1e+100");
  EXPECT_EQ(message_for({{0, 0}, {1, 1}}), "obstacle 0, ring 0: a ring needs at least 3 vertices, this one has 2");
  EXPECT_EQ(message_for({}), "obstacle 0, ring 0: a ring needs at least 3 vertices, this one has 0");
  EXPECT_EQ(message_for({{0, 0}, {1.5, 0}, {1.5, 0}, {1, 1}}),
            "obstacle 0, ring 0, vertex 2: repeats vertex 1 at (1.5, 0)");
  EXPECT_EQ(message_for({{0, 0}, {1, 0}, {1, 1}, {0, 0}}), "obstacle 0, ring 0, vertex 0: repeats vertex 3 at (0, 0)");
  EXPECT_EQ(message_for({{0, 0}, {1, 1}, {2, 2}}), "obstacle 0, ring 0: the ring has zero area");
  EXPECT_EQ(message_for({{0, 0}, {3, 3}, {3, 0}, {0, 3}}), "obstacle 0, ring 0: edges 0 and 2 cross at (1.5, 1.5)");
  EXPECT_EQ(message_for({{0, 0}, {4, 0}, {2, 0}, {2, 3}}), "obstacle 0, ring 0: edges 0 and 1 overlap at (4, 0)");
}

TEST(WorldErrors, NameTheObstacleOrTheBounds) {
  const Polygon good{square(0, 0, 1), {}};
  const Ring bow_tie{{0, 0}, {3, 3}, {3, 0}, {0, 3}};
  const Refusal of_obstacle = world_refusal({good, good, {bow_tie, {}}});
  EXPECT_EQ(of_obstacle.message, "obstacle 2, ring 0: edges 0 and 2 cross at (1.5, 1.5)");
  EXPECT_EQ(of_obstacle.obstacle, 2u);
  const Refusal of_bounds = world_refusal({good, good}, bow_tie);
  EXPECT_EQ(of_bounds.message, "bounds, ring 0: edges 0 and 2 cross at (1.5, 1.5)");
  EXPECT_EQ(of_bounds.obstacle, 2u);
}

TEST(WorldErrors, NameHolesThatLeaveTheirRing) {
  const auto message = [](std::vector<Ring> holes) { return world_refusal({{square(0, 0, 8), holes}}).message; };
  EXPECT_EQ(message({square(1, 1, 1), square(9, 1, 1)}),
            "obstacle 0, ring 2: the hole lies outside of its outer ring, vertex 0 at (9, 1)");
  EXPECT_EQ(message({square(7, 1, 2)}), "obstacle 0: ring 0 edge 1 and ring 1 edge 0 cross at (8, 1)");
  EXPECT_EQ(message({square(8, 1, 2)}), "obstacle 0: ring 0 edge 1 and ring 1 edge 3 overlap at (8, 3)");
  EXPECT_EQ(message({square(1, 1, 5), square(2, 2, 1)}), "obstacle 0, ring 2: the hole lies inside the hole of ring 1");
  // Holes whose corners all lie on the outer ring, within and without.
  EXPECT_EQ(message({{{4, 0}, {8, 4}, {4, 8}, {0, 4}}}), "accepted");
  EXPECT_EQ(world_refusal({{{{0, 0}, {4, 1}, {8, 0}, {8, 8}, {0, 8}}, {{{2, 0.5}, {6, 0.5}, {4, 0.75}}}}}).message,
            "obstacle 0, ring 1: the hole lies outside of its outer ring, vertex 0 at (2, 0.5)");
}

TEST(World, KeepsVerticesAndTurnsTheObstacleToTheLeft) {
  for (const bool flip : {false, true}) {
    const auto ring = [flip](Ring r) { return flip ? test::reversed(std::move(r)) : r; };
    const Polygon frame{ring(square(0, 0, 9)), {ring(square(2, 2, 3))}};
    const World world({frame, {ring(square(20, 0, 1)), {}}}, ring(square(-5, -5, 50)));
    ASSERT_EQ(world.vertices().size(), 16u);
    EXPECT_EQ(world.vertex(0), frame.outer[0]);
    EXPECT_EQ(world.vertex(5), frame.holes[0][1]);
    EXPECT_EQ(world.obstacle_count(), 2u);
    EXPECT_EQ(world.region_count(), 3u);
    EXPECT_EQ(world.vertices_of(0).first, 0u);
    EXPECT_EQ(world.vertices_of(0).last, 8u);
    EXPECT_EQ(world.vertices_of(2).last, 16u);
    EXPECT_EQ(world.polygon_of(0).outer, frame.outer);
    EXPECT_EQ(world.polygon_of(0).holes, frame.holes);
    EXPECT_EQ(world.polygon_of(1).outer, ring(square(20, 0, 1)));
    EXPECT_EQ(world.polygon_of(2).outer, ring(square(-5, -5, 50)));
    EXPECT_TRUE(world.polygon_of(2).holes.empty());
    ASSERT_EQ(world.ring_starts(0).size(), 2u);
    EXPECT_EQ(world.ring_starts(0)[1], 4u);
    EXPECT_EQ(world.ring_starts(2)[0], 12u);
    EXPECT_EQ(world.obstacle_of(7), 0u);
    EXPECT_EQ(world.obstacle_of(8), 1u);
    EXPECT_EQ(world.obstacle_of(15), 2u);
    EXPECT_EQ(world.box_of(1).min, Vec2(20, 0));
    EXPECT_EQ(world.box().max, Vec2(45, 45));
    const double step = 0.25;
    for (VertexId v = 0; v < 16; ++v) {
      EXPECT_EQ(world.previous(world.next(v)), v);
      const LineSegment& edge = world.edges()[v];
      EXPECT_EQ(edge.a, world.vertex(v));
      EXPECT_EQ(edge.b, world.vertex(world.next(v)));
      const Vec2 left = 0.5 * (edge.a + edge.b) + step * perpendicular(edge.b - edge.a).normalized();
      EXPECT_EQ(world.locate(left, world.obstacle_of(v)), PointLocation::kInside) << "vertex " << v;
      EXPECT_EQ(world.is_convex(v), v < 4 || (v >= 8 && v < 12)) << "vertex " << v;
    }
  }
}

TEST(World, LocatesWithHolesAndBounds) {
  const World world({{square(0, 0, 9), {square(2, 2, 3)}}}, square(-5, -5, 50));
  using enum PointLocation;
  EXPECT_EQ(world.locate({1, 1}, 0), kInside);
  EXPECT_EQ(world.locate({3, 3}, 0), kOutside);
  EXPECT_EQ(world.locate({2, 3}, 0), kBoundary);
  EXPECT_EQ(world.locate({9, 3}, 0), kBoundary);
  EXPECT_EQ(world.locate({10, 3}, 0), kOutside);
  EXPECT_EQ(world.locate({1, 1}, 1), kOutside);
  EXPECT_EQ(world.locate({-5, 1}, 1), kBoundary);
  EXPECT_EQ(world.locate({-6, 1}, 1), kInside);
  EXPECT_EQ(world.locate({40, 46}, 1), kInside);
}

TEST(World, TouchingDoesNotCover) {
  // Equal obstacles, a shared corner, a common edge, a corner on an edge: only overlap covers.
  const World world({{square(0, 0, 2), {}}, {square(0, 0, 2), {}}, {square(2, 2, 1), {}}, {square(2, 0, 2), {}}});
  EXPECT_EQ(world.convex_vertices().size(), 16u);
  const World overlapping({{square(0, 0, 2), {}}, {square(1, 1, 2), {}}}, square(0, 0, 2));
  EXPECT_TRUE(overlapping.is_covered(2));   // of the first, in the second
  EXPECT_TRUE(overlapping.is_covered(4));   // of the second, in the first
  EXPECT_TRUE(overlapping.is_covered(5));   // beyond the bounds
  EXPECT_FALSE(overlapping.is_covered(0));  // in a corner of the bounds
  EXPECT_TRUE(overlapping.is_covered(10));  // of the bounds, in the second
  EXPECT_EQ(overlapping.convex_vertices().size(), 3u);
}

TEST(World, CoversWhatAScanCovers) {
  RandomInputs random(1);
  for (int round = 0; round < 40; ++round) {
    std::vector<Polygon> obstacles;
    for (int k = 0; k < 15; ++k) {
      const Vec2 corner = random.grid_point(0, 20);
      obstacles.push_back({square(corner.x(), corner.y(), static_cast<double>(random.integer(1, 6))), {}});
    }
    // More vertices than a scan is used for.
    obstacles.push_back(
        {test::random_star(random, {10, 10}, 4, 9, 100), {test::random_star(random, {10, 10}, 1, 3, 80)}});
    std::optional<Ring> bounds;
    if (round % 2 == 0) bounds = test::random_star(random, {10, 10}, 8, 16, round % 4 == 0 ? 10 : 90);
    const World world(obstacles, bounds);
    std::vector<VertexId> expected;
    for (VertexId v = 0; v < world.vertices().size(); ++v) {
      bool covered = false;
      for (ObstacleId o = 0; o < world.region_count(); ++o) {
        covered |= o != world.obstacle_of(v) && world.locate(world.vertex(v), o) == PointLocation::kInside;
      }
      ASSERT_EQ(world.is_covered(v), covered) << "round " << round << " vertex " << v;
      ASSERT_EQ(world.is_graph_vertex(v), world.is_convex(v) && !covered) << "round " << round << " vertex " << v;
      if (world.is_graph_vertex(v)) expected.push_back(v);
    }
    const auto convex = world.convex_vertices();
    EXPECT_EQ(std::vector<VertexId>(convex.begin(), convex.end()), expected);
  }
}

TEST(World, CollinearVerticesAreNotConvex) {
  const World world({{{{0, 0}, {1e7, 0}, {2e7, 0}, {2e7, 1}, {0, 1}}, {}}});
  EXPECT_FALSE(world.is_convex(1));
  EXPECT_EQ(world.convex_vertices().size(), 4u);
}

TEST(World, AcceptsPinchedRings) {
  // Two lobes that meet in (1, 1): each has a convex tip there.
  const World world({{{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, {}}});
  EXPECT_EQ(world.locate({1, 1}, 0), PointLocation::kBoundary);
  EXPECT_EQ(world.locate({0.5, 1}, 0), PointLocation::kInside);
  EXPECT_EQ(world.locate({1.5, 1}, 0), PointLocation::kInside);
  EXPECT_EQ(world.locate({1, 0.5}, 0), PointLocation::kOutside);
  EXPECT_TRUE(world.is_convex(1));
  EXPECT_TRUE(world.is_convex(4));
  for (const VertexId v : {1u, 4u}) {
    EXPECT_EQ(world.previous(world.next(v)), v);
    EXPECT_EQ(world.next(world.previous(v)), v);
    // Both neighbors belong to the lobe of the wedge.
    EXPECT_EQ(world.vertex(world.previous(v)).x(), world.vertex(world.next(v)).x());
  }
}

TEST(World, AHoleThatTouchesItsRingSplitsTheWedge) {
  const World world({{{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 4}}, {{{0, 4}, {3, 3}, {3, 5}}}}});
  EXPECT_TRUE(world.is_convex(4));
  EXPECT_TRUE(world.is_convex(5));
}

TEST(World, ListsVerticesInsideEdgesOfTheirRegion) {
  // Two holes touch the lower edge in one point, from inside; a spike of the outer ring touches the upper edge of a
  // notch from its free side.
  const World world({{{{0, 0}, {16, 0}, {16, 8}, {0, 8}}, {{{8, 0}, {6, 4}, {4, 4}}, {{8, 0}, {12, 4}, {10, 4}}}},
                     {{{20, 0}, {30, 0}, {30, 8}, {20, 8}, {20, 6}, {26, 6}, {26, 4}, {24, 6}, {22, 2}, {20, 2}}, {}}});
  ASSERT_EQ(world.self_contacts().size(), 2u);
  EXPECT_EQ(world.self_contacts_on(0).size(), 2u);
  EXPECT_TRUE(world.self_contacts_on(1).empty());
  EXPECT_EQ(world.edge_touched_by(4), 0u);
  EXPECT_EQ(world.edge_touched_by(7), 0u);
  EXPECT_EQ(world.edge_touched_by(17), kNone);
  EXPECT_EQ(static_cast<int>(world.is_convex(4)) + static_cast<int>(world.is_convex(7)), 1);  // between the holes
  EXPECT_TRUE(world.is_convex(17));
  for (VertexId v = 0; v < world.vertices().size(); ++v) EXPECT_EQ(world.previous(world.next(v)), v);
}

// A hole touches the lower edge of the upper arm from inside, a spike of the lower arm from outside, in one point.
TEST(World, KeepsTheSidesOfATouchedEdgeApart) {
  const World world(
      {{{{0, 0}, {14, 0}, {14, -4}, {9, -4}, {8, 0}, {7, -4}, {0, -4}, {0, -8}, {16, -8}, {16, 8}, {0, 8}},
        {{{8, 0}, {10, 4}, {6, 4}}}}});
  ASSERT_EQ(world.self_contacts().size(), 1u);
  EXPECT_EQ(world.edge_touched_by(11), 0u);
  EXPECT_TRUE(world.is_convex(4));
  EXPECT_EQ(world.next(4), 5u);
  EXPECT_EQ(world.previous(4), 3u);
  EXPECT_FALSE(world.is_convex(11));
}

TEST(World, MayBeEmpty) {
  const World world({});
  EXPECT_TRUE(world.vertices().empty());
  EXPECT_TRUE(world.box().empty());
  EXPECT_EQ(world.region_count(), 0u);
  const World bounded({}, square(0, 0, 1));
  EXPECT_EQ(bounded.region_count(), 1u);
  EXPECT_TRUE(bounded.convex_vertices().empty());
}

TEST(World, TakesManyObstacles) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) obstacles.push_back({square(i, j, i % 2 == 0 ? 0.5 : 1.0), {}});
  }
  const World world(std::move(obstacles), square(0, 0, 100));
  EXPECT_EQ(world.vertices().size(), 40004u);
  EXPECT_EQ(world.convex_vertices().size(), 40000u);
}

TEST(World, IsMadeOfPolygonsOrRings) {
  const Polygon bounds = Polygon::rectangle({0, -20}, {40, 20});
  const World world = World::from_polygons({Polygon::rectangle({8, -4}, {12, 4})}, bounds);
  EXPECT_EQ(world.obstacle_count(), 1u);
  EXPECT_TRUE(world.has_bounds());
  const World rings = World::from_polygons({{{8, -4}, {12, -4}, {12, 4}, {8, 4}}}, bounds.outer);
  EXPECT_TRUE(std::ranges::equal(world.vertices(), rings.vertices()));
  EXPECT_TRUE(std::ranges::equal(World({Polygon::rectangle({8, -4}, {12, 4})}, bounds).vertices(), world.vertices()));
  EXPECT_FALSE(World::from_polygons({Polygon::regular({0, 0}, 1.0, 8)}).has_bounds());
  try {
    World::from_polygons({bounds}, Polygon{bounds.outer, {Polygon::rectangle(1, 1, 2, 2).outer}});
    ADD_FAILURE() << "no error";
  } catch (const WorldError& error) {
    EXPECT_STREQ(error.what(), "bounds: a polygon with 1 hole, must have none; make holes obstacles");
    EXPECT_EQ(error.obstacle(), 1u);
  }
}

// A world and the obstacles that it is made of.
struct KnownWorld {
  explicit KnownWorld(const MapFile& map) : world(map.obstacles, map.bounds), obstacles(map.obstacles) {}
  [[nodiscard]] World anew(const MapFile& map) const { return World(obstacles.polygons(), map.bounds); }

  World world;
  test::KnownObstacles obstacles;
};

KnownWorld changed_at_random(const KnownWorld& from, test::RandomInputs& random) {
  const std::vector<Polygon> added = to_map_file(test::nasty_world(random.bits(), 2)).obstacles;
  const std::vector<ObstacleId> removed = test::draw_obstacles(from.world, 6, random);
  KnownWorld after = from;
  after.world = from.world.changed(removed, added);
  after.obstacles.change(removed, added);
  return after;
}

// Changes use arrays again of worlds that are gone. Some are kept meanwhile, and changed later in another way.
TEST(World, IsAfterAnyChangesTheSameAsMadeAnew) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    const MapFile map = to_map_file(test::nasty_world(seed, 14));
    std::vector<KnownWorld> kept{KnownWorld(map)};
    for (int step = 0; step < 20; ++step) {
      const auto from = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(kept.size()) - 1));
      KnownWorld next = changed_at_random(kept[from], random);
      test::expect_same_world(next.world, next.anew(map));
      if (random.integer(0, 1) == 0 && kept.size() < 5) {
        kept.push_back(std::move(next));
      } else {
        kept[from] = std::move(next);
      }
    }
    for (const KnownWorld& known : kept) test::expect_same_world(known.world, known.anew(map));
  }
}

// Before and after changes, by boxes that meet none, some, or a place of which one of two obstacles is gone.
TEST(World, FindsTheRegionsThatMeetBoxes) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    const MapFile map = to_map_file(test::nasty_world(seed, 14));
    KnownWorld known(map);
    for (int step = 0; step < 12 && !known.world.vertices().empty(); ++step) {
      std::vector<Box> boxes(static_cast<std::size_t>(random.integer(0, 3)));
      for (Box& box : boxes) {
        const Vec2& corner = known.world.vertex(
            static_cast<VertexId>(random.integer(0, static_cast<std::int64_t>(known.world.vertices().size()) - 1)));
        box.extend(corner);
        box.extend(corner + random.uniform(0.0, 3.0) * Vec2(1.0, 0.5));
      }
      std::vector<ObstacleId> expected;
      for (ObstacleId o = 0; o < known.world.region_count(); ++o)
        if (std::ranges::any_of(boxes, [&](const Box& box) { return box.overlaps(known.world.box_of(o)); }))
          expected.push_back(o);
      EXPECT_EQ(known.world.regions_meeting(boxes), expected);
      found += expected.size();
      known = changed_at_random(known, random);
    }
  }
  EXPECT_GT(found, 500u);
}

// An obstacle that moves keeps its place, and where two worlds lie between, nothing behind it is copied.
TEST(World, HasAnObstacleThatMovesInItsPlace) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 200; ++i) obstacles.push_back({square(3.0 * i, 0, 1), {}});
  const Polygon triangle{{{3, 5}, {4, 5}, {4, 6}}, {}};
  World world(obstacles), before = world;
  for (const ObstacleId o : {7u, 150u, 7u, 0u, 199u}) {
    Polygon moved = world.polygon_of(o);
    for (Vec2& p : moved.outer) p.y() += 0.25;
    const World after = world.changed(std::vector{o}, {moved});
    EXPECT_EQ(after.obstacle_count(), 200u);
    EXPECT_EQ(after.polygon_of(o).outer, moved.outer);
    EXPECT_EQ(after.key_of(o), o);
    EXPECT_EQ(after.obstacle_with(o), o);
    obstacles[o] = moved;
    test::expect_same_world(after, World(obstacles));
    before = std::exchange(world, after);
  }
  const World other = world.changed(std::vector<ObstacleId>{7}, {triangle});
  EXPECT_EQ(other.obstacle_with(7), kNone) << "another number of vertices";
  EXPECT_EQ(other.key_of(199), 200u);
  EXPECT_EQ(other.polygon_of(199).outer, triangle.outer);
}

// Coverage far from a change is copied, and near it is looked at again, also where a world that is gone differed.
TEST(World, KnowsWhatIsCoveredWhereArraysAreUsedAgain) {
  std::vector<Polygon> obstacles;
  for (int i = 0; i < 200; ++i) obstacles.push_back({square(3.0 * i, 0, 1), {}});
  const auto cover = [](int i) { return std::vector<Polygon>{{square(3.0 * i - 0.5, -0.5, 2), {}}}; };
  const World first(obstacles);
  const auto is_covered = [&](const World& world, int i) { return world.is_covered(static_cast<VertexId>(4 * i)); };
  const void* gone = nullptr;
  for (const int i : {7, 90, 90, 199, 0}) {
    const World covering = first.changed({}, cover(i));
    for (int k = 0; k < 200; ++k) ASSERT_EQ(is_covered(covering, k), k == i) << k;
    EXPECT_EQ(covering.convex_vertices().size(), first.convex_vertices().size());
    if (gone) {
      EXPECT_EQ(covering.vertices().data(), gone) << "arrays of the world before are used again";
    }
    gone = covering.vertices().data();
  }
}

}  // namespace
}  // namespace arcway::internal
