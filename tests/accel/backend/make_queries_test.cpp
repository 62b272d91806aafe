#include "accel/backend/make_queries.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cfenv>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "accel/embree/configured_queries.h"
#include "arcway/accel/parallel.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "arcway/world_change.h"
#include "tests/support/troublesome_queries.h"

namespace arcway::internal {
namespace {

using test::TroublesomeQueries;

// Number of segments to compare on each instruction set, over all sizes, positions and worlds. The environment variable
// raises it, see accel/README.md.
std::size_t segments_to_compare() {
  const char* text = std::getenv("ARCWAY_COMPARE_SEGMENTS");
  return text != nullptr ? std::stoul(text) : 100'000;
}

struct MapPlace {
  double size;    // [m]
  double offset;  // [m]
};
// Sizes from a millimeter to 1e7 m. Offsets reach 2^30 times the size of a cell, and one lies as far out as doubles
// tell the cells apart.
constexpr MapPlace kMapPlaces[] = {{0x1p-10, 0.0},    {0x1p-10, 0x1p14}, {1.0, 0.0},        {1.0, -0x1p20},
                                   {0x1p7, 0x1p4},    {0x1p7, 0x1p24},   {0x1p10, -0x1p23}, {0x1p14, 0x1p30},
                                   {0x1p24, -0x1p23}, {0x1p24, 0x1p40},  {0x1p7, 0x1p53}};
constexpr std::size_t kSegmentsPerWorld = 1000;

// Queries on a device of one instruction set, or nothing if the machine lacks it.
// @param joined  whether boxes hold several edges, as in large worlds.
std::optional<QuerySet> queries_on(const World& world, const std::string& isa, bool joined) {
  const std::size_t many_edges = joined ? 0 : std::numeric_limits<std::size_t>::max();
  try {
    return embree::make_configured_queries(world, {}, ("isa=" + isa).c_str(), many_edges);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

// Queries of a world that comes from another one by a change: its last obstacle comes in place of one beside it.
// Nothing if that one lies outside of the other world's box, or the machine lacks the instruction set.
std::optional<QuerySet> changed_queries_on(const World& world, const std::string& isa, bool joined) {
  const MapFile map = to_map_file(world);
  std::vector<Polygon> others = map.obstacles;
  const Polygon last = others.back();
  for (Vec2& p : others.back().outer) p += 0.5 * (last.outer[1] - last.outer[0]);
  others.back().holes.clear();
  const World before = World(others, map.bounds);
  const std::optional<QuerySet> queries = queries_on(before, isa, joined);
  if (!queries) return queries;
  const std::vector<ObstacleId> removed{static_cast<ObstacleId>(before.obstacle_count() - 1)};
  const World after = before.changed(removed, {last});
  return change_embree_queries(*queries, after, WorldChange(before, after, removed));
}

class EmbreeOnIsa : public testing::TestWithParam<const char*> {
 protected:
  // Calls compare(questions, embree, reference) for worlds of all sizes and positions, of which many come by a change.
  template <class Compare>
  void for_worlds(std::size_t worlds, const Compare& compare) {
    std::size_t changed_worlds = 0;
    for (std::size_t i = 0; i < worlds; ++i) {
      const MapPlace& place = kMapPlaces[i % std::size(kMapPlaces)];
      TroublesomeQueries questions(1000 + i, place.size, place.offset);
      const std::optional<QuerySet> queries = queries_on(questions.world(), GetParam(), i % 2 == 1);
      if (!queries) GTEST_SKIP() << "this machine has no " << GetParam();
      SCOPED_TRACE("seed " + std::to_string(1000 + i) + ", size " + std::to_string(place.size));
      const auto changed = changed_queries_on(questions.world(), GetParam(), i % 2 == 1);
      const bool compares_changed = i % 3 != 0 && changed;
      compare(questions, compares_changed ? *changed : *queries, make_reference_queries(questions.world()));
      changed_worlds += compares_changed ? 1 : 0;
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(changed_worlds, worlds / 4);
  }
};

INSTANTIATE_TEST_SUITE_P(All, EmbreeOnIsa, testing::Values("sse2", "sse4.2", "avx", "avx2", "avx512"),
                         [](const testing::TestParamInfo<const char*>& isa) {
                           std::string name = isa.param;
                           std::erase(name, '.');
                           return name;
                         });

TEST_P(EmbreeOnIsa, SeesWhatTheReferenceSees) {
  const std::size_t worlds = std::max<std::size_t>(std::size(kMapPlaces), segments_to_compare() / kSegmentsPerWorld);
  std::size_t seen = 0;
  std::size_t asked = 0;
  for_worlds(worlds, [&](TroublesomeQueries& questions, const QuerySet& embree, const QuerySet& reference) {
    std::vector<LineSegment> segments;
    while (segments.size() < kSegmentsPerWorld) segments.push_back(questions.segment());
    std::vector<std::uint8_t> visible(segments.size());
    std::vector<std::uint8_t> expected(segments.size());
    embree.visibility->visible(segments, visible);
    reference.visibility->visible(segments, expected);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      ASSERT_EQ(visible[i], expected[i]) << "segment " << i << " from " << segments[i].a.transpose() << " to "
                                         << segments[i].b.transpose();
      seen += expected[i];
    }
    asked += segments.size();
  });
  if (asked == 0) return;
  RecordProperty("segments", static_cast<int>(asked));
  EXPECT_GT(seen, asked / 20);
  EXPECT_LT(seen, asked - asked / 20);
}

TEST_P(EmbreeOnIsa, MeasuresWhatTheReferenceMeasures) {
  for_worlds(22, [](TroublesomeQueries& questions, const QuerySet& embree, const QuerySet& reference) {
    for (int i = 0; i < 300; ++i) {
      const Vec2 p = questions.point();
      const ClosestPoint expected = reference.distance->closest(p);
      const ClosestPoint closest = embree.distance->closest(p);
      ASSERT_EQ(closest.edge, expected.edge) << p.transpose();
      ASSERT_EQ(closest.distance, expected.distance);
      ASSERT_EQ(closest.point, expected.point);
      ASSERT_EQ(embree.distance->containing(p), reference.distance->containing(p)) << p.transpose();
      const double next = std::nextafter(expected.distance, std::numeric_limits<double>::infinity());
      for (const double d : {0.0, -1.0, 0.5 * expected.distance, expected.distance, next, 3.0 * expected.distance,
                             std::numeric_limits<double>::infinity()}) {
        std::uint8_t closer = 2;
        embree.distance->closer_than({&p, 1}, {&d, 1}, {&closer, 1});
        ASSERT_EQ(closer, expected.distance < d ? 1 : 0) << p.transpose() << " " << d;
      }
    }
  });
}

TEST_P(EmbreeOnIsa, SweepsWhatTheReferenceSweeps) {
  std::size_t free_count = 0;
  std::size_t asked = 0;
  for_worlds(44, [&](TroublesomeQueries& questions, const QuerySet& embree, const QuerySet& reference) {
    for (int i = 0; i < 300; ++i) {
      const SweptRectangle rectangle = questions.rectangle();
      const bool expected = reference.sweep->straight_free(rectangle);
      ASSERT_EQ(embree.sweep->straight_free(rectangle), expected)
          << rectangle[0].transpose() << ", " << rectangle[1].transpose() << ", " << rectangle[2].transpose();
      free_count += expected ? 1 : 0;
      ++asked;
    }
  });
  if (asked == 0) return;
  EXPECT_GT(free_count, asked / 20);
  EXPECT_LT(free_count, asked - asked / 20);
}

TEST_P(EmbreeOnIsa, TurnsWhereTheReferenceTurns) {
  std::size_t partial = 0;
  bool ran = false;
  for_worlds(20, [&](TroublesomeQueries& questions, const QuerySet& embree, const QuerySet& reference) {
    ran = true;
    for (int i = 0; i < 100; ++i) {
      const TurningBody body = questions.turning_body();
      const HeadingSet expected = reference.sweep->free_headings(body);
      const HeadingSet headings = embree.sweep->free_headings(body);
      ASSERT_EQ(headings.intervals().size(), expected.intervals().size());
      for (std::size_t k = 0; k < expected.intervals().size(); ++k) {
        ASSERT_EQ(headings.intervals()[k].low, expected.intervals()[k].low);
        ASSERT_EQ(headings.intervals()[k].high, expected.intervals()[k].high);
      }
      partial += !expected.empty() && !expected.is_full() ? 1 : 0;
    }
  });
  if (ran) {
    EXPECT_GT(partial, 100u);
  }
}

TEST(EmbreeQueries, NeedNotKnowTheBodysWidth) {
  TroublesomeQueries questions(5, 64.0, 0.0);
  const QuerySet reference = make_reference_queries(questions.world());
  for (const double half_width : {1e-6, 0.1, 3.0, 1000.0}) {
    const QuerySet embree = make_embree_queries(questions.world(), {.body_half_width = half_width});
    for (int i = 0; i < 1000; ++i) {
      const SweptRectangle rectangle = questions.rectangle();
      ASSERT_EQ(embree.sweep->straight_free(rectangle), reference.sweep->straight_free(rectangle)) << half_width;
    }
  }
  EXPECT_THROW(make_embree_queries(questions.world(), {.body_half_width = -1.0}), std::invalid_argument);
}

// No double lies between the vertices, so the middles of the map and of the rectangle are rounded.
TEST(EmbreeQueries, AnswerWhereTheLastPlaceIsAsLargeAsTheMap) {
  const double far = 0x1p53;
  const auto shifted = [&](double x, double y) { return Vec2(far + x, far + y); };
  const World small({{test::square(far, far, 2.0), {}}});
  EXPECT_FALSE(make_embree_queries(small).visibility->visible(LineSegment{shifted(4, -2), shifted(-2, 4)}));
  const World above({{{shifted(0, 2), shifted(4, 2), shifted(4, 6), shifted(0, 6)}, {}}});
  const QuerySet queries = make_embree_queries(above, {.body_half_width = 1.0});
  EXPECT_FALSE(queries.sweep->straight_free({shifted(0, 0), shifted(4, 0), shifted(4, 2), shifted(0, 2)}));
}

TEST(EmbreeQueries, AnswerBatchesInParallelAlike) {
  const World world = random_world({.obstacles = 60, .vertices = 8, .fill = 0.25, .seed = 3});
  const QuerySet serial = make_embree_queries(world);
  const QuerySet parallel = make_embree_queries(world, {.batches = std::make_shared<TbbExecutor>(2)});
  test::RandomInputs random(9);
  std::vector<LineSegment> segments;
  std::vector<Vec2> points;
  for (int i = 0; i < 5000; ++i) {
    segments.push_back({random.point(0, 100), random.point(0, 100)});
    points.push_back(random.point(0, 100));
  }
  std::vector<std::uint8_t> seen(segments.size());
  std::vector<std::uint8_t> seen_serially(segments.size());
  parallel.visibility->visible(segments, seen);
  serial.visibility->visible(segments, seen_serially);
  EXPECT_EQ(seen, seen_serially);
  std::vector<ClosestPoint> closest(points.size());
  std::vector<ClosestPoint> closest_serially(points.size());
  parallel.distance->closest(points, closest);
  serial.distance->closest(points, closest_serially);
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(closest[i].edge, closest_serially[i].edge);
}

TEST(EmbreeQueries, AnswerInAWorldWithoutObstacles) {
  const QuerySet queries = make_embree_queries(World({}));
  EXPECT_TRUE(queries.visibility->visible(LineSegment{{0, 0}, {5, 1}}));
  EXPECT_EQ(queries.distance->closest({1, 1}).edge, kNone);
  EXPECT_EQ(queries.distance->containing({1, 1}), kNone);
  EXPECT_TRUE(queries.sweep->straight_free(swept_rectangle({0, 0, 0}, 5.0, {1, 1, 1, 1})));
  EXPECT_TRUE(queries.sweep->free_headings({{0, 0}, 2.0, Side::kLeft, {1, 1, 1, 1}}).is_full());
}

TEST(EmbreeQueries, FindTheRegionAmongManyEdges) {
  // A ring with a jagged outline of many edges, a hole with one, and bounds.
  test::RandomInputs random(4);
  const Ring outer = test::random_star(random, {50, 50}, 30, 45, 400);
  const Ring hole = test::random_star(random, {50, 50}, 10, 20, 300);
  const World world({{outer, {hole}}, {test::square(48, 48, 3), {}}}, test::random_star(random, {50, 50}, 60, 70, 200));
  const QuerySet embree = make_embree_queries(world);
  const QuerySet reference = make_reference_queries(world);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p = i < 900 ? world.vertex(static_cast<VertexId>(i)) : random.point(-20, 120);
    ASSERT_EQ(embree.distance->containing(p), reference.distance->containing(p)) << p.transpose();
  }
}

TEST(EmbreeQueries, ChangeNoStateOfTheProcess) {
  const auto allowed = [] { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism); };
  const std::size_t before = allowed();
  const auto denormals_live = [] {
    volatile double smallest = std::numeric_limits<double>::min();
    volatile float smallest_float = std::numeric_limits<float>::min();
    return smallest / 2 > 0.0 && smallest_float / 2 > 0.0f;
  };
  ASSERT_TRUE(denormals_live());
  const int rounding = std::fegetround();
  const QuerySet queries =
      make_embree_queries(random_world({.obstacles = 500, .vertices = 10, .fill = 0.2, .seed = 2}));
  EXPECT_EQ(allowed(), before);
  EXPECT_TRUE(denormals_live());
  EXPECT_FALSE(queries.visibility->visible(LineSegment{{0, 0}, {100, 100}}));
  EXPECT_NE(queries.distance->closest({5, 5}).edge, kNone);
  EXPECT_TRUE(denormals_live());
  EXPECT_EQ(std::fegetround(), rounding);
  // The arena's threads, which helped to build the scene, do not flush either.
  TbbExecutor(2).for_ranges(64, 1, [&](std::size_t, std::size_t) { EXPECT_TRUE(denormals_live()); });
}

}  // namespace
}  // namespace arcway::internal
