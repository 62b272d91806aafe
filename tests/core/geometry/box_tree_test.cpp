#include "core/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "arcway/executor.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

TEST(BoxTree, FindsWhatAScanFinds) {
  test::RandomInputs random(1);
  for (const std::size_t n : {0u, 1u, 4u, 5u, 33u, 1000u}) {
    std::vector<Box> boxes(n);
    for (Box& box : boxes) {
      box.extend(random.grid_point(0, 50));
      box.extend(Vec2(box.min + random.point(0, 3)));
    }
    const BoxTree tree(boxes);
    EXPECT_EQ(tree.size(), n);
    for (int k = 0; k < 200; ++k) {
      Box query;
      query.extend(random.grid_point(0, 50));
      query.extend(Vec2(query.min + random.point(0, 20)));
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < n; ++i) {
        if (boxes[i].overlaps(query)) expected.push_back(i);
      }
      std::vector<std::uint32_t> found;
      EXPECT_TRUE(tree.visit_overlaps(query, [&](std::uint32_t i) {
        found.push_back(i);
        return true;
      }));
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
      found.clear();
      tree.visit_near_first(
          random.point(0, 50), [&](const Box& box) { return box.overlaps(query); },
          [&](std::uint32_t i) { found.push_back(i); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsOtherBoxesAsWell) {
  test::RandomInputs random(3);
  for (const std::size_t n : {0u, 1u, 4u, 5u, 33u, 1000u}) {
    std::vector<Box> boxes(n), others(n);
    for (std::size_t i = 0; i < n; ++i) {
      boxes[i].extend(random.grid_point(0, 50));
      others[i] = boxes[i].grown(random.uniform(0.0, 3.0));
      if (i % 7 == 0) others[i] = Box{{-9, -9}, {-8, -8}};  // may lie elsewhere
    }
    const BoxTree tree = BoxTree(boxes).with_boxes(others);
    EXPECT_EQ(tree.size(), n);
    for (int k = 0; k < 200; ++k) {
      Box query;
      query.extend(random.grid_point(-10, 50));
      query.extend(Vec2(query.min + random.point(0, 10)));
      std::vector<std::uint32_t> expected, found;
      for (std::uint32_t i = 0; i < n; ++i)
        if (others[i].overlaps(query)) expected.push_back(i);
      tree.visit_near_first(
          random.point(0, 50), [&](const Box& box) { return box.overlaps(query); },
          [&](std::uint32_t i) { found.push_back(i); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
      found.clear();
      tree.visit_overlaps(query, [&](std::uint32_t i) {
        found.push_back(i);
        return true;
      });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
    }
  }
}

// Upper and lower edges of squares in each other: their middles are spread along y alone, while their boxes are as wide
// as high in all.
TEST(BoxTree, LooksAtFewOfBoxesAroundOnePlace) {
  constexpr int kCount = 10'000;
  for (const double jitter : {0.0, 0.1}) {
    test::RandomInputs random(3);
    std::vector<Box> boxes;
    for (int i = 1; i <= kCount; ++i)
      for (const double y : {-1.0 * i, 1.0 * i}) {
        const double middle = random.uniform(-jitter, jitter) * i;
        boxes.push_back({Vec2(middle - i, y), Vec2(middle + i, y)});
      }
    const BoxTree tree(boxes);
    for (const double side : {10.0, 1000.0, 9000.0}) {
      const Box asked{Vec2(side, side - 0.5), Vec2(side, side + 0.5)};
      std::size_t looks = 0;
      tree.visit_if(
          [&](const Box& box) {
            ++looks;
            return box.overlaps(asked);
          },
          [](std::uint32_t) { return true; });
      EXPECT_LT(looks, 300u) << side;
    }
  }
}

TEST(BoxTree, StopsWhenTold) {
  const std::vector<Box> boxes(20, Box{{0, 0}, {1, 1}});
  int visits = 0;
  EXPECT_FALSE(BoxTree(boxes).visit_overlaps(boxes[0], [&](std::uint32_t) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
  EXPECT_TRUE(BoxTree(boxes).visit_overlaps(Box{}, [](std::uint32_t) { return false; }));
}

TEST(BoxTree, IsNotBuiltOnceTheClockIsOver) {
  const std::vector<Box> boxes(1000, Box{{0, 0}, {1, 1}});
  EXPECT_THROW(BoxTree(boxes, StopClock(0.0)), Canceled);
  EXPECT_EQ(BoxTree(boxes, StopClock(3600.0)).size(), boxes.size());
}

TEST(BoxTree, VisitsWhatIsNearEarly) {
  test::RandomInputs random(2);
  std::vector<Box> boxes(1000);
  for (Box& box : boxes) box.extend(random.point(0, 50));
  boxes.push_back({{-50, -50}, {100, 100}});  // no place is near to it alone
  const BoxTree tree(boxes);
  std::ptrdiff_t before = 0;  // the nearest one
  for (int k = 0; k < 100; ++k) {
    const Vec2 place = random.point(0, 50);
    const auto distance = [&](std::uint32_t i) { return (boxes[i].min - place).norm(); };
    std::vector<double> distances;
    tree.visit_near_first(
        place, [](const Box&) { return true; }, [&](std::uint32_t i) { distances.push_back(distance(i)); });
    ASSERT_EQ(distances.size(), boxes.size());
    before += std::min_element(distances.begin(), distances.end()) - distances.begin();
  }
  EXPECT_LT(before, 100 * 50);
}

}  // namespace
}  // namespace arcway::internal
