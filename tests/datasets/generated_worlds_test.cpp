// What holds for all families of the catalog alike.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "arcway/datasets/adversarial_world.h"
#include "arcway/datasets/catalog.h"
#include "arcway/datasets/structured_world.h"
#include "arcway/query_set.h"
#include "arcway/vehicle.h"

namespace arcway::internal {
namespace {

std::vector<std::string> families_by_vertices() {
  std::vector<std::string> names;
  for (const StructuredKind kind : kStructuredKinds) names.emplace_back(name_of(kind));
  for (const AdversarialKind kind : kAdversarialKinds) names.push_back(std::string("adversarial/") + name_of(kind));
  return names;
}

std::uint64_t hash_of(const MapFile& map) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  const auto add = [&](const Ring& ring) {
    for (const Vec2& p : ring)
      for (const double value : {p.x(), p.y()}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001B3u;
        hash ^= hash >> 32;  // whole numbers differ in their high bits only
      }
  };
  for (const Polygon& polygon : map.obstacles) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  if (map.bounds) add(*map.bounds);
  return hash;
}

class GeneratedWorlds : public ::testing::TestWithParam<std::string> {};

TEST_P(GeneratedWorlds, HaveAboutTheVerticesAskedFor) {
  for (const std::size_t wanted : {1000u, 3456u, 20000u}) {
    for (const int seed : {1, 2, 3}) {
      const std::string name = GetParam() + "/v" + std::to_string(wanted) + "/s" + std::to_string(seed);
      const World world = catalog_world(name);  // which refuses what is not valid
      EXPECT_NEAR(static_cast<double>(world.vertices().size()) / static_cast<double>(wanted), 1.0, 0.05) << name;
      EXPECT_TRUE(world.has_bounds()) << name;
    }
  }
}

TEST_P(GeneratedWorlds, AreValidWhenSmall) {
  for (int vertices = 100; vertices < 400; vertices += 37) {
    const std::string name = GetParam() + "/v" + std::to_string(vertices);
    EXPECT_GT(catalog_world(name).convex_vertices().size(), 10u) << name;
  }
}

// A million if ARCWAY_LONG_TESTS is set.
TEST_P(GeneratedWorlds, ManyVertices) {
  const std::size_t wanted = std::getenv("ARCWAY_LONG_TESTS") != nullptr ? 1'000'000 : 200'000;
  const World world = catalog_world(GetParam() + "/v" + std::to_string(wanted));
  EXPECT_NEAR(static_cast<double>(world.vertices().size()) / static_cast<double>(wanted), 1.0, 0.05);
}

TEST_P(GeneratedWorlds, DependOnTheSeed) {
  EXPECT_NE(hash_of(catalog_map(GetParam() + "/v500/s1")), hash_of(catalog_map(GetParam() + "/v500/s2")));
}

INSTANTIATE_TEST_SUITE_P(All, GeneratedWorlds, ::testing::ValuesIn(families_by_vertices()),
                         [](const auto& test) { return std::to_string(test.index); });

TEST(GeneratedWorldsTogether, AreTheSameBitsEverywhere) {
  // From GCC 12 and Clang 14, x86-64.
  const std::map<std::string, std::uint64_t> expected = {
      {"warehouse/v2000/s7", 0xA42B1BCDECFAB363u},
      {"parking/v2000/s7", 0x4E5710DBBCD7D5FCu},
      {"rooms/v2000/s7", 0x7379C5E8D76B836Eu},
      {"maze/v2000/s7", 0xFB86A26A613534Bu},
      {"city/v2000/s7", 0xE52E4C778B726878u},
      {"islands/v2000/s7", 0x4B739E7F764BC0A1u},
      {"corridor/v2000/s7", 0x6F69CFC20A79337Cu},
      {"coastline/v2000/s7", 0x5AF53750AA364D1Du},
      {"adversarial/touching/v2000/s7", 0xF59B1D4D2DD0096Cu},
      {"adversarial/shared/v2000/s7", 0x6ACB14BF0A2A959Au},
      {"adversarial/collinear/v2000/s7", 0x95C0AE550F72A7E6u},
      {"adversarial/needles/v2000/s7", 0xECE12BBB3D29764Cu},
      {"adversarial/far/v2000/s7", 0xDE7276EBB728CAE0u},
      {"adversarial/nested/v2000/s7", 0x11E52495B611DB72u},
      {"adversarial/overlapping/v2000/s7", 0xA542594FDC5FF463u},
      {"adversarial/contacts/v2000/s7", 0xDB547E63F76EF845u},
      {"adversarial/holes/v2000/s7", 0x8E09EFF56362BFBAu},
      {"adversarial/saw/v2000/s7", 0xF6B371EF814BBE35u},
      {"adversarial/comb/v2000/s7", 0x2F9BF3DE89102A28u},
      {"adversarial/spikes/v2000/s7", 0xE01D755B5C1FB782u},
      {"adversarial/rings/v2000/s7", 0x6504288106213CDEu},
      {"clutter/convex/n200/m9/f20/s7", 0x5D64D4EC8BB9271Fu},
      {"clutter/convex/n200/m9/f50/s7", 0x3CD594F4770E97BEu},
      {"clutter/star/n200/m9/f20/s7", 0xD50555BDF94E4AC0u},
      {"clutter/star/n200/m9/f50/s7", 0x93076E61FF0C6E5u},
      {"clutter/mixed/n200/m9/f20/s7", 0x42F9FC358ECD3996u},
      {"clutter/mixed/n200/m9/f50/s7", 0x194A2020B632EC4Eu},
      {"clutter/rectangle/n200/m9/f20/s7", 0x60E92872AD05DB5Fu},
      {"clutter/rectangle/n200/m9/f50/s7", 0x5B2DFEFCBC940A03u},
      {"ponds/n20/t10/s7", 0x523525D56335C120u},
  };
  std::vector<std::string> names = families_by_vertices();
  for (std::string& name : names) name += "/v2000/s7";
  for (const char* kind : {"convex", "star", "mixed", "rectangle"})
    for (const char* fill : {"20", "50"}) names.push_back(std::string("clutter/") + kind + "/n200/m9/f" + fill + "/s7");
  names.push_back("ponds/n20/t10/s7");
  for (const std::string& name : names) {
    const std::uint64_t hash = hash_of(catalog_map(name));
    const auto found = expected.find(name);
    EXPECT_TRUE(found != expected.end() && found->second == hash)
        << "{\"" << name << "\", 0x" << std::hex << std::uppercase << hash << "u},";
  }
}

TEST(GeneratedWorldsTogether, RefuseNumbersOutOfRange) {
  try {
    catalog_map("maze/v50");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "maze: vertices is 50, must be from 100 to 10000000");
  }
  EXPECT_THROW(catalog_map("adversarial/far/v20000000"), std::invalid_argument);
}

