#include "arcway/datasets/prepared_map.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/clutter.h"
#include "arcway/datasets/map_file.h"
#include "arcway/planner.h"
#include "tests/support/nasty_worlds.h"
#include "tests/support/prepared_bytes.h"

namespace arcway::internal {
namespace {

PreparedMap prepare(const World& world, const Executor& executor) {
  return prepared_map_of(Planner(world, Vehicle{}, backend_of(world, make_reference_queries(world), executor)),
                         Pose{1, 2, 3});
}

World small_world();

TEST(PreparedMap, IsNoneOfWhatIsNotAllThere) {
  const World world = small_world();
  const QuerySet queries = make_reference_queries(world);
  const Planner lazy(world, Vehicle{}, backend_of(world, queries), {.graph_mode = GraphMode::kLazy});
  EXPECT_THROW((void)prepared_map_of(lazy), std::logic_error);
  const Planner eager(world, Vehicle{}, backend_of(world, queries));
  const Planner from_rows(world, Vehicle{}, backend_of(world, queries, eager.visibility_rows()));
  EXPECT_THROW((void)prepared_map_of(from_rows), std::logic_error);
}

World small_world() {
  return World({{test::square(0, 0, 4), {test::reversed(test::square(1, 1, 1))}}, {test::square(9, 9, 2), {}}},
               test::square(-5, -5, 30));
}

std::string complaint_about(const std::string& bytes) {
  try {
    static_cast<void>(read_prepared_map(bytes, "m.arcway"));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "";
}

TEST(PreparedMap, ReadsBackToTheSameBytes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const World world = test::nasty_world(seed, 8);
    PreparedMap map{world, build_reduced_visibility_graph(world, *make_reference_queries(world).visibility), {}, {}, {},
                    {}};
    const std::string bytes = to_bytes(map);
    EXPECT_EQ(to_bytes(read_prepared_map(bytes, "m")), bytes) << seed;
  }
  const std::string bytes = to_bytes(prepare(small_world(), SerialExecutor()));
  const PreparedMap map = read_prepared_map(bytes, "m");
  EXPECT_EQ(to_bytes(map), bytes);
  EXPECT_EQ(map.start->heading, 3.0);
  EXPECT_FALSE(map.goal);
  ASSERT_TRUE(map.robot);
  EXPECT_EQ(map.robot->parameters.max_speed, Vehicle{}.max_speed());
}

TEST(PreparedMap, HasTheSameBytesForAnyNumberOfThreadsAndEveryTime) {
  const World world =
      random_world({.kind = ClutterKind::kStar, .obstacles = 15, .vertices = 6, .fill = 0.2, .seed = 8});
  const std::string expected = to_bytes(prepare(world, SerialExecutor()));
  for (const std::size_t threads : {1u, 2u, 3u, 8u})
    EXPECT_EQ(to_bytes(prepare(world, ThreadExecutor(threads))), expected) << threads;
}

TEST(PreparedMap, PlansAsAMapThatIsPreparedAnew) {
  const World world = random_world({.obstacles = 15, .vertices = 6, .fill = 0.2, .seed = 8});
  PreparedMap map = read_prepared_map(to_bytes(prepare(world, SerialExecutor())), "m");
  const Planner built(world, Vehicle{});
  const Planner taken =
      Planner::restored(map.world, Vehicle(map.robot->parameters), reference_backend(map.world),
                        {std::move(map.reduced_graph), map.robot->radii, std::move(map.robot->feasible)});
  const PlanRequest request{{0.5, 0.5, 0}, {40, 40, 1}};
  const PlanResult a = built.plan(request), b = taken.plan(request);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.travel_time, b.travel_time);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
}

TEST(PreparedMap, IsRefusedWhenCutOffAnywhere) {
  const std::string bytes = to_bytes(prepare(small_world(), SerialExecutor()));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(complaint_about(bytes.substr(0, size)).rfind("m.arcway: byte ", 0), 0u) << size;
}

TEST(PreparedMap, IsRefusedWhenAnyByteIsAnother) {
  const std::string bytes = to_bytes(prepare(small_world(), SerialExecutor()));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    EXPECT_EQ(complaint_about(changed).rfind("m.arcway: byte ", 0), 0u) << at;
  }
  EXPECT_NE(complaint_about(bytes + '\0'), "");
}

