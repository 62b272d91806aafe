#include "core/geometry/simplicity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "arcway/world.h"
#include "core/geometry/predicates.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/random_inputs.h"
#include "tests/support/touching_worlds.h"

namespace arcway::internal {
namespace {

using test::RandomInputs;
using test::square;

// Whole coordinates: pinches, contacts, overlaps and crossings of every kind. Few enough edges for all pairs.
Polygon random_polygon(RandomInputs& random) {
  const std::int64_t size = random.integer(2, 9);
  Polygon polygon{test::grid_ring(random, size), {}};
  if (random.integer(0, 2) == 0) {
    polygon.outer.clear();
    for (std::int64_t i = random.integer(3, 7); i > 0; --i) polygon.outer.push_back(random.grid_point(0, size));
  }
  for (std::int64_t h = random.integer(0, 4); h > 0; --h) polygon.holes.push_back(test::grid_ring(random, size));
  return polygon;
}

TEST(Simplicity, FindsConflictsWhereAllPairsDo) {
  RandomInputs random(1);
  int conflicts = 0, simple = 0;
  for (int round = 0; round < 20000; ++round) {
    const Polygon polygon = random_polygon(random);
    const auto conflict = find_conflict(polygon);
    if (conflict && conflict->kind == RingConflict::Kind::kRepeatedVertex) continue;
    ASSERT_EQ(has_conflict(polygon), conflict.has_value()) << "round " << round;
    ++(conflict ? conflicts : simple);
  }
  EXPECT_GT(conflicts, 3000);
  EXPECT_GT(simple, 3000);
}

TEST(Simplicity, ListsTheContactsThatAllPairsHave) {
  RandomInputs random(3);
  std::size_t count = 0;
  for (int round = 0; round < 1000; ++round) {
    const Polygon polygon = test::touching_polygon(random, 6);
    const auto listed = [&](const auto& find) {
      std::vector<RingContact> contacts;
      find(&contacts);
      std::vector<std::array<std::size_t, 4>> sorted;
      for (const RingContact& c : contacts) sorted.push_back({c.edge_ring, c.edge, c.vertex_ring, c.vertex});
      std::ranges::sort(sorted);
      return sorted;
    };
    const auto by_pairs = listed([&](auto* contacts) { ASSERT_FALSE(find_conflict(polygon, contacts)); });
    ASSERT_EQ(listed([&](auto* contacts) { ASSERT_FALSE(has_conflict(polygon, contacts)); }), by_pairs);
    count += by_pairs.size();
  }
  EXPECT_GT(count, 300u);
}

TEST(Simplicity, AcceptsHolesWhereWorldDoes) {
  RandomInputs random(2);
  int misplaced = 0, nested = 0;
  for (int round = 0; round < 60000; ++round) {
    Polygon polygon = random_polygon(random);
    if (round % 2 == 0) polygon.outer = square(0, 0, 9);
    if (polygon.holes.empty() || find_conflict(polygon)) continue;
    bool is_accepted = true;
    try {
      const World world({polygon});
    } catch (const WorldError&) {
      is_accepted = false;
    }
    ASSERT_EQ(holes_are_nested(polygon), is_accepted) << "round " << round;
    ++(is_accepted ? nested : misplaced);
  }
  EXPECT_GT(misplaced, 500);
  EXPECT_GT(nested, 500);
}

// So many edges with common boxes that find_conflict sweeps.
TEST(Simplicity, NamesTheFirstConflictAmongNeedles) {
  Ring needles;
  const std::size_t n = 800;
  for (std::size_t i = 0; i < n; ++i)
    needles.push_back((i % 2 == 0 ? 10.0 : 3.0) * direction_of(kTwoPi * static_cast<double>(i) / n));
  EXPECT_FALSE(find_conflict({needles, {}}));
  needles[700] = 6.0 * direction_of(kTwoPi * 20.5 / n);
  const auto conflict = find_conflict({needles, {}});
  ASSERT_TRUE(conflict);
  std::size_t first = n;
  for (std::size_t i = 0; i < n && first == n; ++i)
    for (const std::size_t other : {std::size_t{699}, std::size_t{700}})
      if (relate({needles[i], needles[i + 1]}, {needles[other], needles[other + 1]}) == SegmentRelation::kCrossing)
        first = i;
  EXPECT_EQ(conflict->edge_a, first);
}

// Each hole's box holds those of all holes before it.
TEST(Simplicity, TakesHolesWithNestedBoxes) {
  const int holes = 400;
  Polygon polygon{square(-1000, -1000, 3000), {}};
  for (int k = 0; k < holes; ++k) {
    const double a = 2.0 * k;
    polygon.holes.push_back({{a, -900}, {a + 1, -900}, {a + 1, a + 1}, {-900, a + 1}, {-900, a}, {a, a}});
  }
  EXPECT_EQ(World({polygon}).vertices().size(), 4u + 6u * holes);
  polygon.holes.push_back(square(-899, 2.25, 0.5));
  try {
    const World world({polygon});
    FAIL() << "accepted";
  } catch (const WorldError& error) {
    EXPECT_STREQ(error.what(), "obstacle 0, ring 401: the hole lies inside the hole of ring 2");
  }
}

}  // namespace
}  // namespace arcway::internal
