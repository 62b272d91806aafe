#include "core/geometry/tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace arcway::internal {
namespace {

Box box_to(double x, double y) {
  Box box;
  box.extend(Vec2(0, 0));
  box.extend(Vec2(x, y));
  return box;
}

TEST(Tiles, FollowEachOtherInThePlane) {
  const Tiles tiles(box_to(16, 16), 16 * 16 * 64);
  ASSERT_EQ(tiles.count(), 256u);
  std::vector<Vec2> middle(tiles.count(), {-1, -1});
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y) middle[tiles.of({x + 0.5, y + 0.5})] = {x + 0.5, y + 0.5};
  for (std::uint32_t i = 0; i + 1 < tiles.count(); ++i) {
    EXPECT_GE(middle[i].x(), 0.0) << i;
    EXPECT_EQ((middle[i + 1] - middle[i]).norm(), 1.0) << i;
  }
}

TEST(Tiles, HoldPointsThatLieOutside) {
  const Tiles tiles(box_to(8, 8), 64 * 64);
  EXPECT_EQ(tiles.of({-5, 20}), tiles.of({0, 8}));
  EXPECT_EQ(tiles.of({8, 8}), tiles.of({7.9, 7.9}));
}

TEST(Tiles, TakeBoxesWithoutExtent) {
  for (const Box& box : {box_to(0, 0), box_to(10, 0), box_to(0, 10)}) {
    const Tiles tiles(box, 10000);
    EXPECT_LT(tiles.of({3, 3}), tiles.count());
    EXPECT_EQ(tiles.of({0, 0}), tiles.of({0, 0}));
  }
  EXPECT_EQ(Tiles(box_to(1, 1), 0).count(), 1u);
}

TEST(Tiles, SortStably) {
  const std::vector<std::uint32_t> tiles{2, 0, 1, 0, 2, 1};
  EXPECT_EQ(sorted_by_tile(tiles, 3), (std::vector<std::uint32_t>{1, 3, 2, 5, 0, 4}));
  EXPECT_EQ(places_by_tile(tiles, 3), (std::vector<std::uint32_t>{4, 0, 2, 1, 5, 3}));
  EXPECT_TRUE(sorted_by_tile({}, 0).empty());
}

}  // namespace
}  // namespace arcway::internal
