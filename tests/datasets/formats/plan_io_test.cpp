#include "arcway/datasets/plan_io.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "core/motion/speed_profile.h"
#include "tests/support/format_errors.h"

namespace arcway::internal {
namespace {

PlanResult plan_along(const Path& path, const Vehicle& vehicle = Vehicle{}) {
  PlanResult result;
  result.status = PlanStatus::kSolved;
  const SpeedProfile profile = speed_profile(path, vehicle);
  for (std::size_t i = 0; i < path.size(); ++i)
    result.segments.push_back({path[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
  result.start = path.front().start;
  result.goal = path.back().end();
  result.travel_time = profile.total_time;
  result.length = length_of(path);
  result.min_clearance = std::numeric_limits<double>::infinity();
  return result;
}

PlanResult example() {
  const PathSegment line{{0.1, 0.2, 0.0}, 7.0, 0.0};
  const PathSegment arc{line.end(), 2.0, -0.5};
  return plan_along({line, arc, {arc.end(), 1.0 / 3.0, 0.0}});
}

// Ahead, and back the same way for half of it.
PlanResult example_with_a_cusp() {
  const PathSegment line{{0.0, 0.0, 0.0}, 4.0, 0.0};
  return plan_along({line, {line.end(), 2.0, 0.0, Gear::kReverse}});
}

std::string plan_error(const std::string& text) {
  return test::format_error_of([&] { parse_plan(text, "plan.json"); });
}

TEST(PlanJson, RoundTripIsExact) {
  const PlanResult result = example();
  const std::string text = plan_to_json(result, 7);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.rfind(R"({"format":"arcway-plan","version":1,"q":7,"status":"solved","start":[0.1,0.2,0],)", 0), 0u)
      << text;
  EXPECT_NE(text.find(R"("min_clearance":null)"), std::string::npos);
  const PlanFile file = parse_plan(text, "plan.json");
  EXPECT_EQ(file.status, "solved");
  EXPECT_EQ(file.goal.x, result.goal.x);
  ASSERT_EQ(file.path.segments.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(file.path.segments[i].start.heading, result.segments[i].segment.start.heading);
    EXPECT_EQ(file.path.segments[i].length, result.segments[i].segment.length);
    EXPECT_EQ(file.path.segments[i].curvature, result.segments[i].segment.curvature);
    EXPECT_EQ(file.path.speed_in[i], result.segments[i].speed_in);
    EXPECT_EQ(file.path.speed_out[i], result.segments[i].speed_out);
    EXPECT_EQ(file.path.durations[i], result.segments[i].duration);
  }
}

TEST(PlanJson, KeepsTheSpeedsAtBothEnds) {
  PlanResult result = example();
  EXPECT_EQ(plan_to_json(result, 0).find("_speed"), std::string::npos);
  result.start_speed = 0.1;
  result.goal_speed = -1.0 / 3.0;
  const PlanFile file = parse_plan(plan_to_json(result, 0), "plan.json");
  EXPECT_EQ(file.start_speed, 0.1);
  EXPECT_EQ(file.goal_speed, -1.0 / 3.0);
  EXPECT_EQ(parse_plan(plan_to_json(example(), 0), "plan.json").start_speed, 0.0);
}

TEST(PlanJson, TellsWhyThereIsNoPath) {
  PlanResult result;
  result.status = PlanStatus::kStartBlocked;
  result.reason = "no \"way\" out";
  const std::string text = plan_to_json(result, 0);
  EXPECT_NE(text.find(R"("reason":"no \"way\" out")"), std::string::npos) << text;
  EXPECT_TRUE(parse_plan(text, "p").path.segments.empty());
  EXPECT_EQ(text.find("interrupted"), std::string::npos);
  PlanResult interrupted = result;
  interrupted.interrupted = true;
  EXPECT_NE(plan_to_json(interrupted, 0).find("\"interrupted\":true"), std::string::npos);
}

TEST(PlanJson, TellsTheBottleneck) {
  PlanResult result;
  result.status = PlanStatus::kNoPassage;
  result.reason = "narrow";
  EXPECT_EQ(plan_to_json(result, 0).find("bottleneck"), std::string::npos);
  result.bottleneck = Bottleneck{.width = 0.5,
                                 .needed = 0.75,
                                 .needed_to_turn = 1.25,
                                 .obstacle_a = 3,
                                 .obstacle_b = 7,
                                 .on_a = {1.0, 2.0},
                                 .on_b = {1.0, 2.5}};
  const std::string text = plan_to_json(result, 0);
  EXPECT_NE(text.find(R"("bottleneck":{"width":0.5,"needed":0.75,"needed_to_turn":1.25,"between":[)"
                      R"({"obstacle":3,"point":[1,2]},{"obstacle":7,"point":[1,2.5]}]})"),
            std::string::npos)
      << text;
  EXPECT_TRUE(parse_plan(text, "p").path.segments.empty());
}

TEST(PlanJson, ReadsPathsWithoutSpeeds) {
  const auto plan = [](const std::string& segments) {
    return R"({"format":"arcway-plan","version":1,"start":[0,0,0],"goal":[1,0,0],"path":[)" + segments + "]}";
  };
  const std::string bare = R"({"type":"line","start":[0,0,0],"length":1,"curvature":0})";
  const PlanFile file = parse_plan(plan(bare), "plan.json");
  EXPECT_EQ(file.path.segments.size(), 1u);
  EXPECT_TRUE(file.path.durations.empty());
  EXPECT_EQ(plan_error(plan(bare + R"(,{"type":"line","start":[0,0,0],"length":null,"curvature":0})")),
            "plan.json: path[1].length: expected a number, found null");
  EXPECT_EQ(plan_error(plan(R"({"type":"line","start":[0,0,0],"length":1,"curvature":2})")),
            "plan.json: path[0].curvature: expected 0 on a line, found 2");
  EXPECT_EQ(plan_error(plan(
                bare + "," +
                R"({"type":"arc","start":[0,0,0],"length":1,"curvature":2,"speed_in":0,"speed_out":0,"duration":1})")),
            "plan.json: path[1]: speeds must be on all segments or on none");
  EXPECT_EQ(plan_error(plan(
                R"({"type":"line","start":[0,0,0],"length":1,"curvature":0,"speed_in":0,"speed_out":0,"duration":1},)" +
                bare)),
            "plan.json: path[1]: speeds must be on all segments or on none");
  EXPECT_EQ(plan_error(plan(R"({"type":"line","start":[0,0,0],"length":1,"curvature":0,"direction":0})")),
            "plan.json: path[0].direction: expected 1 (forwards) or -1 (backwards), found 0");
  EXPECT_EQ(plan_error(plan(R"({"typ":"line"})")),
            "plan.json: path[0]: unknown key \"typ\", did you mean \"type\"? There are type, start, length, curvature, "
            "direction, speed_in, speed_out, duration");
}

TEST(PlanJson, MayComeSeveralTimes) {
  const std::string plan = plan_to_json(example(), 7);
  const std::vector<PlanOnLine> plans =
      parse_plans(plan + "\r\n\n" + plan_to_json(example_with_a_cusp(), 8) + "\n", "p");
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].line, 1u);
  EXPECT_EQ(plans[0].plan.q, 7u);
  EXPECT_EQ(plans[1].line, 3u);
  EXPECT_EQ(plans[1].plan.q, 8u);
  EXPECT_EQ(plans[1].plan.path.segments.size(), 2u);
  // One written on many lines.
  EXPECT_EQ(parse_plans(nlohmann::json::parse(plan).dump(2), "p").size(), 1u);
  const auto error = [&](const std::string& text) { return test::format_error_of([&] { parse_plans(text, "p"); }); };
  EXPECT_EQ(error(plan + "\n{\"q\":-1}\n").rfind("p:2: missing key", 0), 0u);
  EXPECT_EQ(error(plan + "\n{\n3}\n").rfind("p: line 3: ", 0), 0u);
  EXPECT_EQ(error("{\"q\":-1}"), plan_error("{\"q\":-1}").replace(0, 9, "p"));
  EXPECT_NE(error("").find("empty"), std::string::npos);
}

TEST(PlanJson, KeepsTheGear) {
  const std::string text = plan_to_json(example_with_a_cusp(), 0);
  EXPECT_NE(text.find(R"("curvature":0,"direction":-1,"speed_in":0,)"), std::string::npos) << text;
  const PlanFile file = parse_plan(text, "plan.json");
  ASSERT_EQ(file.path.segments.size(), 2u);
  EXPECT_EQ(file.path.segments[0].gear, Gear::kForward);
  EXPECT_EQ(file.path.segments[1].gear, Gear::kReverse);
  EXPECT_EQ(file.gear_changes, 1.0);
  EXPECT_EQ(file.path.segments[1].end().x, 2.0);
}

TEST(PathCsv, TellsTheGear) {
  const Trajectory trajectory(example_with_a_cusp().segments, Vehicle{});
  EXPECT_NE(path_to_csv(trajectory).find("\n6,2,0,0,0,-1,"), std::string::npos);
  // The message has poses only: the body looks ahead while it moves back.
  const auto poses = nlohmann::json::parse(path_to_nav_msgs(trajectory))["poses"];
  EXPECT_EQ(poses.back()["pose"]["position"]["x"], 2.0);
  EXPECT_EQ(poses.back()["pose"]["orientation"]["w"], 1.0);
}

TEST(PathCsv, RefusesStepsThatAreTooMany) {
  const Trajectory trajectory(example().segments, Vehicle{});
  EXPECT_THROW(path_to_csv(trajectory, {.max_length = 1e-9}), std::invalid_argument);
  EXPECT_THROW(path_to_nav_msgs(trajectory, "map", {.max_length = 1e-9}), std::invalid_argument);
}

TEST(PathCsv, RunsThroughAllJointsInTimeOrder) {
  const PlanResult result = example();
  const std::string csv = path_to_csv(Trajectory(result.segments, Vehicle{}), {.max_length = 0.5, .max_angle = 0.1});
  std::vector<std::vector<double>> rows;
  std::size_t at = csv.find('\n') + 1;
  EXPECT_EQ(csv.substr(0, at), "s_m,x_m,y_m,yaw_rad,curvature_per_m,direction,t_s,v_m_per_s,steer_rad\n");
  while (at < csv.size()) {
    rows.emplace_back();
    for (bool more = true; more;) {
      double value = 0.0;
      const auto [end, code] = std::from_chars(csv.data() + at, csv.data() + csv.size(), value);
      ASSERT_EQ(code, std::errc());
      rows.back().push_back(value);
      more = *end == ',';
      at = static_cast<std::size_t>(end - csv.data()) + 1;
    }
    ASSERT_EQ(rows.back().size(), 9u);
  }
  // The line: 3 steps to accelerate, 10 to hold the speed, 2 to brake. The arc (by angle): 9 to hold, 2 to brake. The
  // last line: 1 to brake. Each of the three with its own first row.
  ASSERT_EQ(rows.size(), 15u + 11u + 1u + 3u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_GE(rows[i][0], rows[i - 1][0]);
    EXPECT_GE(rows[i][6], rows[i - 1][6]);
    // Mean speed between two samples.
    const double ds = rows[i][0] - rows[i - 1][0], dt = rows[i][6] - rows[i - 1][6];
    EXPECT_NEAR(0.5 * (rows[i][7] + rows[i - 1][7]) * dt, ds, 1e-14) << i;
  }
  EXPECT_EQ(rows.front()[7], 0.0);
  EXPECT_EQ(rows.back()[7], 0.0);
  EXPECT_NEAR(rows.back()[6], result.travel_time, 1e-12);
  EXPECT_NEAR(rows.back()[0], result.length, 1e-12);
  EXPECT_NEAR(rows[20][8], std::atan(1.3 * -0.5), 1e-15);
}

TEST(NavMsgsPath, HasPosesInTimeOrder) {
  const PlanResult result = example();
  const auto json = nlohmann::json::parse(path_to_nav_msgs(Trajectory(result.segments, Vehicle{}), "a \"map\""));
  EXPECT_EQ(json["header"]["frame_id"], "a \"map\"");
  const auto& poses = json["poses"];
  ASSERT_GT(poses.size(), 10u);
  double last = -1.0;
  for (const auto& entry : poses) {
    const auto& stamp = entry["header"]["stamp"];
    const double t = stamp["sec"].get<double>() + 1e-9 * stamp["nanosec"].get<double>();
    EXPECT_GT(t, last);
    last = t;
    const auto& q = entry["pose"]["orientation"];
    EXPECT_NEAR(std::hypot(q["z"].get<double>(), q["w"].get<double>()), 1.0, 1e-15);
  }
  EXPECT_NEAR(last, result.travel_time, 1e-8);
  const auto& end = poses.back()["pose"];
  EXPECT_EQ(end["position"]["x"], result.goal.x);
  const double yaw = 2.0 * std::atan2(end["orientation"]["z"].get<double>(), end["orientation"]["w"].get<double>());
  EXPECT_NEAR(yaw, result.goal.heading, 1e-12);
}

TEST(PlanFile, IsWrittenAndReadBack) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "arcway_plan.json";
  VehicleParameters slow;
  slow.max_speed = 3.0;
  slow.turn_speed = ConstantTurnSpeed{2.0};
  const PlanResult result = Planner(World({}), Vehicle(slow)).plan({.start = {0, 0, 0}, .goal = {9, 4, 1}});
  ASSERT_TRUE(result.solved());
  write_plan(path, result);
  const PlanFile file = read_plan(path);
  EXPECT_EQ(file.robot, slow);
  EXPECT_EQ(file.travel_time, result.travel_time);
  const Trajectory trajectory = file.trajectory();
  EXPECT_EQ(trajectory.duration(), result.trajectory().duration());
  EXPECT_EQ(trajectory.at(1.0).pose.x, result.trajectory().at(1.0).pose.x);
  std::filesystem::remove(path);
  EXPECT_THROW(read_plan(path), FileError);
  PlanResult unknown = result;
  unknown.scene = nullptr;
  write_plan(path, unknown);
  EXPECT_FALSE(read_plan(path).robot.has_value());
  std::filesystem::remove(path);
  EXPECT_THROW(static_cast<void>(PlanFile{}.trajectory()), std::invalid_argument);
}

}  // namespace
}  // namespace arcway::internal
