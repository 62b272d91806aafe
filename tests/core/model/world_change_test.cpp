#include "arcway/world_change.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

const Polygon kFirst{test::square(0, 0, 4), {}}, kSecond{test::square(9, 9, 2), {}}, kThird{test::square(5, 0, 1), {}};

std::string error_of(const World& before, const World& after, const std::vector<ObstacleId>& removed) {
  try {
    (void)WorldChange(before, after, removed);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(WorldChange, MapsVerticesThatStay) {
  const World before({kFirst, kSecond}, test::square(-1, -1, 20));
  const std::vector<ObstacleId> removed{0};
  const auto expect = [&](const Polygon& added, const std::vector<VertexId>& after, VertexId first, VertexId last) {
    const WorldChange change(before, before.changed(removed, {added}), removed);
    std::vector<VertexId> vertices;
    for (VertexId v = 0; v < change.vertices_before; ++v) vertices.push_back(change.vertex_after(v));
    EXPECT_EQ(vertices, after);
    ASSERT_EQ(change.added_vertices.size(), 1u);
    EXPECT_EQ(change.added_vertices[0].first, first);
    EXPECT_EQ(change.added_vertices[0].last, last);
    EXPECT_EQ(change.removed_boxes.size(), 1u);
    EXPECT_EQ(change.added_boxes.size(), 1u);
  };
  const Polygon triangle{{{5, 0}, {6, 0}, {6, 1}}, {}};
  expect(triangle, {kNone, kNone, kNone, kNone, 0, 1, 2, 3, 7, 8, 9, 10}, 4, 7);
  expect(kThird, {kNone, kNone, kNone, kNone, 4, 5, 6, 7, 8, 9, 10, 11}, 0, 4);
}

// The new obstacle is equal to one that remains.
TEST(WorldChange, TellsWhatWasAddedFromItsLike) {
  const World before({kFirst, kSecond, kThird});
  const std::vector<ObstacleId> removed{0};
  const World after = before.changed(removed, {kSecond});
  const WorldChange change(before, after, removed);
  EXPECT_EQ(change.added_vertices[0].first, 0u);
  EXPECT_EQ(change.vertex_after(4), 4u);
  EXPECT_NE(error_of(before, after, {1}), "");
}

TEST(WorldChange, RefusesWorldsInAnotherOrder) {
  const World before({kFirst, kSecond});
  EXPECT_EQ(error_of(before, World({kFirst, kSecond, kThird}), {}), "");
  const std::string added_first = error_of(before, World({kThird, kFirst, kSecond}), {});
  EXPECT_NE(added_first.find("obstacle 0 of 4 vertices from (0, 0), which is not removed; in its place after it, "
                             "obstacle 0 of 4 vertices from (5, 0)"),
            std::string::npos)
      << added_first;
  EXPECT_NE(added_first.find("World::changed"), std::string::npos);
  EXPECT_NE(error_of(before, World({kFirst}), {}).find("after it, missing"), std::string::npos);
  Polygon turned = kSecond;
  std::swap(turned.outer[1], turned.outer[3]);
  EXPECT_NE(error_of(before, World({kFirst, turned}), {}), "");
}

TEST(WorldChange, RefusesOtherBounds) {
  const World before({kFirst}, test::square(-1, -1, 20)), without({kFirst}), wider({kFirst}, test::square(-1, -1, 30));
  EXPECT_NE(error_of(before, without, {}).find("only the world before has bounds"), std::string::npos);
  EXPECT_NE(error_of(without, before, {}).find("only the world after has bounds"), std::string::npos);
  EXPECT_NE(error_of(before, wider, {}).find("the bounds of 4 vertices"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal
