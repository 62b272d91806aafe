#include "arcway/datasets/plan_io.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
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

// A car that is parked: slow, and slower yet on arcs.
Vehicle parking_vehicle() {
  VehicleParameters parameters;
  parameters.max_speed = 2.5;
  parameters.turn_speed = ConstantTurnSpeed{2.0};
  parameters.max_acceleration = 1.0;
  return Vehicle(parameters);
}

// Each from the end of the one before.
Path joined(Path path) {
  Pose at{-11.3, 1.1, 1.0};
  for (PathSegment& segment : path) {
    segment.start = at;
    at = segment.end();
  }
  return path;
}

// To and fro on arcs, ever less far.
Path shuffle() {
  Path path;
  for (double length = 0.2; length > 1e-7; length *= 0.6) {
    path.push_back({{}, length, -0.3});
    path.push_back({{}, 0.7 * length, 0.3, Gear::kReverse});
  }
  return joined(path);
}

// Too short to reach the top speed on, and to stop on.
Path pieces() {
  Path path;
  while (path.size() < 100) path.push_back({{}, 0.01, path.size() % 2 == 0 ? 0.0 : 0.2});
  return joined(path);
}

// Ahead, and back the same way for half of it.
PlanResult example_with_a_cusp() {
  const PathSegment line{{0.0, 0.0, 0.0}, 4.0, 0.0};
  return plan_along({line, {line.end(), 2.0, 0.0, Gear::kReverse}});
}

std::string plan_error(const std::string& text) {
  return test::format_error_of([&] { read_plan(text, "plan.json"); });
}

TEST(PlanJson, RoundTripIsExact) {
  const PlanResult result = example();
  const std::string text = plan_to_json(result, 7);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.rfind(R"({"format":"arcway-plan","version":1,"q":7,"status":"solved","start":[0.1,0.2,0],)", 0), 0u)
      << text;
  EXPECT_NE(text.find(R"("min_clearance":null)"), std::string::npos);
  const PlanFile file = read_plan(text, "plan.json");
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

