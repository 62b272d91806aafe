#include "arcway/datasets/robot.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

std::string robot(const std::string& members = "") { return R"({"format":"arcway-robot","version":1)" + members + "}"; }

std::string robot_error(const std::string& text) {
  return test::format_error_of([&] { read_robot(text, "robot.json"); });
}
std::string scenario_error(const std::string& text) {
  return test::format_error_of([&] { read_scenario(text, "s.json"); });
}

TEST(RobotJson, IsRefusedBehindAZeroByte) {
  const std::string robot = to_json(VehicleParameters{});
  EXPECT_NO_THROW(static_cast<void>(read_robot(robot + "\n", "r.json")));
  for (const std::string& text : {robot + "\n" + std::string(3, '\0'), robot + "\n" + std::string(1, '\0') + robot}) {
    try {
      static_cast<void>(read_robot(text, "r.json"));
      ADD_FAILURE() << "taken";
    } catch (const FormatError& error) {
      EXPECT_STREQ(error.what(), "r.json: line 2: a byte 0, which JSON does not have");
    }
  }
}

TEST(RobotJson, MissingKeysTakeDefaults) { EXPECT_EQ(to_json(read_robot(robot(), "r")), to_json(VehicleParameters{})); }

TEST(RobotJson, RoundTripIsExact) {
  VehicleParameters parameters{.length = 4.2,
                               .width = 1.0 / 3.0,
                               .wheelbase = 2.7,
                               .steering = Steering::kSymmetric,
                               .max_steering_angle = 0.6,
                               .max_speed = 0.1,
                               .turn_speed = TurnSpeedTable{{{1.0, 2.0}, {3.5, 4.0}}},
                               .max_acceleration = 2.0,
                               .safety_margin = 1e-4};
  const VehicleParameters back = read_robot(to_json(parameters), "r");
  EXPECT_EQ(back.width, 1.0 / 3.0);
  EXPECT_EQ(back.steering, Steering::kSymmetric);
  EXPECT_EQ(std::get<TurnSpeedTable>(back.turn_speed).entries, std::get<TurnSpeedTable>(parameters.turn_speed).entries);
  EXPECT_EQ(to_json(back), to_json(parameters));
  EXPECT_EQ(back.max_reverse_speed, std::nullopt);
  parameters.max_reverse_speed = 1.0 / 3.0;
  EXPECT_EQ(read_robot(to_json(parameters), "r").max_reverse_speed, 1.0 / 3.0);
  parameters.turn_speed = LateralAccelerationLimit{2.5};
  EXPECT_EQ(to_json(read_robot(to_json(parameters), "r")), to_json(parameters));
}

TEST(RobotJson, KeysOfOthersAreUnderstood) {
  for (const auto& [key, meant] : {std::pair{"max_velocity", "max_speed"},
                                   {"steeringAngle", "max_steering_angle"},
                                   {"min_turning_radius", "max_steering_angle"},
                                   {"lateral_acceleration", "turn_speed"},
                                   {"max_deceleration", "max_acceleration"},
                                   {"inflation_radius", "safety_margin"}})
    EXPECT_NE(
        robot_error(robot(",\"" + std::string(key) + "\":2")).find(", did you mean \"" + std::string(meant) + "\"?"),
        std::string::npos)
        << key;
}

TEST(RobotJson, ErrorsNameKeyAndValue) {
  EXPECT_EQ(robot_error(robot(R"(,"lenght":2)")),
            "robot.json: unknown key \"lenght\", did you mean \"length\"? There are format, version, length, width, "
            "wheelbase, "
            "steering, max_steering_angle, max_speed, turn_speed, max_reverse_speed, max_acceleration, safety_margin");
  EXPECT_EQ(robot_error(robot(R"(,"length":"2")")), "robot.json: length: expected a number, found \"2\"");
  EXPECT_EQ(robot_error(robot(R"(,"steering":"back")")),
            "robot.json: steering: expected \"front\", \"rear\" or \"symmetric\", found \"back\"");
  EXPECT_EQ(robot_error(robot(R"(,"turn_speed":{"table":[[1,2],[null,3]]})")),
            "robot.json: turn_speed.table[1][0]: expected a number, found null");
  EXPECT_EQ(robot_error(R"({"format":"other","version":1})"),
            "robot.json: format: expected \"arcway-robot\", found \"other\"");
  EXPECT_EQ(robot_error(R"({"format":"arcway-robot","version":2})"), "robot.json: version: expected 1, found 2");
  EXPECT_EQ(robot_error("{\"length\":1,\n\"width\":2,\n\"length\":3}"),
            "robot.json: line 3: the key \"length\" comes twice");
  EXPECT_EQ(robot_error("{}"), "robot.json: missing key \"format\"");
  EXPECT_EQ(robot_error("7"), "robot.json: expected an object, found 7");
}

TEST(ScenarioJson, RoundTrip) {
  const Scenario scenario{
      "maps/a \"b\".geojson", std::string("robot.json"), {{"t0", {1, 2, 0.1}, {3, 4, -0.2}}, {"x", {}, {}}}};
  const Scenario back = read_scenario(to_json(scenario), "s.json");
  EXPECT_EQ(back.world, scenario.world);
  EXPECT_EQ(std::get<std::string>(back.robot), "robot.json");
  ASSERT_EQ(back.tasks.size(), 2u);
  EXPECT_EQ(back.tasks[0].goal.heading, -0.2);
  const Scenario inlined{"w", VehicleParameters{.length = 2.5}, {}};
  EXPECT_EQ(to_json(read_scenario(to_json(inlined), "s.json")), to_json(inlined));
}

TEST(ScenarioJson, ErrorsNamePlace) {
  const auto with = [](const std::string& tasks) {
    return R"({"format":"arcway-scenario","version":1,"world":"w","tasks":[)" + tasks + "]}";
  };
  EXPECT_EQ(scenario_error(with(R"({"start":[0,0,0],"goal":[0,null,0]})")),
            "s.json: tasks[0].goal[1]: expected a number, found null");
  EXPECT_EQ(scenario_error(with(R"({"start":[0,0]})")),
            "s.json: tasks[0].start: expected a pose [x, y, heading], found [0,0]");
  const std::string task = R"({"id":"a","start":[0,0,0],"goal":[0,0,0]})";
  EXPECT_EQ(scenario_error(with(task + "," + task)), "s.json: tasks[1]: second task with the id \"a\"");
}

TEST(ScenarioJson, FilesAreFoundBesideTheScenario) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "arcway_scenario";
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / "r.json", to_json(VehicleParameters{.length = 3.25}));
  write_file_atomically(folder / "s.json", to_json(Scenario{"w.geojson", std::string("r.json"), {}}));
  const Scenario scenario = read_scenario_file(folder / "s.json");
  EXPECT_EQ(scenario.world, (folder / "w.geojson").string());
  EXPECT_EQ(std::get<VehicleParameters>(scenario.robot).length, 3.25);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace arcway::internal