TEST(PreparedMap, SaysWhatIsWrongAndWhere) {
  const std::string bytes = to_bytes(prepare(small_world(), SerialExecutor()));
  EXPECT_EQ(complaint_about("{\"type\": 1}"), "m.arcway: byte 0: this is no prepared map");
  EXPECT_EQ(complaint_about(bytes.substr(0, 20)), "m.arcway: byte 20: the file ends in its header of 40 bytes");

  std::string other = bytes;
  other[12] = 9;
  EXPECT_EQ(complaint_about(other),
            "m.arcway: byte 12: version 9, this program reads version 2; prepare the map again");
  other = bytes;
  std::swap(other[8], other[11]);
  std::swap(other[9], other[10]);
  EXPECT_EQ(complaint_about(other), "m.arcway: byte 8: written by a machine of another byte order: 0x04030201");

  other = bytes.substr(0, bytes.size() - 1);
  EXPECT_NE(complaint_about(other).find(": the file has " + std::to_string(other.size()) + " bytes, its header says " +
                                        std::to_string(bytes.size())),
            std::string::npos);

  // A file that somebody made with care: the checksums are right, the content is not.
  other = bytes;
  const test::PreparedSection targets = test::section_of(other, static_cast<std::uint32_t>(SnapshotArray::kTargets));
  const std::uint32_t nowhere = 4711;
  std::memcpy(other.data() + targets.offset + 8, &nowhere, sizeof nowhere);
  test::mend_checksums(other);
  EXPECT_EQ(
      complaint_about(other).rfind("m.arcway: byte " + std::to_string(targets.offset + 8) + ": targets, entry 2", 0),
      0u)
      << complaint_about(other);
  EXPECT_NE(complaint_about(other).find("4711"), std::string::npos);
}

TEST(PreparedMap, IsRefusedWhenItsLayoutIsAnother) {
  const std::string bytes = to_bytes(prepare(small_world(), SerialExecutor()));
  const auto complaint_after = [&](const auto& change) {
    std::string other = bytes;
    change(other);
    test::mend_checksums(other);
    return complaint_about(other);
  };
  const auto put = [](std::string& text, std::size_t place, std::uint32_t value) {
    std::memcpy(&text[place], &value, sizeof value);
  };
  const std::size_t first = 40, last = 40 + 32 * (test::number_at<std::uint32_t>(bytes, 20) - 1);  // entries
  EXPECT_EQ(complaint_after([](std::string& b) { b[16] = 3; }), "m.arcway: byte 16: unknown flags 0x00000003");
  EXPECT_EQ(complaint_after([](std::string& b) { b += std::string(64, '\0'); }),
            "m.arcway: byte " + std::to_string(bytes.size()) + ": bytes after the last section");
  EXPECT_EQ(complaint_after([&](std::string& b) { put(b, last + 28, 1); }),
            "m.arcway: byte " + std::to_string(last + 28) + ": section 13 has 0x00000001 where 0 is expected");
  const auto count = test::number_at<std::uint64_t>(bytes, first + 16);
  EXPECT_EQ(complaint_after([&](std::string& b) {
              put(b, first + 16, static_cast<std::uint32_t>(2 * count));
              put(b, first + 24, 8);
            }),
            "m.arcway: byte 64: section 1 has elements of 8 bytes, expected 16");
  EXPECT_EQ(complaint_after([&](std::string& b) { put(b, last, 1); }),
            "m.arcway: byte " + std::to_string(last) + ": section 1 comes twice");
  EXPECT_EQ(complaint_after([&](std::string& b) { put(b, last, 999); }), "m.arcway: byte 40: section 13 is missing");
  EXPECT_EQ(complaint_after([&](std::string& b) { put(b, 40 + 32 * 7, 999); }),
            "m.arcway: byte 264: unknown section 999");  // in place of the start
}

