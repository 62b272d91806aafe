#include "accel/graphs/changed_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "accel/graphs/lazy_rows.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/map_file.h"
#include "arcway/query_set.h"
#include "arcway/world_change.h"
#include "core/model/vertex_map.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// The rows are those of new lazy rows, and vertices that may not differ have the neighbors that they had.
void expect_right(const VisibilityRows& before, const VisibilityRows::Changed& changed, const World& after,
                  const WorldChange& change) {
  const auto anew = make_lazy_rows(after);
  for (VertexId v = 0; v < after.vertices().size(); ++v)
    ASSERT_TRUE(std::ranges::equal(changed.rows->of(v), anew->of(v))) << "vertex " << v;
  const VertexMap map(change);
  for (const VertexId v : after.convex_vertices()) {
    if (std::ranges::binary_search(changed.may_differ, v)) continue;
    ASSERT_NE(map.before(v), kNone);
    const auto row = before.of(map.before(v));
    ASSERT_TRUE(std::ranges::equal(row, anew->of(v), {}, [&](VertexId w) { return map.after(w); })) << "vertex " << v;
  }
  const auto wanted = [](VertexId u, VertexId v) { return (u + v) % 3 != 0; };
  EXPECT_EQ(changed.rows->pairs_within(2.5, wanted, SerialExecutor()),
            anew->pairs_within(2.5, wanted, SerialExecutor()));
}

bool are_new(const VisibilityRows::Changed& changed) {
  return dynamic_cast<const LazyRows*>(changed.rows.get()) != nullptr;
}

TEST(ChangedRows, AreThoseOfTheWorldAfterEachChange) {
  std::size_t changes = 0, kept_rows = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed + 100, 14);
    std::shared_ptr<const VisibilityRows> rows = make_lazy_rows(world);
    for (int step = 0; step < 4; ++step) {
      const std::vector<ObstacleId> removed = test::draw_obstacles(world, 6, random);
      const World after = world.changed(removed, to_map_file(test::nasty_world(random.bits(), 1)).obstacles);
      const WorldChange change(world, after, removed);
      const auto changed = rows->changed(after, change, make_reference_queries(after).visibility);
      if (!changed) break;
      ++changes;
      kept_rows += after.convex_vertices().size() - changed->may_differ.size();
      expect_right(*rows, *changed, after, change);
      if (HasFatalFailure()) return;
      rows = changed->rows;
      world = after;
    }
  }
  EXPECT_GT(changes, 150u);
  EXPECT_GT(kept_rows, 500u);
}

TEST(ChangedRows, AreRightWhereObstaclesOnlyVanish) {
  std::size_t changes = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const World world = test::nasty_world(seed + 300, 14);
    if (world.obstacle_count() == 0) continue;
    const std::vector<ObstacleId> removed{static_cast<ObstacleId>(seed % world.obstacle_count())};
    const World after = world.changed(removed, {});
    const auto rows = make_lazy_rows(world);
    const WorldChange change(world, after, removed);
    const auto changed = rows->changed(after, change, make_reference_queries(after).visibility);
    if (!changed) continue;
    ++changes;
    expect_right(*rows, *changed, after, change);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(changes, 20u);
}

// The rows of a world after an obstacle came, and then another one went. Those in between are right as well.
VisibilityRows::Changed rows_after(const World& world, const Polygon& added, ObstacleId removed) {
  const World between = world.changed({}, {added});
  const std::vector<ObstacleId> gone{removed};
  const World after = between.changed(gone, {});
  const WorldChange first(world, between, {}), second(between, after, gone);
  const auto rows = make_lazy_rows(world);
  const auto changed = rows->changed(between, first, make_reference_queries(between).visibility);
  expect_right(*rows, changed.value(), between, first);
  const auto again = changed->rows->changed(after, second, make_reference_queries(after).visibility);
  expect_right(*changed->rows, again.value(), after, second);
  return *again;
}

// A vertex that was covered by an obstacle which came and went again is new.
TEST(ChangedRows, MayDifferWhereWhatCoveredAVertexGoesAgain) {
  const World world({{test::square(0, 0, 4), {}},
                     {test::square(9, 0, 2), {}},
                     {test::square(0, 9, 1), {}},
                     {test::square(9, 9, 1), {}}});
  const Polygon covering{test::square(3, 3, 2), {}};
  ASSERT_EQ(world.changed({}, {covering}).convex_vertices().size() + 2, world.convex_vertices().size() + 4);
  EXPECT_FALSE(are_new(rows_after(world, covering, 4)));
}

// An obstacle that came within another one is seen once that one has gone.
TEST(ChangedRows, ShowWhatCameBeforeWhatHidItWent) {
  const World world({{test::square(0, 0, 6), {}}, {test::square(9, 0, 2), {}}, {test::square(-9, 0, 2), {}}});
  EXPECT_FALSE(are_new(rows_after(world, {test::square(2, 2, 1), {}}, 0)));
}

