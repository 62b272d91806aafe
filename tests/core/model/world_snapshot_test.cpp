#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "arcway/datasets/map_file.h"
#include "arcway/world.h"
#include "tests/support/known_obstacles.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/same_worlds.h"
#include "tests/support/touching_worlds.h"

namespace arcway::internal {
namespace {

TEST(WorldSnapshot, GiveTheSameWorldAgain) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const World world = test::nasty_world(seed, 9);
    test::expect_same_world(World::from_snapshot(world.snapshot()), world);
    const World touching = test::touching_world(seed, 3);
    test::expect_same_world(World::from_snapshot(touching.snapshot()), touching);
  }
}

TEST(WorldSnapshot, ThoseOfNoWorldAreRefusedWithTheEntryAtFault) {
  const World world({{test::square(0, 0, 4), {test::reversed(test::square(1, 1, 1))}}, {test::square(9, 9, 2), {}}},
                    test::square(-5, -5, 30));
  struct Case {
    SnapshotArray array;
    std::size_t index;
    std::function<void(WorldSnapshot&)> spoil;
  };
  const Case cases[] = {
      {SnapshotArray::kVertices, 5,
       [](WorldSnapshot& t) { t.vertices[5].x() = std::numeric_limits<double>::quiet_NaN(); }},
      {SnapshotArray::kVertices, 0, [](WorldSnapshot& t) { t.vertices[0].y() = 1e300; }},
      {SnapshotArray::kNext, 3, [](WorldSnapshot& t) { t.next[3] = 99; }},
      {SnapshotArray::kNext, 3, [](WorldSnapshot& t) { t.next[3] = 8; }},  // of the next obstacle
      {SnapshotArray::kNext, 3, [](WorldSnapshot& t) { t.next[3] = t.next[2]; }},
      {SnapshotArray::kNext, 3, [](WorldSnapshot& t) { t.next[3] = t.next[0]; }},
      {SnapshotArray::kNext, 6, [](WorldSnapshot& t) { t.vertices[6] = t.vertices[t.next[6]]; }},
      {SnapshotArray::kNext, 2, [](WorldSnapshot& t) { t.next.resize(2); }},
      {SnapshotArray::kCovered, 7, [](WorldSnapshot& t) { t.covered[7] = 2; }},
      {SnapshotArray::kRingStarts, 0, [](WorldSnapshot& t) { t.ring_starts[0] = 1; }},
      {SnapshotArray::kRingStarts, 2, [](WorldSnapshot& t) { t.ring_starts[1] = 6; }},  // leaves two vertices
      {SnapshotArray::kRingStarts, 2, [](WorldSnapshot& t) { t.ring_starts[2] = 4000000000u; }},
      {SnapshotArray::kRegionRings, 1, [](WorldSnapshot& t) { t.region_rings[1] = 0; }},
      {SnapshotArray::kRegionRings, 3, [](WorldSnapshot& t) { t.region_rings.back() = 9; }},
      {SnapshotArray::kRegionRings, 0, [](WorldSnapshot& t) { t.region_rings.clear(); }},
      {SnapshotArray::kRegionRings, 0,
       [](WorldSnapshot& t) {
         t = {};
         t.region_rings = {0};
         t.has_bounds = true;
       }},
  };
  for (const Case& c : cases) {
    WorldSnapshot snapshot = world.snapshot();
    c.spoil(snapshot);
    try {
      static_cast<void>(World::from_snapshot(std::move(snapshot)));
      ADD_FAILURE() << "took " << name_of(c.array) << " " << c.index;
    } catch (const SnapshotError& error) {
      EXPECT_EQ(error.array(), c.array) << error.what();
      EXPECT_EQ(error.index(), c.index) << error.what();
    }
  }
}

