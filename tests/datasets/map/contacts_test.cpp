#include "datasets/map/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/geometry/distance.h"
#include "core/geometry/predicates.h"
#include "tests/support/boxes.h"
#include "tests/support/random_inputs.h"

namespace arcway::internal {
namespace {

using test::box;

// "none", "touching", ... of two polygons; the answer for the swapped pair must be the mirrored one.
std::string relation(const Polygon& a, const Polygon& b) {
  const auto name = [](const std::vector<Polygon>& pair) -> std::string {
    const std::vector<RegionContact> contacts = find_contacts(pair);
    if (contacts.empty()) return "none";
    switch (contacts.at(0).relation) {
      case RegionRelation::kTouching:
        return "touching";
      case RegionRelation::kOverlapping:
        return "overlapping";
      case RegionRelation::kFirstInside:
        return "first inside";
      case RegionRelation::kSecondInside:
        return "second inside";
      case RegionRelation::kEqual:
        return "equal";
    }
    return "";
  };
  const std::string forth = name({a, b}), back = name({b, a});
  EXPECT_EQ(back, forth == "first inside" ? "second inside" : forth == "second inside" ? "first inside" : forth);
  return forth;
}

TEST(Contacts, OfTwoPolygons) {
  const Polygon square = box(0, 0, 10, 10);
  EXPECT_EQ(relation(square, box(11, 0, 20, 10)), "none");
  EXPECT_EQ(relation(square, box(10, 10, 20, 20)), "touching");  // in a corner
  EXPECT_EQ(relation(square, box(10, 3, 20, 7)), "touching");    // along part of an edge
  EXPECT_EQ(relation(square, box(10, 0, 20, 10)), "touching");   // along a whole edge
  EXPECT_EQ(relation(square, {{{10, 5}, {15, 0}, {15, 9}}, {}}), "touching");
  EXPECT_EQ(relation(square, box(5, 5, 15, 15)), "overlapping");
  EXPECT_EQ(relation(square, box(2, -5, 8, 15)), "overlapping");
  EXPECT_EQ(relation(square, box(0, 0, 20, 5)), "overlapping");  // no proper crossing: edges run along each other
  EXPECT_EQ(relation(square, box(2, 2, 8, 8)), "second inside");
  EXPECT_EQ(relation(square, box(0, 0, 5, 5)), "second inside");  // in the corner
  EXPECT_EQ(relation(square, {{{0, 0}, {10, 10}, {0, 10}}, {}}), "second inside");
  EXPECT_EQ(relation(square, square), "equal");
  EXPECT_EQ(relation(square, {{{0, 10}, {10, 10}, {10, 0}, {5, 0}, {0, 0}}, {}}), "equal");  // clockwise, one more
  // Two triangles that share all their corners' lines but cross through vertices only.
  EXPECT_EQ(relation({{{0, 0}, {4, 0}, {2, 4}}, {}}, {{{2, 0}, {3, 2}, {1, 2}}, {}}), "second inside");
  EXPECT_EQ(relation({{{0, 0}, {4, 4}, {0, 8}}, {}}, {{{0, 4}, {4, 4}, {8, 2}}, {}}), "overlapping");
}

TEST(Contacts, OfPolygonsWithHoles) {
  const Polygon frame{box(0, 0, 10, 10).outer, {box(2, 2, 8, 8).outer}};
  EXPECT_EQ(relation(frame, box(3, 3, 7, 7)), "none");
  EXPECT_EQ(relation(frame, box(2, 3, 7, 7)), "touching");  // from within the hole
  EXPECT_EQ(relation(frame, box(2, 2, 8, 8)), "touching");  // fills the hole
  EXPECT_EQ(relation(frame, box(1, 3, 7, 7)), "overlapping");
  EXPECT_EQ(relation(frame, box(0.5, 0.5, 1, 9)), "second inside");
  EXPECT_EQ(relation(frame, box(0, 0, 10, 10)), "first inside");
  EXPECT_EQ(relation(frame, box(-1, -1, 11, 11)), "first inside");
  EXPECT_EQ(relation(frame, frame), "equal");
  // A hole that touches the outer ring in a point is no way in.
  const Polygon pinched{box(0, 0, 10, 10).outer, {Ring{{0, 5}, {5, 3}, {5, 7}}}};
  EXPECT_EQ(relation(pinched, {{{0, 5}, {-3, 7}, {-3, 3}}, {}}), "touching");
  EXPECT_EQ(relation(pinched, {{{0, 5}, {3, 4.9}, {3, 5.1}}, {}}), "touching");
  EXPECT_EQ(relation(pinched, {{{0, 5}, {3, 1}, {3, 2}}, {}}), "second inside");
}

// On a small grid contacts of all kinds are common. Areas on a finer grid decide independently: a cell of half-integer
// offset lies inside or outside, if all coordinates are even.
TEST(Contacts, AgreeWithAreasOnAGrid) {
  test::RandomInputs random(11);
  std::vector<int> seen(5, 0);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto draw = [&] {
      // Rectilinear: a box, perhaps with a corner or a hole cut out.
      const double x = 2.0 * static_cast<double>(random.integer(0, 3)),
                   y = 2.0 * static_cast<double>(random.integer(0, 3));
      const double w = 2.0 * static_cast<double>(random.integer(1, 4)),
                   h = 2.0 * static_cast<double>(random.integer(1, 4));
      Polygon polygon = box(x, y, x + w, y + h);
      if (w > 2.0 && h > 2.0 && random.integer(0, 2) == 0)
        polygon.outer = {{x, y},    {x + w, y}, {x + w, y + h - 2}, {x + w - 2, y + h - 2}, {x + w - 2, y + h},
                         {x, y + h}};
      else if (w > 4.0 && h > 4.0 && random.integer(0, 1) == 0)
        polygon.holes = {box(x + 2, y + 2, x + w - 2, y + h - 2).outer};
      return polygon;
    };
    const Polygon a = draw(), b = draw();
    const auto inside = [](const Polygon& p, const Vec2& q) {
      return locate(q, p.outer) == PointLocation::kInside &&
             (p.holes.empty() || locate(q, p.holes[0]) != PointLocation::kInside);
    };
    bool both = false, first = false, second = false;
    for (double x = 1; x < 16; x += 2)
      for (double y = 1; y < 16; y += 2) {
        const bool in_a = inside(a, {x, y}), in_b = inside(b, {x, y});
        both = both || (in_a && in_b);
        first = first || (in_a && !in_b);
        second = second || (in_b && !in_a);
      }
    const std::string found = relation(a, b);
    if (!both) {
      EXPECT_TRUE(found == "none" || found == "touching") << trial << ' ' << found;
      ++seen[0];
    } else {
      const std::string expected = first && second ? "overlapping"
                                   : first         ? "second inside"
                                   : second        ? "first inside"
                                                   : "equal";
      EXPECT_EQ(found, expected) << trial;
      ++seen[first && second ? 1 : first ? 2 : second ? 3 : 4];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 3);
}

TEST(Contacts, AreWhereSidesCrossHoweverNearlyParallel) {
  const LineSegment s{{8, -4}, {-18, 20}},
      t{{0.76719719030916611, 2.6764333627915393}, {-13.732809012683973, 16.061054473246742}};
  ASSERT_EQ(relate(s, t), SegmentRelation::kCrossing);
  const auto contacts = find_contacts(std::vector<Polygon>{{{s.a, s.b, {70, 70}}, {}}, {{t.a, t.b, {-70, -70}}, {}}});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_LE(distance(contacts[0].place, s) + distance(contacts[0].place, t), 1e-13);
}

// Pairs as they are found two by two, whichever way many are looked through.
void expect_pairs_of_two(const std::vector<Polygon>& polygons) {
  std::vector<RegionContact> expected;
  for (std::uint32_t a = 0; a < polygons.size(); ++a)
    for (std::uint32_t b = a + 1; b < polygons.size(); ++b)
      for (RegionContact contact : find_contacts(std::vector<Polygon>{polygons[a], polygons[b]})) {
        contact.first = a;
        contact.second = b;
        expected.push_back(contact);
      }
  const std::vector<RegionContact> found = find_contacts(polygons);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(std::pair(found[i].first, found[i].second), std::pair(expected[i].first, expected[i].second));
    EXPECT_EQ(found[i].relation, expected[i].relation) << found[i].first << ' ' << found[i].second;
    EXPECT_EQ(found[i].boundaries_meet, expected[i].boundaries_meet) << found[i].first << ' ' << found[i].second;
  }
}

Ring diamond(const Vec2& center, double size) {
  return {center + Vec2(size, 0), center + Vec2(0, size), center - Vec2(size, 0), center - Vec2(0, size)};
}

// Frames, and full ones, around one point: the boxes of all edges overlap. Beside them lie regions that touch some,
// fill their holes, cross some, or lie inside of many.
TEST(Contacts, OfPolygonsInEachOtherAreThoseOfEachPair) {
  for (const bool full : {false, true})
    for (const bool troubled : {false, true}) {
      const Vec2 middle(3.0, -7.0);
      std::vector<Polygon> polygons;
      for (int k = 1; k <= 70; ++k) {
        polygons.push_back({diamond(middle, 4.0 * k), {}});
        if (!full || k % 7 == 0) polygons.back().holes.push_back(diamond(middle, 4.0 * k - 2.0));
      }
      polygons.push_back(box(290, -10, 300, 10));     // beside all
      polygons.push_back(box(-300, -300, 299, 300));  // around nearly all
      polygons.push_back(box(4, -8, 5, -7));
      if (troubled) {
        polygons.push_back({diamond(middle + Vec2(0.0, 400.0), 60.0), {diamond(middle + Vec2(-30.0, 400.0), 30.0)}});
        polygons.push_back({diamond(middle + Vec2(-30.0, 400.0), 2.0), {}});  // in a hole that touches its ring
        polygons.push_back({diamond(middle + Vec2(-20.0, 435.0), 1.0), {}});  // beside the hole above
        polygons.push_back({diamond(middle + Vec2(20.0, 400.0), 1.0), {}});
        polygons.push_back({diamond(middle, 42.0), {}});                    // fills a hole
        polygons.push_back({diamond(middle + Vec2(100.0, 0.0), 6.0), {}});  // crosses some
        polygons.push_back({diamond(middle + Vec2(0.0, 101.0), 1.0), {}});  // touches one
        polygons.push_back(polygons[20]);                                   // twice
        polygons.push_back({diamond(middle, 90.0),
                            {
                                diamond(middle, 70.0),
                            }});  // over several
      }
      expect_pairs_of_two(polygons);
    }
}

TEST(Contacts, AreNoMoreThanAsked) {
  std::vector<Polygon> polygons;
  for (int k = 1; k <= 20'000; ++k) polygons.push_back({diamond({0.0, 0.0}, k), {}});
  const std::vector<RegionContact> found = find_contacts(polygons, 1000);  // of 200 million
  EXPECT_EQ(found.size(), 1000u);
  for (const RegionContact& contact : found) ASSERT_EQ(contact.relation, RegionRelation::kFirstInside);
}

TEST(Contacts, OfManyPolygons) {
  std::vector<Polygon> boxes;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j) boxes.push_back(box(i, j, i + 1, j + 1));
  // 2 * 30 * 29 pairs share an edge, 2 * 29 * 29 a corner.
  EXPECT_EQ(find_contacts(boxes).size(), 2u * 30 * 29 + 2u * 29 * 29);
}

}  // namespace
}  // namespace arcway::internal
