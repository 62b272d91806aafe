#include "arcway/datasets/clutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/geometry/predicates.h"

namespace arcway::internal {
namespace {

double area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * twice;
}

double clutter_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

// The distance of two outlines. None lies inside another one, or the areas would not add up.
double clutter_distance(const Ring& r, const Ring& s) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < r.size(); ++i)
    for (std::size_t j = 0; j < s.size(); ++j) {
      const Vec2 &a = r[i], &b = r[(i + 1) % r.size()], &c = s[j], &d = s[(j + 1) % s.size()];
      if (relate({a, b}, {c, d}) != SegmentRelation::kDisjoint) return 0.0;
      least = std::min({least, clutter_distance(a, c, d), clutter_distance(c, a, b)});
    }
  return least;
}

struct ClutterCase {
  ClutterKind kind;
  std::size_t vertices;
  double fill;
};
class ClutterTest : public ::testing::TestWithParam<ClutterCase> {};

TEST_P(ClutterTest, MeetsItsPromises) {
  const auto [kind, vertices, fill] = GetParam();
  const std::size_t expected = kind == ClutterKind::kRectangle ? 4 : vertices;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Clutter clutter =
        generate_clutter({.kind = kind, .obstacles = 60, .vertices = vertices, .fill = fill, .seed = seed});
    ASSERT_EQ(clutter.obstacles.size(), 60u);
    const double side = clutter.bounds[2].x();
    double sum = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
      const Ring& ring = clutter.obstacles[i].outer;
      ASSERT_EQ(ring.size(), expected);
      EXPECT_GT(area(ring), 0.0);
      sum += area(ring);
      for (const Vec2& p : ring) EXPECT_GE(std::min({p.x(), p.y(), side - p.x(), side - p.y()}), 0.2);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(clutter_distance(ring, clutter.obstacles[j].outer), 0.2) << i << ' ' << j;
      std::size_t reflex = 0;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        reflex += orientation(ring[k], ring[(k + 1) % ring.size()], ring[(k + 2) % ring.size()]) <= 0 ? 1 : 0;
        for (std::size_t m = k + 2; m < ring.size(); ++m)
          if (k != 0 || m + 1 != ring.size()) {
            EXPECT_EQ(relate({ring[k], ring[k + 1]}, {ring[m], ring[(m + 1) % ring.size()]}),
                      SegmentRelation::kDisjoint);
          }
      }
      if (kind == ClutterKind::kConvex || kind == ClutterKind::kRectangle) {
        EXPECT_EQ(reflex, 0u);
      }
    }
    EXPECT_NEAR(sum / (side * side), fill, 1e-12);
  }
}

std::vector<ClutterCase> cases() {
  std::vector<ClutterCase> all;
  for (const ClutterKind kind :
       {ClutterKind::kConvex, ClutterKind::kStar, ClutterKind::kMixed, ClutterKind::kRectangle})
    for (const std::size_t vertices : {3u, 8u, 17u})
      for (const double fill : {0.05, 0.3, 0.5}) all.push_back({kind, vertices, fill});
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, ClutterTest, ::testing::ValuesIn(cases()));

TEST(Clutter, DependsOnItsParametersOnly) {
  const ClutterParameters parameters{.kind = ClutterKind::kMixed, .obstacles = 500, .fill = 0.4, .seed = 9};
  const Clutter a = generate_clutter(parameters), b = generate_clutter(parameters);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_EQ(a.obstacles[i].outer, b.obstacles[i].outer);
  ClutterParameters other = parameters;
  other.seed = 10;
  EXPECT_NE(generate_clutter(other).obstacles[0].outer, a.obstacles[0].outer);
}

TEST(Clutter, HundredThousandObstacles) {
  for (const double fill : {0.02, 0.3, 0.5})
    EXPECT_EQ(generate_clutter({.obstacles = 100000, .vertices = 4, .fill = fill}).obstacles.size(), 100000u);
}

TEST(Clutter, RefusesWhatCannotBe) {
  const auto message = [](const ClutterParameters& parameters) -> std::string {
    try {
      generate_clutter(parameters);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message({.fill = 0.9}), "clutter: fill is 0.9, must be in (0, 0.6]");
  EXPECT_EQ(message({.fill = 1e-320}), "clutter: fill is 1e-320, must be large enough for a square of at most 1e+09 m");
  EXPECT_EQ(message({.vertices = 2}), "clutter: vertices is 2, must be at least 3");
  EXPECT_EQ(message({.obstacles = std::size_t{1} << 61, .vertices = 8}),
            "clutter: obstacles is 2305843009213693952 with 8 vertices each, at most 268435456 vertices are made");
  EXPECT_NE(message({.obstacles = 1, .vertices = SIZE_MAX}).find("at most 268435456 vertices"), std::string::npos);
  EXPECT_NE(message({.fill = 0.5, .min_gap = 5.0}).find("cannot reach fill 0.5 with gap 5 m"), std::string::npos);
  EXPECT_EQ(message({.min_radius = 5, .max_radius = 4}),
            "clutter: max_radius is 4, must be at least min_radius and at most 1e6");
}

TEST(Clutter, MakesWorlds) {
  const World world = random_world({.kind = ClutterKind::kStar, .obstacles = 50, .vertices = 7});
  EXPECT_EQ(world.obstacle_count(), 50u);
  EXPECT_TRUE(world.has_bounds());
}

}  // namespace
}  // namespace arcway::internal