TEST(WorldSnapshot, ContactsThatAreNoneAreRefused) {
  const World world({{test::square(0, 0, 8), {{{4, 0}, {6, 4}, {2, 4}}, {{4, 8}, {3, 6}, {5, 6}}}}});
  ASSERT_EQ(world.snapshot().self_contacts, (std::vector<SelfContact>{{0, 4}, {2, 7}}));
  const std::vector<std::vector<SelfContact>> wrong{{{0, 4}, {2, 99}}, {{0, 4}, {99, 7}}, {{0, 4}, {0, 4}},
                                                    {{2, 7}, {0, 4}},  {{0, 4}, {2, 6}},  {{0, 4}, {6, 7}}};
  for (const std::vector<SelfContact>& contacts : wrong) {
    WorldSnapshot snapshot = world.snapshot();
    snapshot.self_contacts = contacts;
    try {
      static_cast<void>(World::from_snapshot(std::move(snapshot)));
      ADD_FAILURE() << "took " << contacts[1].edge << " " << contacts[1].vertex;
    } catch (const SnapshotError& error) {
      EXPECT_EQ(error.array(), SnapshotArray::kSelfContacts) << error.what();
      EXPECT_EQ(error.index(), 1u) << error.what();
    }
  }
}

TEST(ChangedWorld, IsTheOneMadeOfItsPolygons) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed, 12);
    for (int step = 0; step < 8; ++step) {
      const MapFile map = to_map_file(world);
      test::KnownObstacles known(map.obstacles);
      const std::vector<ObstacleId> removed = test::draw_obstacles(world, 4, random);
      const std::vector<Polygon> added = to_map_file(test::nasty_world(random.bits(), 4)).obstacles;
      known.change(removed, added);
      world = world.changed(removed, added);
      test::expect_same_world(world, World(known.polygons(), map.bounds));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ChangedWorld, KeepsKeysAndGivesNoneTwice) {
  const Polygon box{test::square(0, 0, 4), {}};
  World world({box, box, box}, test::square(-1, -1, 9));
  const auto keys = [&world] {
    std::vector<ObstacleKey> all;
    for (ObstacleId o = 0; o < world.obstacle_count(); ++o) {
      all.push_back(world.key_of(o));
      EXPECT_EQ(world.obstacle_with(all.back()), o);
    }
    return all;
  };
  const auto change = [&](const std::vector<ObstacleId>& removed, std::size_t added) {
    world = world.changed(removed, std::vector<Polygon>(added, box));
    return keys();
  };
  using Keys = std::vector<ObstacleKey>;
  EXPECT_EQ(keys(), (Keys{0, 1, 2}));
  EXPECT_EQ(change({}, 1), (Keys{0, 1, 2, 3}));
  EXPECT_EQ(change({1, 3}, 0), (Keys{0, 2}));
  EXPECT_EQ(change({}, 2), (Keys{0, 2, 4, 5}));
  for (const ObstacleKey gone : {1, 3, 6, 99}) EXPECT_EQ(world.obstacle_with(gone), kNone);
  EXPECT_EQ(change({0, 1, 2, 3}, 0), Keys{});
  EXPECT_EQ(change({}, 1), Keys{6});
  EXPECT_EQ(change({}, 2), (Keys{6, 7, 8}));
  EXPECT_EQ(change({0, 1}, 1), (Keys{6, 8})) << "one is in the place of the first one removed";
  EXPECT_EQ(change({1}, 3), (Keys{6, 8, 9, 10}));
}

TEST(ChangedWorld, RefusesWhatItCannotRemoveOrAdd) {
  const World world({{test::square(0, 0, 4), {}}, {test::square(9, 9, 2), {}}});
  EXPECT_THROW(static_cast<void>(world.changed(std::vector<ObstacleId>{2}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(world.changed(std::vector<ObstacleId>{1, 0}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(world.changed(std::vector<ObstacleId>{1, 1}, {})), std::invalid_argument);
  try {
    static_cast<void>(world.changed(std::vector<ObstacleId>{0}, {{{{0, 0}, {1, 1}}, {}}}));
    ADD_FAILURE() << "took a ring of two vertices";
  } catch (const WorldError& error) {
    EXPECT_EQ(error.obstacle(), 1u);
  }
}

}  // namespace
}  // namespace arcway::internal