// A disc is moved over a grid: where it can go, so can a body about its size.
TEST(StructuredWorlds, JoinStartAndGoalByAWideWay) {
  constexpr double kRadius = 0.9, kStep = 0.4;
  const Vehicle robot;
  for (const StructuredKind kind : kStructuredKinds) {
    for (const char* seed : {"/s1", "/s2"}) {
      const std::string name = std::string(name_of(kind)) + "/v400" + seed;
      const MapFile map = catalog_map(name);
      const World world = to_world(map, name);
      const QuerySet queries = make_reference_queries(world);
      ASSERT_TRUE(map.start && map.goal) << name;
      for (const Pose& pose : {*map.start, *map.goal})
        EXPECT_TRUE(queries.sweep->straight_free(swept_rectangle(pose, 0.0, robot.footprint(0.1)))) << name;

      const Vec2 origin = map.start->position(), extent = world.box().max - world.box().min;
      const int reach_x = static_cast<int>(extent.x() / kStep), reach_y = static_cast<int>(extent.y() / kStep);
      const int width = 2 * reach_x + 1;
      std::vector<bool> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(2 * reach_y + 1), false);
      const auto index = [&](int i, int j) { return static_cast<std::size_t>((j + reach_y) * width + i + reach_x); };
      std::vector<std::pair<int, int>> open{{0, 0}};
      seen[index(0, 0)] = true;
      bool reached = false;
      while (!open.empty() && !reached) {
        const auto [i, j] = open.back();
        open.pop_back();
        const Vec2 p = origin + kStep * Vec2(i, j);
        std::uint8_t blocked = 0;
        queries.distance->closer_than(std::span(&p, 1), std::span(&kRadius, 1), std::span(&blocked, 1));
        if (blocked != 0 || queries.distance->containing(p) != kNone) continue;
        reached = (p - map.goal->position()).norm() < kStep;
        for (const auto& [k, l] : {std::pair{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}}) {
          if (std::abs(k) > reach_x || std::abs(l) > reach_y || seen[index(k, l)]) continue;
          seen[index(k, l)] = true;
          open.emplace_back(k, l);
        }
      }
      EXPECT_TRUE(reached) << name;
    }
  }
}

}  // namespace
}  // namespace arcway::internal
