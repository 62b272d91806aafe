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
                                   {"turning_radius", "min_turning_radius"},
                                   {"lateral_acceleration", "turn_speed"},
                                   {"max_deceleration", "max_acceleration"},
                                   {"inflation_radius", "safety_margin"}})
    EXPECT_NE(
        robot_error(robot(",\"" + std::string(key) + "\":2")).find(", did you mean \"" + std::string(meant) + "\"?"),
        std::string::npos)
        << key;
}

TEST(RobotJson, ErrorsNameKeyAndValue) {
  EXPECT_EQ(
      robot_error(robot(R"(,"lenght":2)")),
      "robot.json: unknown key \"lenght\", did you mean \"length\"? There are format, version, name, length, width, "
      "front_overhang, rear_overhang, footprint, footprint_origin, wheelbase, "
      "steering, max_steering_angle, max_steering_angle_right, min_turning_radius, min_turning_radius_right, "
      "minimum_turning_radius, max_speed, turn_speed, "
      "max_reverse_speed, max_acceleration, safety_margin");
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
  EXPECT_EQ(robot_error("7"), "robot.json: expected an object, found 7");
}

TEST(RobotJson, FormatAndVersionMayBeLeftOut) {
  EXPECT_EQ(read_robot("{}", "r"), VehicleParameters{});
  EXPECT_EQ(read_robot(R"({"width":0.5})", "r").width, 0.5);
  EXPECT_EQ(robot_error(R"({"version":2})"), "robot.json: version: expected 1, found 2");
}

TEST(RobotJson, BodiesRoundTrip) {
  VehicleParameters robot;
  robot.front_overhang = 1.0 / 3.0, robot.rear_overhang = -0.25;
  EXPECT_EQ(read_robot(to_json(robot), "r"), robot);
  robot = {};
  robot.footprint = {{{-0.5, -1.0 / 3.0}, {1, 0}, {-0.5, 0.25}}};
  EXPECT_NE(to_json(robot).find("\"footprint\":[[-0.5,-0.3333333333333333],[1,0],[-0.5,0.25]]"), std::string::npos);
  EXPECT_EQ(read_robot(to_json(robot), "r"), robot);
  robot.footprint.push_back({{2, 0}, {3, 0}, {3, 1}});
  robot.footprint_origin = {0.125, -0.5};
  EXPECT_EQ(read_robot(to_json(robot), "r"), robot);
}

TEST(RobotJson, FootprintsMayBeTexts) {
  const std::vector<Ring> one = {{{-0.5, -0.25}, {1, 0}, {-0.5, 0.25}}};
  EXPECT_EQ(read_robot(R"({"footprint":"[[-0.5, -0.25], [1, 0], [-0.5, 0.25]]"})", "r").footprint, one);
  EXPECT_EQ(read_robot(R"({"footprint":[[[-0.5, -0.25], [1, 0], [-0.5, 0.25]]]})", "r").footprint, one);
}

TEST(RobotJson, ATurningRadiusTakesThePlaceOfTheAngle) {
  for (const char* steering : {"front", "rear", "symmetric"}) {
    const std::string text = R"({"steering":")" + std::string(steering) + R"(","wheelbase":2,"min_turning_radius":3})";
    EXPECT_NEAR(Vehicle(read_robot(text, "r")).min_turning_radius(), 3.0, 1e-15) << steering;
  }
  EXPECT_EQ(read_robot(R"({"minimum_turning_radius":3})", "r"), read_robot(R"({"min_turning_radius":3})", "r"));
  EXPECT_THROW(Vehicle(read_robot(R"({"min_turning_radius":3,"max_steering_angle":0.5})", "r")), std::invalid_argument);
  EXPECT_EQ(robot_error(R"({"min_turning_radius":3,"minimum_turning_radius":3})"),
            "robot.json: \"min_turning_radius\" and \"minimum_turning_radius\" are the same, leave one out");
  EXPECT_EQ(robot_error(R"({"min_turning_radius":0})"),
            "robot.json: min_turning_radius: expected a radius > 0, found 0");
}

TEST(RobotJson, TellsLeftTurnsFromRightOnes) {
  const VehicleParameters angles = read_robot(R"({"max_steering_angle":0.5,"max_steering_angle_right":0.25})", "r");
  EXPECT_LT(Vehicle(angles).min_turning_radius(Side::kLeft), Vehicle(angles).min_turning_radius(Side::kRight));
  const VehicleParameters radii = read_robot(R"({"min_turning_radius":2,"min_turning_radius_right":5})", "r");
  EXPECT_EQ(Vehicle(radii).min_turning_radius(Side::kLeft), 2.0);
  EXPECT_EQ(Vehicle(radii).min_turning_radius(Side::kRight), 5.0);
  for (const VehicleParameters& robot : {angles, radii}) EXPECT_EQ(read_robot(to_json(robot), "r"), robot);
  EXPECT_EQ(to_json(radii).find("max_steering_angle"), std::string::npos);
  EXPECT_EQ(robot_error(R"({"min_turning_radius":2,"min_turning_radius_right":-1})"),
            "robot.json: min_turning_radius_right: expected a radius > 0, found -1");
}