TEST(PlanJson, TellsWhyThereIsNoPath) {
  PlanResult result;
  result.status = PlanStatus::kStartBlocked;
  result.reason = "no \"way\" out";
  const std::string text = plan_to_json(result, 0);
  EXPECT_NE(text.find(R"("reason":"no \"way\" out")"), std::string::npos) << text;
  EXPECT_TRUE(read_plan(text, "p").path.segments.empty());
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
  EXPECT_TRUE(read_plan(text, "p").path.segments.empty());
}

TEST(PlanJson, ReadsPathsWithoutSpeeds) {
  const auto plan = [](const std::string& segments) {
    return R"({"format":"arcway-plan","version":1,"start":[0,0,0],"goal":[1,0,0],"path":[)" + segments + "]}";
  };
  const std::string bare = R"({"type":"line","start":[0,0,0],"length":1,"curvature":0})";
  const PlanFile file = read_plan(plan(bare), "plan.json");
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
      read_plans(plan + "\r\n\n" + plan_to_json(example_with_a_cusp(), 8) + "\n", "p");
  ASSERT_EQ(plans.size(), 2u);
  EXPECT_EQ(plans[0].line, 1u);
  EXPECT_EQ(plans[0].plan.q, 7u);
  EXPECT_EQ(plans[1].line, 3u);
  EXPECT_EQ(plans[1].plan.q, 8u);
  EXPECT_EQ(plans[1].plan.path.segments.size(), 2u);
  // One written on many lines.
  EXPECT_EQ(read_plans(nlohmann::json::parse(plan).dump(2), "p").size(), 1u);
  const auto error = [&](const std::string& text) { return test::format_error_of([&] { read_plans(text, "p"); }); };
  EXPECT_EQ(error(plan + "\n{\"q\":-1}\n").rfind("p:2: missing key", 0), 0u);
  EXPECT_EQ(error(plan + "\n{\n3}\n").rfind("p: line 3: ", 0), 0u);
  EXPECT_EQ(error("{\"q\":-1}"), plan_error("{\"q\":-1}").replace(0, 9, "p"));
  EXPECT_NE(error("").find("empty"), std::string::npos);
}

TEST(PlanJson, KeepsTheGear) {
  const std::string text = plan_to_json(example_with_a_cusp(), 0);
  EXPECT_NE(text.find(R"("curvature":0,"direction":-1,"speed_in":0,)"), std::string::npos) << text;
  const PlanFile file = read_plan(text, "plan.json");
  ASSERT_EQ(file.path.segments.size(), 2u);
  EXPECT_EQ(file.path.segments[0].gear, Gear::kForward);
  EXPECT_EQ(file.path.segments[1].gear, Gear::kReverse);
  EXPECT_EQ(file.gear_changes, 1.0);
  EXPECT_EQ(file.path.segments[1].end().x, 2.0);
}

TEST(SamplePath, DrivesAtConstantAccelerationBetweenSamples) {
  const std::vector<Path> paths{
      joined({{{}, 30.0, 0.0}}),
      joined({{{}, 30.0, 0.0}, {{}, 3.0, 0.4}, {{}, 0.4, 0.0}, {{}, 5.0, -0.4}, {{}, 1e-9, 0.0}}),
      example().path(),
      reversed(example().path()),
      example_with_a_cusp().path(),
      shuffle(),
      pieces()};
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const Vehicle& vehicle : {Vehicle{}, parking_vehicle()}) {
      for (const PathSampling& sampling :
           {PathSampling{}, PathSampling{.max_length = 1e3, .max_angle = 1e3}, PathSampling{.max_length = 0.013}}) {
        SCOPED_TRACE(testing::Message() << "path " << k << ", top speed " << vehicle.max_speed() << ", step "
                                        << sampling.max_length);
        const PlanResult result = plan_along(paths[k], vehicle);
        const std::vector<PathSample> samples = sample_path(result.segments, vehicle, sampling);
        const double a = vehicle.max_acceleration();
        const double rounding = 1e-13 * (1.0 + result.length), moment = 1e-13 * (1.0 + result.travel_time);
        double length = 0.0;
        for (std::size_t i = 1; i < samples.size(); ++i) {
          const PathSample &before = samples[i - 1], &after = samples[i];
          const double ds = after.s - before.s, dt = after.t - before.t;
          ASSERT_GE(ds, 0.0) << i;
          ASSERT_GE(dt, 0.0) << i;
          ASSERT_LE(ds, sampling.max_length + rounding) << i;
          ASSERT_LE(ds * std::abs(after.curvature), sampling.max_angle + rounding) << i;
          ASSERT_NEAR(0.5 * (before.v + after.v) * dt, ds, rounding) << i;
          // It accelerates, holds its speed, or brakes.
          const double dv = std::abs(after.v - before.v);
          ASSERT_LE(std::min(dv, std::abs(a * dt - dv)), a * moment) << i;
          length += 0.5 * (before.v + after.v) * dt;
        }
        EXPECT_NEAR(length, result.length, rounding);
        EXPECT_EQ(samples.back().v, 0.0);
        EXPECT_NEAR(samples.back().t, result.travel_time, moment);
      }
    }
  }
}

TEST(SamplePath, HasNoSampleForRounding) {
  // Braking all the way: the speeds that it takes are rounded, and no way is left to accelerate on.
  for (double length = 1e-9; length < 1.0; length *= 1.7) {
    const Path path{{{}, 20.0, 0.0}, {{20.0, 0.0, 0.0}, length, 0.0}};
    const std::vector<PathSample> samples = sample_path(plan_along(path).segments, Vehicle{}, {.max_length = 100.0});
    EXPECT_EQ(samples.size(), 5u) << length;
  }
}