// A map has exactly one file: optional sections are absent if they are empty.
TEST(PreparedMap, IsRefusedWithAnEmptySectionOfContacts) {
  std::string bytes = to_bytes(prepare(World({}), SerialExecutor()));
  const std::size_t targets = 40 + 32 * 6;  // entry of the targets, of which there are none
  ASSERT_EQ(test::number_at<std::uint32_t>(bytes, targets), static_cast<std::uint32_t>(SnapshotArray::kTargets));
  bytes[targets] = static_cast<char>(SnapshotArray::kSelfContacts);
  test::mend_checksums(bytes);
  EXPECT_EQ(complaint_about(bytes),
            "m.arcway: byte " + std::to_string(targets + 16) + ": section 14 is empty, not left out");
}

TEST(PreparedMap, IsWrittenWholeOrNotAtAll) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "arcway_prepared_map";
  std::filesystem::create_directories(folder);
  const PreparedMap map = prepare(small_world(), SerialExecutor());
  write_prepared_map(folder / "m.arcway", map);
  EXPECT_TRUE(is_prepared_map_file(folder / "m.arcway"));
  EXPECT_EQ(to_bytes(read_prepared_map_file(folder / "m.arcway")), to_bytes(map));
  EXPECT_THROW(write_prepared_map(folder / "none" / "m.arcway", map), FileError);
  EXPECT_THROW(static_cast<void>(read_prepared_map_file(folder / "other.arcway")), FileError);
  EXPECT_FALSE(is_prepared_map_file(folder / "other.arcway"));
  std::filesystem::remove_all(folder);
}

TEST(PreparedMap, KeepsZones) {
  const World world =
      small_world().with_zones({{{test::square(-4, 10, 2), {}}, KeepOut{}, "dock"},
                                {{test::square(-4, 16, 2), {}}, KeepOut{{"van"}}, ""},
                                {{test::square(14, 14, 3), {test::square(15, 15, 1)}}, SpeedLimit{0.1}, ""},
                                {{test::square(-8, -8, 3), {}}, OneWay{0.1, 0.2}, "lane"},
                                {{test::square(-9, 20, 3), {}}, KeepClear{0.5, 0.1}, "hall"}});
  const SerialExecutor executor;
  const PreparedMap map = prepare(world.for_vehicle(Vehicle{}), executor);
  const std::string bytes = to_bytes(map);
  PreparedMap back = read_prepared_map(bytes, "m");
  EXPECT_EQ(to_bytes(back), bytes);
  ASSERT_EQ(back.world.zones().size(), 5u);
  EXPECT_EQ(back.world.zones()[4].rule, ZoneRule(KeepClear{0.5, 0.1}));
  EXPECT_EQ(back.world.zones()[3].rule, ZoneRule(OneWay{0.1, 0.2}));
  EXPECT_EQ(back.world.zones()[2].rule, ZoneRule(SpeedLimit{0.1}));
  EXPECT_EQ(back.world.zones()[2].area.holes.size(), 1u);
  EXPECT_EQ(back.world.keep_out_of(2), 0u);
  const Planner planner =
      Planner::restored(back.world, Vehicle{}, reference_backend(back.world),
                        {std::move(back.reduced_graph), back.robot->radii, std::move(back.robot->feasible)});
  EXPECT_EQ(planner.world().obstacle_count(), 3u);
  EXPECT_NE(to_bytes(prepare(small_world().with_zones({world.zones()[0]}).for_vehicle(Vehicle{}), executor)), bytes);
}

}  // namespace
}  // namespace arcway::internal
