#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "arcway/datasets/moving_io.h"
#include "arcway/datasets/robot.h"
#include "tests/support/json_schema.h"
#include "tests/support/tool.h"

namespace arcway::internal {
namespace {

using test::broken_rule;
using test::Tool;

nlohmann::json schema(const std::string& name) {
  return nlohmann::json::parse(
      test::text_of(std::string(ARCWAY_SOURCE_DIR "/datasets/schemas/") + name + ".schema.json"));
}

// Every line of a file, or the whole of it.
void expect_valid(const std::string& name, const std::string& text) {
  ASSERT_FALSE(text.empty()) << name;
  const nlohmann::json rules = schema(name);
  std::istringstream lines(text);
  if (name == "plan") {
    for (std::string line; std::getline(lines, line);)
      EXPECT_EQ(broken_rule(rules, nlohmann::json::parse(line)), "") << name;
  } else {
    EXPECT_EQ(broken_rule(rules, nlohmann::json::parse(text)), "") << name;
  }
}

TEST(JsonSchema, NamesTheRuleThatIsBroken) {
  const nlohmann::json robot = schema("robot");
  nlohmann::json value = {{"format", "arcway-robot"}, {"version", 1}, {"length", 1.5}};
  EXPECT_EQ(broken_rule(robot, value), "");
  value["wheels"] = 4;
  EXPECT_EQ(broken_rule(robot, value), "$: has \"wheels\"");
  value.erase("wheels");
  value["turn_speed"] = {{"table", {{1, 2, 3}}}};
  EXPECT_NE(broken_rule(robot, value).find("$.turn_speed: oneOf"), std::string::npos);
  value["turn_speed"] = {{"table", {{1, 2}}}};
  EXPECT_EQ(broken_rule(robot, value), "");
  value["steering"] = "both";
  EXPECT_EQ(broken_rule(robot, value), "$.steering: enum: \"both\"");
  value.erase("steering");
  value["footprint"] = {{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(broken_rule(robot, value), "");
  value["footprint"] = {{0, 0}, {1, 0, 2}, {0, 1}};
  EXPECT_NE(broken_rule(robot, value).find("$.footprint: oneOf"), std::string::npos);
  EXPECT_EQ(broken_rule(schema("scenario"), {{"version", 1}}), "$: lacks \"format\"");
}

TEST(JsonSchema, OfMovingObstaclesTakesWhatIsRead) {
  const std::string text =
      R"({"format":"arcway-moving","version":1,"obstacles":[{"outline":[[0,0],[1,0],[1,1]],"velocity":[0,1],"until":3}]})";
  EXPECT_EQ(parse_moving_obstacles(text, "text").size(), 1u);
  nlohmann::json value = nlohmann::json::parse(text);
  EXPECT_EQ(broken_rule(schema("moving"), value), "");
  value["obstacles"][0]["velocity"] = {1, 2, 3};
  EXPECT_EQ(broken_rule(schema("moving"), value), "$.obstacles[0].velocity: maxItems: [1,2,3]");
}

TEST_F(Tool, PlansAreAsTheirSchemaSays) {
  const std::string plan = "plan " + map_ + " --json " + file("p.json") + " --ros-path " + file("r.json");
  for (const char* how :
       {" --start 10,10,0 --goal 50,50,90deg", " --start 10,10,0 --goal 30,30,0",
        " --start 10,10,0 --goal 10,14,180deg --reverse", " --start 10,10,0 --goal 10,10,0",
        " --start 10,10,0 --waypoint 50,10 --goal 50,50 --goal 10,50,0",
        " --start 10,10,0 --goal 50,50,0 --alternatives 2",
        " --start 10,10,0 --goal 50,50,0 --graph eager --backend reference",
        " --start 10,10,0 --goal 50,50,0 --prefer-clearance 3", " --start 10,10,0 --goal 50,50,0 --time-limit 0"}) {
    static_cast<void>(run(plan + how));
    expect_valid("plan", read("p.json"));
    expect_valid("nav_msgs_path", read("r.json"));
  }
  put("zone.geojson",
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"role":"boundary"},"geometry":)"
      R"({"type":"Polygon","coordinates":[[[0,0],[60,0],[60,4],[0,4],[0,0]]]}},{"type":"Feature","properties":)"
      R"({"role":"clearance","distance":3,"cost":1.5,"name":"lane"},"geometry":)"
      R"({"type":"Polygon","coordinates":[[[20,0],[30,0],[30,4],[20,4],[20,0]]]}}]})");
  const Run zone = run("plan " + file("zone.geojson") + " --start 5,2,0 --goal 50,2,0 --json " + file("z.json"));
  EXPECT_NE(zone.out.find("clearance zone \"lane\""), std::string::npos) << zone.out;
  EXPECT_NE(zone.out.find("10.000 m of it closer than 3 m to an obstacle, which costs 15.000 s"), std::string::npos)
      << zone.out;
  expect_valid("map", read("zone.geojson"));
  expect_valid("plan", read("z.json"));
  const nlohmann::json plan_in_zone = nlohmann::json::parse(read("z.json"));
  EXPECT_NEAR(plan_in_zone["zones"][0]["close_driving"]["cost"].get<double>(), 15.0, 1e-3);
  EXPECT_NEAR(plan_in_zone["cost"].get<double>(), plan_in_zone["travel_time"].get<double>() + 15.0, 1e-3);
  put("narrow.wkt",
      "MULTIPOLYGON (((0 29, 29.7 29, 29.7 31, 0 31, 0 29)), ((30.3 29, 60 29, 60 31, 30.3 31, 30.3 29)))");
  static_cast<void>(run("plan " + file("narrow.wkt") + " --start 30,20,0 --goal 30,40,0 --json " + file("n.json")));
  expect_valid("plan", read("n.json"));
  ASSERT_EQ(run("generate " + map_ + " --count 5 --queries " + file("q.csv")).code, 0);
  ASSERT_EQ(
      run("plan " + map_ + " --queries " + file("q.csv") + " --out " + file("r.csv") + " --json " + file("b.json"))
          .code,
      0);
  expect_valid("plan", read("b.json"));
}

TEST_F(Tool, OtherFilesAreAsTheirSchemaSays) {
  for (const char* kind : {"visibility", "reduced", "feasible"}) {
    ASSERT_EQ(run("graph " + map_ + " --kind " + kind + " --json " + file("g.json")).code, 0) << kind;
    expect_valid("graph", read("g.json"));
  }
  ASSERT_EQ(run("doctor " + map_ + " --json " + file("d.json")).code, 0);
  expect_valid("doctor", read("d.json"));
  put("bad.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  ASSERT_EQ(run("doctor " + file("bad.wkt") + " --json " + file("d.json")).code, 1);
  expect_valid("doctor", read("d.json"));
  ASSERT_EQ(run("generate convex --obstacles 5 --out " + file("w.geojson")).code, 0);
  expect_valid("map", read("w.geojson"));
  ASSERT_EQ(run("convert paper " + file("p.geojson")).code, 0);
  expect_valid("map", read("p.geojson"));
  VehicleParameters robot;
  expect_valid("robot", to_json(robot));
  robot.turn_speed = LateralAccelerationLimit{2.0};
  robot.max_reverse_speed = 1.0;
  expect_valid("robot", to_json(robot));
  robot.turn_speed = TurnSpeedTable{{{1.0, 2.0}, {3.0, 4.0}}};
  expect_valid("robot", to_json(robot));
  expect_valid("scenario", to_json(Scenario{"w.geojson", robot, {{"t0", {0, 0, 0}, {1, 2, 3}}}}));
  expect_valid("scenario", to_json(Scenario{"w.geojson", "robot.json", {}}));
}

}  // namespace
}  // namespace arcway::internal