TEST(SamplePath, HasTheCuspOnceInEachGear) {
  const PlanResult result = example_with_a_cusp();
  const std::vector<PathSample> samples = sample_path(result.segments, Vehicle{}, {.max_length = 1.0});
  // 1.44 m each to accelerate to 12 m/s and to brake, 1.12 m between; back 1 m each.
  ASSERT_EQ(samples.size(), 7u + 3u);
  EXPECT_EQ(samples[2].v, 12.0);
  EXPECT_NEAR(samples[2].s, 1.44, 1e-15);
  EXPECT_NEAR(samples[2].t, 12.0 / 50.0, 1e-15);
  EXPECT_EQ(samples[4].v, 12.0);
  EXPECT_NEAR(samples[4].s, 4.0 - 1.44, 1e-15);
  EXPECT_EQ(samples[6].gear, Gear::kForward);
  EXPECT_EQ(samples[7].gear, Gear::kReverse);
  EXPECT_EQ(samples[7].s, samples[6].s);
  EXPECT_EQ(samples[7].t, samples[6].t);
  EXPECT_EQ(samples[6].v, 0.0);
  EXPECT_EQ(samples[7].v, 0.0);
  EXPECT_DOUBLE_EQ(samples[8].v, 10.0);
  EXPECT_EQ(samples[9].pose.x, 2.0);
  EXPECT_EQ(samples[9].s, 6.0);
  EXPECT_NE(path_to_csv(result.segments, Vehicle{}).find("\n6,2,0,0,0,-1,"), std::string::npos);
  // The message has poses only: the body looks ahead while it moves back.
  const auto poses = nlohmann::json::parse(path_to_nav_msgs(result.segments, Vehicle{}))["poses"];
  EXPECT_EQ(poses.back()["pose"]["position"]["x"], 2.0);
  EXPECT_EQ(poses.back()["pose"]["orientation"]["w"], 1.0);
}

TEST(PathCsv, RunsThroughAllJointsInTimeOrder) {
  const PlanResult result = example();
  const std::string csv = path_to_csv(result.segments, Vehicle{}, {.max_length = 0.5, .max_angle = 0.1});
  std::vector<std::vector<double>> rows;
  std::size_t at = csv.find('\n') + 1;
  EXPECT_EQ(csv.substr(0, at), "s,x,y,yaw,curvature,direction,t,v,steer\n");
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

TEST(SamplePath, RefusesStepsThatAreNoneOrTooMany) {
  const PlanResult result = example();
  const auto error_of = [&](const PathSampling& sampling) -> std::string {
    try {
      sample_path(result.segments, Vehicle{}, sampling);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of({.max_length = 0.0}), "sample_path: max_length is 0, must be > 0");
  EXPECT_EQ(error_of({.max_angle = -1.0}), "sample_path: max_angle is -1, must be > 0");
  EXPECT_EQ(error_of({.max_length = std::nan("")}), "sample_path: max_length is nan, must be > 0");
  const std::string few = error_of({.max_length = 1e-300});
  EXPECT_NE(few.find("steps of at most 1e-300 m and 0.05 rad, must be at most 1e+07"), std::string::npos) << few;
  EXPECT_NE(error_of({.max_angle = 5e-324}).find("the path has inf steps"), std::string::npos);
  EXPECT_EQ(error_of({.max_length = 100.0 * result.length / kMostSamplingSteps}), "");
  EXPECT_THROW(path_to_csv(result.segments, Vehicle{}, {.max_length = 1e-9}), std::invalid_argument);
  EXPECT_THROW(path_to_nav_msgs(result.segments, Vehicle{}, "map", {.max_length = 1e-9}), std::invalid_argument);
}

TEST(NavMsgsPath, HasPosesInTimeOrder) {
  const PlanResult result = example();
  const auto json = nlohmann::json::parse(path_to_nav_msgs(result.segments, Vehicle{}, "a \"map\""));
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

}  // namespace
}  // namespace arcway::internal
