#include "arcway/datasets/catalog.h"

#include <gtest/gtest.h>

#include <string>

#include "arcway/datasets/clutter.h"
#include "arcway/datasets/random_queries.h"
#include "arcway/vehicle.h"

namespace arcway::internal {
namespace {

std::string message_for(std::string_view name) {
  try {
    catalog_map(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Catalog, NamesAClutter) {
  const MapFile map = catalog_map("clutter/star/n40/m9/f30/s7");
  const Clutter same =
      generate_clutter({.kind = ClutterKind::kStar, .obstacles = 40, .vertices = 9, .fill = 0.3, .seed = 7});
  ASSERT_EQ(map.obstacles.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(map.obstacles[i].outer, same.obstacles[i].outer);
  EXPECT_EQ(map.bounds, same.bounds);
}

TEST(Catalog, PartsMayBeLeftOutAndStandInAnyOrder) {
  EXPECT_EQ(catalog_map("clutter/convex").obstacles[3].outer,
            catalog_map("clutter/convex/n100/m8/f20/s1").obstacles[3].outer);
  EXPECT_EQ(catalog_map("clutter/mixed/s4/n30").obstacles[3].outer,
            catalog_map("clutter/mixed/n30/s4").obstacles[3].outer);
}

TEST(Catalog, ThePaperExampleBringsStartAndGoal) {
  const MapFile map = catalog_map("paper");
  EXPECT_EQ(map.obstacles.size(), 8u);
  ASSERT_TRUE(map.start && map.goal && map.bounds);
  EXPECT_EQ(map.start->x, 30.0);
}

TEST(Catalog, EveryFamilyMakesWorldsWithItsDefaults) {
  for (const CatalogFamily& family : catalog_families()) {
    std::vector<std::string> names;
    for (const std::string_view kind : family.kinds)
      names.push_back(std::string(family.name) + "/" + std::string(kind));
    if (names.empty()) names.emplace_back(family.name);
    for (const std::string& name : names) {
      EXPECT_TRUE(is_catalog_name(name));
      EXPECT_GT(catalog_world(name).vertices().size(), 0u) << name;
    }
  }
}

TEST(Catalog, SaysWhatIsWrongWithAName) {
  EXPECT_FALSE(is_catalog_name("clutters/convex"));
  EXPECT_NE(message_for("clutters/convex")
                .find("unknown family \"clutters\", did you mean \"clutter\"? There are paper, clutter"),
            std::string::npos);
  EXPECT_EQ(message_for("clutter/cube"),
            "catalog world \"clutter/cube\": unknown kind \"cube\"; there are convex, star, mixed, rectangle");
  for (const char* part : {"x5", "n", "n-5", "n5x", "K5", "", "n99999999999999999999"}) {
    EXPECT_NE(message_for(std::string("clutter/convex/") + part).find("unexpected part \"" + std::string(part) + "\""),
              std::string::npos)
        << message_for(std::string("clutter/convex/") + part);
  }
  EXPECT_NE(message_for("clutter/convex/n5/n6").find("second part \"n6\""), std::string::npos);
  EXPECT_EQ(message_for("ponds/n3/t0"), "catalog world \"ponds/n3/t0\": a tolerance of 0 mm, must be at least 1");
  EXPECT_NE(message_for("clutter/convex/f95").find("fill is 0.95"), std::string::npos);
}

TEST(RandomQueries, AreApartAndFreeAndTheSameForTheSameSeed) {
  const std::string name = "clutter/convex/n60/f45/s3";
  const World world = catalog_world(name);
  const QuerySet reference = make_reference_queries(world);
  const Vehicle robot;
  const double side = world.box().max.x() - world.box().min.x();
  const auto queries = catalog_queries(name, 50, 1);
  const auto again = catalog_queries(name, 50, 1);
  ASSERT_EQ(queries.size(), 50u);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Pose& start = queries[i].start;
    const Pose& goal = queries[i].goal;
    EXPECT_GE((goal.position() - start.position()).norm(), 0.3 * side);
    for (const Pose& pose : {start, goal}) {
      EXPECT_TRUE(reference.sweep->straight_free(swept_rectangle(pose, 0.0, robot.footprint(robot.safety_margin()))));
    }
    EXPECT_EQ(start.x, again[i].start.x);
    EXPECT_EQ(goal.heading, again[i].goal.heading);
  }
  EXPECT_NE(catalog_queries(name, 1, 2)[0].start.x, queries[0].start.x);
}

TEST(RandomQueries, AreNotPartedWhereTheyMustBePassable) {
  // A wall with a door that is wide enough, and one without.
  const Ring bounds{{0, 0}, {30, 0}, {30, 10}, {0, 10}};
  const World world(
      {Polygon{{{10, 0}, {11, 0}, {11, 8}, {10, 8}}, {}}, Polygon{{{20, 0}, {21, 0}, {21, 10}, {20, 10}}, {}}}, bounds);
  const QuerySet queries = make_reference_queries(world);
  const auto room = [](const Pose& pose) { return pose.x < 20.0 ? 0 : 1; };
  const auto count_parted = [&](bool passable) {
    int parted = 0;
    for (const PlanRequest& request : random_queries(world, queries, Vehicle(), {.count = 50, .passable = passable}))
      parted += room(request.start) != room(request.goal) ? 1 : 0;
    return parted;
  };
  EXPECT_GT(count_parted(false), 10);
  EXPECT_EQ(count_parted(true), 0);
}

TEST(RandomQueries, GiveUpWhereThereIsNoRoom) {
  const World full({Polygon{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}, Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  EXPECT_THROW(random_queries(full, make_reference_queries(full), Vehicle()), std::runtime_error);
  const World empty({});
  EXPECT_THROW(random_queries(empty, make_reference_queries(empty), Vehicle()), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal
