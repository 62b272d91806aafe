#include "core/model/outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "arcway/datasets/map_file.h"
#include "arcway/world_change.h"
#include "tests/support/nasty_worlds.h"

namespace arcway::internal {
namespace {

// The first vertex, the points and the box of a piece.
using Known = std::tuple<VertexId, std::vector<double>>;
Known known(const Outlines::Piece& piece) {
  std::vector<double> numbers{piece.box.min.x(), piece.box.min.y(), piece.box.max.x(), piece.box.max.y()};
  for (const Vec2& p : piece.points) numbers.insert(numbers.end(), {p.x(), p.y()});
  return {piece.first, std::move(numbers)};
}

std::vector<Known> visited(const Outlines& outlines, const Box& query) {
  std::vector<Known> found;
  outlines.visit_if([&](const Box& box) { return box.overlaps(query); },
                    [&](const Outlines::Piece& piece) {
                      found.push_back(known(piece));
                      return true;
                    });
  return found;
}

std::vector<Known> visited_near_first(const Outlines& outlines, const Box& query) {
  std::vector<Known> found;
  outlines.visit_near_first(
      query.min, [&](const Box& box) { return box.overlaps(query); },
      [&](const Outlines::Piece& piece) { found.push_back(known(piece)); });
  std::ranges::sort(found);
  return found;
}

void expect_pieces_of_new_ones(const Outlines& outlines, const World& world) {
  const Outlines anew(world);
  std::vector<Known> pieces;
  for (std::uint32_t i = 0; i < outlines.size(); ++i)
    if (outlines.has(i)) pieces.push_back(known(outlines[i]));
  std::vector<Known> expected;
  for (std::uint32_t i = 0; i < anew.size(); ++i) expected.push_back(known(anew[i]));
  std::ranges::sort(pieces);
  ASSERT_EQ(pieces, expected);
  for (VertexId v = 0; v < world.vertices().size(); ++v) {
    ASSERT_TRUE(outlines.has(outlines.index_of(v)));
    const Outlines::Piece piece = outlines[outlines.index_of(v)];
    ASSERT_TRUE(piece.first <= v && v < piece.first + piece.edge_count()) << v;
  }
  for (const Box& query : {world.box(), Box{{0, 0}, {3, 3}}, Box{{2, 5}, {9, 6}}}) {
    std::vector<Known> found = visited(outlines, query), found_anew = visited(anew, query);
    EXPECT_EQ(visited(outlines.as_new(), query), found_anew) << "in the same order";
    std::ranges::sort(found);
    std::ranges::sort(found_anew);
    EXPECT_EQ(found, found_anew);
    EXPECT_EQ(visited_near_first(outlines, query), found_anew);
  }
}

TEST(Outlines, AfterChangesHaveThePiecesOfNewOnes) {
  std::size_t changes = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    test::RandomInputs random(seed);
    World world = test::nasty_world(seed, 60);
    Outlines outlines(world);
    for (int step = 0; step < 4; ++step) {
      std::vector<ObstacleId> removed;
      for (ObstacleId o = 0; o < world.obstacle_count(); ++o)
        if (random.integer(0, 40) == 0) removed.push_back(o);
      const World after = world.changed(removed, to_map_file(test::nasty_world(random.bits(), 2)).obstacles);
      const VertexMap map(WorldChange(world, after, removed));
      if (outlines.can_change(map)) {
        const Outlines changed(outlines, after, map);
        EXPECT_TRUE(changed.shares_pieces_with(outlines));
        outlines = changed;
        ++changes;
      } else {
        outlines = Outlines(after);
        ++refused;
      }
      expect_pieces_of_new_ones(outlines, after);
      if (HasFatalFailure()) return;
      world = after;
    }
  }
  EXPECT_GT(changes, 50u);
  EXPECT_GT(refused, 10u);
}

}  // namespace
}  // namespace arcway::internal