TEST(ChangedRows, FewMayDifferWhereAnObstacleMovesForEver) {
  World world = catalog_world("clutter/convex/n200/m8/f30/s3");
  Polygon moving = to_map_file(world).obstacles[100];
  std::shared_ptr<const VisibilityRows> rows = make_lazy_rows(world);
  const std::vector<ObstacleId> removed{100};
  for (int step = 0; step < 100; ++step) {
    for (Vec2& p : moving.outer) p += step % 20 < 10 ? Vec2(0.5, 0.0) : Vec2(-0.5, 0.0);
    const World after = world.changed(removed, {moving});
    const auto changed =
        rows->changed(after, WorldChange(world, after, removed), make_reference_queries(after).visibility);
    ASSERT_TRUE(changed.has_value());
    EXPECT_LT(changed->may_differ.size(), world.convex_vertices().size() / 3);
    rows = changed->rows;
    world = after;
  }
  const auto anew = make_lazy_rows(world);
  for (const VertexId v : world.convex_vertices()) ASSERT_TRUE(std::ranges::equal(rows->of(v), anew->of(v))) << v;
}

TEST(ChangedRows, AreMadeAnewWhereTheTriangulationEnds) {
  const World world({{test::square(0, 0, 4), {}}, {test::square(9, 0, 2), {}}});
  const World after = world.changed({}, {{test::square(1e6, 0, 1), {}}});
  const auto rows = make_lazy_rows(world);
  const WorldChange change(world, after, {});
  const auto changed = rows->changed(after, change, make_reference_queries(after).visibility);
  ASSERT_TRUE(changed.has_value());
  EXPECT_TRUE(are_new(*changed));
  expect_right(*rows, *changed, after, change);
}

// Obstacles that move a little, again and again, in worlds where they touch, nest and overlap.
TEST(ChangedRows, FollowObstaclesThatMoveAmongOthers) {
  std::size_t changes = 0, made_anew = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed + 700, 20);
    std::shared_ptr<const VisibilityRows> rows = make_lazy_rows(world);
    for (int step = 0; step < 8 && world.obstacle_count() > 0; ++step) {
      const std::vector<ObstacleId> removed{
          static_cast<ObstacleId>(random.integer(0, static_cast<std::int64_t>(world.obstacle_count()) - 1))};
      Polygon moved = world.polygon_of(removed[0]);
      const Vec2 by = (step % 2 == 0 ? 1.0 : 0.37) * random.grid_point(-1, 1);
      for (Vec2& p : moved.outer) p += by;
      for (Ring& hole : moved.holes)
        for (Vec2& p : hole) p += by;
      const World after = world.changed(removed, {moved});
      const WorldChange change(world, after, removed);
      const auto changed = rows->changed(after, change, make_reference_queries(after).visibility);
      if (!changed) break;
      ++changes;
      made_anew += are_new(*changed) ? 1 : 0;
      expect_right(*rows, *changed, after, change);
      if (HasFatalFailure()) return;
      rows = changed->rows;
      world = after;
    }
  }
  EXPECT_GT(changes, 300u);
  EXPECT_LT(made_anew, changes / 5);
}

TEST(ChangedRows, AreNotMadeAnewWhileFewHaveMoved) {
  World world = catalog_world("clutter/convex/n1000/m10/f30/s1");
  std::shared_ptr<const VisibilityRows> rows = make_lazy_rows(world);
  for (ObstacleId o = 0; o < 120; ++o) {
    const std::vector<ObstacleId> removed{o};
    Polygon moved = world.polygon_of(o);
    for (Vec2& p : moved.outer) p += Vec2(0.05, 0.0);
    const World after = world.changed(removed, {moved});
    const auto changed =
        rows->changed(after, WorldChange(world, after, removed), make_reference_queries(after).visibility);
    ASSERT_TRUE(changed.has_value());
    ASSERT_FALSE(are_new(*changed)) << o;
    EXPECT_LT(changed->may_differ.size(), world.convex_vertices().size() / 3);
    rows = changed->rows;
    world = after;
  }
  const auto anew = make_lazy_rows(world);
  for (VertexId v = 0; v < world.vertices().size(); v += 7)
    ASSERT_TRUE(std::ranges::equal(rows->of(v), anew->of(v))) << v;
}

TEST(ChangedRows, AreMadeAnewOnceMuchHasChanged) {
  World world = catalog_world("clutter/convex/n200/m8/f30/s3");
  std::shared_ptr<const VisibilityRows> rows = make_lazy_rows(world);
  int made_anew = 0;
  for (ObstacleId step = 0; step < 40; ++step) {
    SCOPED_TRACE(step);
    const std::vector<ObstacleId> removed{step};  // another one each time
    Polygon moved = world.polygon_of(step);
    for (Vec2& p : moved.outer) p += Vec2(0.3, 0.0);
    const World after = world.changed(removed, {moved});
    const WorldChange change(world, after, removed);
    const auto changed = rows->changed(after, change, make_reference_queries(after).visibility);
    ASSERT_TRUE(changed.has_value());
    if (are_new(*changed)) {
      ++made_anew;
      EXPECT_LT(changed->may_differ.size(), world.convex_vertices().size() / 3);
      expect_right(*rows, *changed, after, change);
      if (HasFatalFailure()) return;
    }
    rows = changed->rows;
    world = after;
  }
  EXPECT_GT(made_anew, 0);
  EXPECT_LT(made_anew, 10);
}

}  // namespace
}  // namespace arcway::internal