TEST(RobotYaml, HasTheSameKeys) {
  const VehicleParameters robot = read_robot(
      "# a robot\nwidth: 0.5\nsteering: rear\nfront_overhang: .25\nrear_overhang: 1e-1\nturn_speed:\n  table: [[1, 2], "
      "[3, 4]]\n",
      "r.yaml");
  EXPECT_EQ(robot, read_robot(R"({"width":0.5,"steering":"rear","front_overhang":0.25,"rear_overhang":0.1,
                                  "turn_speed":{"table":[[1,2],[3,4]]}})",
                              "r"));
  EXPECT_EQ(test::format_error_of([] { read_robot("width: 0.5\nwidht: 1\n", "r.yml"); }).substr(0, 55),
            "r.yml: unknown key \"widht\", did you mean \"width\"? There");
  EXPECT_EQ(test::format_error_of([] { read_robot("width: 0.5\nlength: 1\nwidth: 1\n", "r.yml"); }),
            "r.yml: line 3: the key \"width\" comes twice");
  EXPECT_EQ(test::format_error_of([] { read_robot("width: \"0.5\"\n", "r.yml"); }),
            "r.yml: width: expected a number, found \"0.5\"");
  EXPECT_EQ(test::format_error_of([] { read_robot("width: [1\n", "r.yml"); }).substr(0, 13), "r.yml: line 2");
}

// As nav2's own parameters: costmaps and the planner among others.
TEST(RobotYaml, MayBeParametersOfNav2) {
  const std::string costmaps = R"(local_costmap:
  local_costmap:
    ros__parameters:
      width: 3
      resolution: 0.05
      footprint: "[ [0.3, 0.2], [0.3, -0.2], [-0.25, -0.2], [-0.25, 0.2] ]"
global_costmap:
  global_costmap:
    ros__parameters:
      footprint: "[ [0.3, 0.2], [0.3, -0.2], [-0.25, -0.2], [-0.25, 0.2] ]"
)";
  const std::string planner = R"(planner_server:
  ros__parameters:
    expected_planner_frequency: 20.0
    GridBased:
      plugin: "nav2_smac_planner/SmacPlannerHybrid"
      minimum_turning_radius: 0.40
)";
  const Vehicle robot(read_robot(costmaps + planner, "nav2.yaml"));
  EXPECT_EQ(robot.footprint().front, 0.3);
  EXPECT_EQ(robot.footprint().rear, 0.25);
  EXPECT_EQ(robot.footprint().left, 0.2);
  EXPECT_EQ(robot.shape(), nullptr);
  EXPECT_NEAR(robot.min_turning_radius(), 0.4, 1e-15);
  const std::string other = costmaps + R"(behavior_server:
  ros__parameters:
    footprint: "[[1, 0], [0, 1], [0, 0]]"
)";
  EXPECT_EQ(test::format_error_of([&] { read_robot(other, "n.yaml"); }).substr(0, 32),
            "n.yaml: line 13: footprint is \"[");
  EXPECT_EQ(test::format_error_of([] { read_robot("a:\n  ros__parameters:\n    b: 1\n", "n.yaml"); }),
            "n.yaml: no \"footprint\" or \"minimum_turning_radius\" below \"ros__parameters\"");
}

TEST(RobotYaml, OfManyAliasesEnds) {
  std::string text = "a: &a0 [1, 1]\n";
  for (int i = 0; i < 25; ++i)
    text += "b" + std::to_string(i) + ": &a" + std::to_string(i + 1) + " [*a" + std::to_string(i) + ", *a" +
            std::to_string(i) + "]\n";
  EXPECT_NE(test::format_error_of([&] { read_robot(text, "r.yaml"); }).find("more than 100000 values"),
            std::string::npos);
}

TEST(RobotJson, ErrorsOfBodiesNameTheVertex) {
  EXPECT_EQ(robot_error(R"({"footprint":[[0,0],[1,null],[1,1]]})"),
            "robot.json: footprint[1][1]: expected a number, found null");
  EXPECT_EQ(robot_error(R"({"footprint":[[0,0],[1,0,2],[1,1]]})"),
            "robot.json: footprint[1]: expected a point [x, y], found [1,0,2]");
  EXPECT_EQ(robot_error(R"({"footprint":[[[0,0],[1,0],[0,1]],[[0,0],[1,"a"]]]})"),
            "robot.json: footprint[1][1][1]: expected a number, found \"a\"");
  EXPECT_EQ(robot_error(R"({"footprint":7})"), "robot.json: footprint: expected an array, found 7");
  EXPECT_NE(robot_error(R"({"footprint":"[[0, 0], [1"})").find("robot.json: footprint: line 1: "), std::string::npos);
  EXPECT_EQ(robot_error(R"({"footprint":[[0,0],[1,0],[0,1]],"width":1})"),
            "robot.json: \"footprint\" takes the place of \"width\", leave one out");
  EXPECT_EQ(robot_error(R"({"front_overhang":1,"rear_overhang":1,"length":1})"),
            "robot.json: \"front_overhang\" takes the place of \"length\", leave one out");
  EXPECT_EQ(robot_error(R"({"footprint_origin":[0,0]})"),
            "robot.json: \"footprint_origin\" needs a \"footprint\" beside it");
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

TEST(Robot, HasAName) {
  EXPECT_EQ(read_robot(R"({"name":"van"})", "r").name, "van");
  EXPECT_EQ(read_robot("{}", "r").name, "");
  VehicleParameters robot;
  robot.name = "a \"b\"";
  EXPECT_EQ(read_robot(to_json(robot), "r"), robot);
  EXPECT_EQ(to_json(VehicleParameters{}).find("name"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal
