#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/tool.h"

namespace {

namespace fs = std::filesystem;

using arcway::internal::test::kAround;
using arcway::internal::test::kOneBox;
using arcway::internal::test::text_of;
using arcway::internal::test::Tool;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t count_of(const std::string& text, char c) {
  std::size_t count = 0;
  for (const char d : text) count += d == c ? 1 : 0;
  return count;
}

TEST_F(Tool, HelpGoesToStandardOutput) {
  const Run result = run("--help");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* command : {"plan", "graph", "generate", "validate", "doctor", "convert", "bench"}) {
    EXPECT_NE(result.out.find(command), std::string::npos);
    EXPECT_EQ(run(std::string(command) + " --help").code, 0);
  }
}

TEST_F(Tool, SaysItsVersion) {
  const Run result = run("--version");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "arcway " ARCWAY_VERSION "\n");
}

TEST_F(Tool, PlansThePaperExampleAndValidatesItsOwnPlan) {
  const Run plan = run("plan paper --json " + file("p.json") + " --svg " + file("p.svg") + " --csv " + file("p.csv"));
  ASSERT_EQ(plan.code, 0) << plan.err << plan.out;
  for (const char* label : {"travel time", "length", "lower bound", "smallest clearance", "build", "valid"}) {
    EXPECT_NE(plan.out.find(label), std::string::npos) << label;
  }
  EXPECT_NE(read("p.json").find("\"format\":\"arcway-plan\""), std::string::npos);
  EXPECT_NE(read("p.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(read("p.csv").rfind("s_m,x_m,y_m,yaw_rad,curvature_per_m,direction,t_s,v_m_per_s,steer_rad\n", 0), 0u);
  const Run check = run("validate paper --path " + file("p.json"));
  EXPECT_EQ(check.code, 0) << check.out << check.err;
}

TEST_F(Tool, ValidatesAmongMovingObstacles) {
  ASSERT_EQ(run("plan " + map_ + kAround + " --json " + file("p.json")).code, 0);
  const std::string validate = "validate " + map_ + " --path " + file("p.json") + " --moving ";
  const auto put_box = [&](const std::string& x, const std::string& velocity) {
    put("m.json", R"({"obstacles":[{"outline":[[)" + x + ",0],[" + x + ",100],[" + x + R"(.5,0]],"velocity":[)" +
                      velocity + "]}]}");
  };
  put_box("-90", "0,0");
  EXPECT_EQ(run(validate + file("m.json")).code, 0);
  put_box("-90", "30,0");  // over the whole map within some seconds
  const Run conflict = run(validate + file("m.json"));
  EXPECT_EQ(conflict.code, 1) << conflict.out;
  EXPECT_NE(conflict.out.find("conflict            moving obstacle 0 in segment "), std::string::npos) << conflict.out;
  expect_bad_input(validate + file("p.json"), "p.json: ");
}

// A bar that crosses the map from left to right, and that is gone in time.
std::string bar(const std::string& x, const std::string& more) {
  return R"({"obstacles":[{"outline":[[)" + x + ",-5],[" + x + "5,-5],[" + x + "5,65],[" + x + R"(,65]],"velocity":)" +
         more + "}]}";
}

TEST_F(Tool, DrawsZonesAndDrivesAroundThem) {
  const auto feature = [](const std::string& properties, const std::string& ring) {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":"Polygon","coordinates":[)" +
           ring + "]}}";
  };
  put("z.geojson",
      R"({"type":"FeatureCollection","features":[)" + feature("", "[[20,10],[40,10],[40,20],[20,20],[20,10]]") + "," +
          feature(R"("role":"speed_limit","max_speed":1,"name":"yard")", "[[22,20],[38,20],[38,30],[22,30],[22,20]]") +
          "," +
          feature(R"("role":"one_way","heading":3.1,"tolerance":0.5,"name":"lane")",
                  "[[18,0],[42,0],[42,10],[18,10],[18,0]]") +
          "]}");
  const Run plan = run("plan " + file("z.geojson") + " --start 5,12,0 --goal 58,12,0 --svg " + file("z.svg"));
  ASSERT_EQ(plan.code, 0) << plan.err << plan.out;
  EXPECT_EQ(plan.out.find("in zone"), std::string::npos) << plan.out;
  const std::string svg = read("z.svg");
  EXPECT_NE(svg.find("id=\"zones\""), std::string::npos);
  for (const char* name : {"yard", "lane"}) EXPECT_NE(svg.find(name), std::string::npos) << name;
}

TEST_F(Tool, EvadesMovingObstacles) {
  const std::string plan = "plan " + map_ + kAround + " --json " + file("p.json");
  const std::string validate = "validate " + map_ + " --path " + file("p.json") + " --moving " + file("m.json");
  ASSERT_EQ(run(plan).code, 0);
  const std::string fastest = read("p.json");
  put("m.json", bar("30", R"([0,0],"until":12)"));
  ASSERT_EQ(run(validate).code, 1) << "the fastest motion meets it";
  const Run evading = run(plan + " --csv " + file("p.csv") + " --svg " + file("p.svg") + " --moving " + file("m.json"));
  ASSERT_EQ(evading.code, 0) << evading.err << evading.out;
  EXPECT_NE(evading.out.find("moving obstacles    waits "), std::string::npos) << evading.out;
  EXPECT_NE(evading.out.find(" s later at the goal\n"), std::string::npos) << evading.out;
  EXPECT_NE(read("p.json").find("\"evasion\":{\"delay\":"), std::string::npos) << read("p.json");
  const Run valid = run(validate);
  EXPECT_EQ(valid.code, 0) << valid.out;
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.csv")).code, 0);

  put("m.json", bar("-300", "[0,0]"));
  const Run unmet = run(plan + " --moving " + file("m.json"));
  ASSERT_EQ(unmet.code, 0) << unmet.err << unmet.out;
  EXPECT_NE(unmet.out.find("moving obstacles    none is met\n"), std::string::npos) << unmet.out;
  const auto path_of = [](const std::string& json) {
    const std::size_t begin = json.find("\"path\"");
    return json.substr(begin, json.find("\"statistics\"") - begin);
  };
  EXPECT_EQ(path_of(read("p.json")).substr(0, path_of(fastest).size() - 1),
            path_of(fastest).substr(0, path_of(fastest).size() - 1));
}

TEST_F(Tool, SaysThatMovingObstaclesCannotBeEvaded) {
  const std::string plan = "plan " + map_ + kAround + " --json " + file("p.json");
  put("m.json", bar("30", "[0,0]"));
  const Run blocked = run(plan + " --moving " + file("m.json"));
  EXPECT_EQ(blocked.code, 1);
  EXPECT_NE(blocked.out.find(": conflict\n"), std::string::npos) << blocked.out;
  EXPECT_NE(blocked.out.find("the horizon of 60 s"), std::string::npos) << blocked.out;
  EXPECT_NE(blocked.out.find("the fastest motion meets moving obstacle 0 in segment "), std::string::npos)
      << blocked.out;
  EXPECT_NE(read("p.json").find("\"status\":\"conflict\""), std::string::npos);
  EXPECT_NE(read("p.json").find("\"path\":[]"), std::string::npos);
  put("m.json", bar("30", R"([0,0],"until":80)"));
  EXPECT_EQ(run(plan + " --moving " + file("m.json")).code, 1);
  EXPECT_EQ(run(plan + " --horizon 120 --moving " + file("m.json")).code, 0);

  expect_bad_input(plan + " --moving " + file("p.json"), "p.json: ");
  expect_bad_input(plan + " --horizon 0 --moving " + file("m.json"), "--horizon: above 0 s, got \"0\"");
  expect_bad_input(plan + " --alternatives 2 --moving " + file("m.json"), "--moving: only a single plan evades");
  put("m.json", R"({"obstacles":[{"outline":[[0,0],[1,1],[1,0],[0,1]],"velocity":[0,0]}]})");
  expect_bad_input(plan + " --moving " + file("m.json"), "moving obstacle 0");
}

TEST_F(Tool, PlansAroundABox) {
  const Run result = run("plan " + map_ + kAround);
  EXPECT_EQ(result.code, 0) << result.err << result.out;
  EXPECT_EQ(result.err, "");
}

TEST_F(Tool, LeavesOutRowsOfTheStrategyAndMoves) {
  const std::string plan = "plan paper --json " + file("p.json");
  ASSERT_EQ(run(plan + " --leave-out \"drop turns\" --leave-out \"faster turns\"").code, 0);
  expect_bad_input("plan paper --leave-out tree",
                   "leave out \"tree\": no row of the strategy and no move of refinement");
}

TEST_F(Tool, RefinesUnlessToldOtherwise) {
  const std::string plan = "plan paper --json " + file("p.json");
  ASSERT_EQ(run(plan).code, 0);
  EXPECT_EQ(read("p.json").find("\"refine_trials\":0,"), std::string::npos);
  ASSERT_EQ(run(plan + " --refine-trials 0").code, 0);
  EXPECT_NE(read("p.json").find("\"refine_trials\":0,"), std::string::npos);
  expect_bad_input("plan paper --refine-trials -1", "--refine-trials: expected a whole number >= 0, got \"-1\"");
  expect_bad_input("plan paper --refine-trials 4294967296", "--refine-trials: at most 4294967295");
}

TEST_F(Tool, PlansTheSameLazilyAndEagerly) {
  const std::string plan =
      "plan clutter/convex/n30/m6/f15/s7 --start 2,2,0 --goal 60,50,90deg --json " + file("p.json");
  const auto path_of = [&](const std::string& options) {
    EXPECT_EQ(run(plan + options).code, 0);
    const std::string text = read("p.json");
    return text.substr(0, text.find("\"statistics\""));
  };
  const std::string lazy = path_of(" --graph lazy");
  EXPECT_NE(read("p.json").find("\"graph\":\"lazy\""), std::string::npos);
  EXPECT_EQ(path_of(" --graph eager"), lazy);
  EXPECT_NE(read("p.json").find("\"graph\":\"eager\""), std::string::npos);
  EXPECT_EQ(path_of(" --suboptimality 0 --refine-trials 4000"), lazy);
  EXPECT_NE(path_of(" --suboptimality 0.1"), "");
  EXPECT_NE(read("p.json").find("\"suboptimality\":0.1"), std::string::npos);
  expect_bad_input(plan + " --graph quick", "quick");
  expect_bad_input(plan + " --suboptimality -1", "suboptimality");
}

TEST_F(Tool, ReadsGridsAsToldTo) {
  const std::string grid = put("g.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.SS.\n....\n");
  const auto obstacles = [&](const std::string& options) {
    const Run result = run("convert " + grid + " " + file("g.wkt") + options);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.out.substr(result.out.find("obstacles"), 24);
  };
  EXPECT_NE(obstacles("").find(" 1"), std::string::npos);
  EXPECT_NE(obstacles(" --swamp-free").find(" 0"), std::string::npos);
  ASSERT_EQ(run("convert " + grid + " " + file("g.geojson")).code, 0);
  EXPECT_NE(read("g.geojson").find("boundary"), std::string::npos);
  ASSERT_EQ(run("convert " + grid + " " + file("h.geojson") + " --open-frame").code, 0);
  EXPECT_EQ(read("h.geojson").find("boundary"), std::string::npos);
}

TEST_F(Tool, ReadsMapsAsToldTo) {
  const std::string hall =
      put("hall.wkt", "POLYGON ((0 0, 60 0, 60 60, 0 60, 0 0), (20 20, 40 20, 40 40, 20 40, 20 20))");
  const Run blocked = run("plan " + hall + kAround);
  EXPECT_EQ(blocked.code, 1);
  EXPECT_NE(blocked.out.find("is it meant as free space (--polygons free)?"), std::string::npos) << blocked.out;
  EXPECT_EQ(run("plan " + hall + kAround + " --polygons free").code, 0);
  EXPECT_EQ(run("graph " + hall + " --polygons free").code, 0);
  EXPECT_NE(run("doctor " + hall + " --polygons free").out.find("1 polygon of free space"), std::string::npos);
  expect_bad_input("plan " + hall + kAround + " --polygons open", "--polygons: expected blocked or free");
  expect_bad_input("plan " + hall + kAround + " --format wtk", "unknown format \"wtk\", did you mean \"wkt\"?");
  expect_bad_input("plan " + hall + kAround + " --format svg", "hall.wkt");
  EXPECT_EQ(run("doctor " + put("l.map", "1,3\n.E.\n") + " --free-letters E").code, 0);
  expect_bad_input("doctor " + file("l.map"), "--free-letters");
  expect_bad_input("plan " + hall + kAround + " --lonlat --planar", "--planar");
}

TEST_F(Tool, DrivesBackwardsOnlyWhereAllowed) {
  const std::string plan = "plan " + map_ + " --start 10,10,0 --goal 5,10,0 --json " + file("p.json");
  ASSERT_EQ(run(plan).code, 0);
  EXPECT_EQ(read("p.json").find("\"direction\":-1"), std::string::npos);
  const Run both = run(plan + " --reverse --cusp-cost 1.5 --svg " + file("p.svg") + " --csv " + file("p.csv"));
  EXPECT_EQ(both.code, 0) << both.err << both.out;
  EXPECT_NE(both.out.find("changes of gear     0"), std::string::npos) << both.out;
  EXPECT_NE(read("p.json").find("\"direction\":-1"), std::string::npos);
  EXPECT_NE(read("p.svg").find("stroke-dasharray"), std::string::npos);
  EXPECT_NE(read("p.svg").find("backwards</text>"), std::string::npos);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 0);
  std::string text = read("p.json");
  text.erase(text.find("\"direction\":-1,"), 15);
  put("wrong.json", text);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("wrong.json")).code, 1);
  expect_bad_input(plan + " --cusp-cost 1", "--reverse");
  expect_bad_input(plan + " --reverse --cusp-cost -1", "--cusp-cost");
}

TEST_F(Tool, PlansBetweenEndsThatMove) {
  const std::string plan = "plan " + map_ + kAround + " --json " + file("p.json") + " --csv " + file("p.csv");
  const Run moving = run(plan + " --start-speed 2.5 --goal-speed 3");
  ASSERT_EQ(moving.code, 0) << moving.err << moving.out;
  EXPECT_NE(moving.out.find("2.500 m/s at the start, 3.000 m/s at the goal"), std::string::npos) << moving.out;
  EXPECT_NE(read("p.json").find("\"start_speed\":2.5"), std::string::npos);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 0);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.csv")).code, 0);
  std::string text = read("p.json");
  text.replace(text.find("\"start_speed\":2.5"), 17, "\"start_speed\":2.4");
  put("wrong.json", text);
  const Run wrong = run("validate " + map_ + " --path " + file("wrong.json"));
  EXPECT_EQ(wrong.code, 1);
  EXPECT_NE(wrong.out.find("the speed jumps from 2.4 to 2.5 m/s"), std::string::npos) << wrong.out;
  expect_bad_input(plan + " --start-speed -1", "start speed: -1 m/s, must be from 0 to");
  expect_bad_input(plan + " --goal-speed fast", "--goal-speed");
  expect_bad_input(plan + " --start-speed 1 --waypoint 5,5", "--start-speed, --goal-speed: only to one goal");
}

TEST_F(Tool, KeepsClearanceWhereToldTo) {
  const std::string plan = "plan " + map_ + kAround + " --json " + file("p.json");
  const Run wide = run(plan + " --prefer-clearance 2");
  ASSERT_EQ(wide.code, 0) << wide.err << wide.out;
  EXPECT_NE(wide.out.find("driven closer       0.000 m, closer than 2 m; with that the plan costs"), std::string::npos)
      << wide.out;
  EXPECT_NE(read("p.json").find(R"("close_driving":{"distance":2,"length":0,"cost":0})"), std::string::npos);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 0);
  ASSERT_EQ(run(plan + " --prefer-clearance 2 --clearance-cost 0").code, 0);
  const std::string close = read("p.json");
  EXPECT_NE(close.find(R"("close_driving":{"distance":2,"length":)"), std::string::npos);
  EXPECT_EQ(close.find(R"("length":0,"cost":0})"), std::string::npos);
  ASSERT_EQ(run(plan).code, 0);
  EXPECT_EQ(read("p.json").find("close_driving"), std::string::npos);
  expect_bad_input(plan + " --prefer-clearance 0", "--prefer-clearance: above 0 m, got \"0\"");
  expect_bad_input(plan + " --prefer-clearance 1 --clearance-cost=-2", "--clearance-cost: at least 0 s/m, got \"-2\"");
  expect_bad_input(plan + " --clearance-cost 2", "--prefer-clearance");
}

TEST_F(Tool, SamplesAsDenselyAsToldTo) {
  const std::string plan = "plan " + map_ + kAround;
  const std::string files = " --csv " + file("p.csv") + " --ros-path " + file("p.json");
  ASSERT_EQ(run(plan + files).code, 0);
  const std::string csv = read("p.csv"), poses = read("p.json");
  ASSERT_EQ(run(plan + files + " --sample-step 0.5").code, 0);
  EXPECT_EQ(read("p.csv"), csv);
  EXPECT_EQ(read("p.json"), poses);
  ASSERT_EQ(run(plan + files + " --sample-step 0.01").code, 0);
  const std::vector<std::string> rows = lines_of(read("p.csv"));
  for (std::size_t i = 2; i < rows.size(); ++i) ASSERT_LE(std::stod(rows[i]) - std::stod(rows[i - 1]), 0.01 + 1e-12);
  EXPECT_GT(read("p.json").size(), 10 * poses.size());
  for (const std::string option : {" --csv ", " --ros-path "})
    EXPECT_EQ(run(plan + option + file("q") + " --sample-step 2").code, 0);
  expect_bad_input(plan + " --sample-step 0.1 --json " + file("p.json"),
                   "--sample-step: only with --csv or --ros-path");
  expect_bad_input(plan + files + " --sample-step 0", "--sample-step: above 0 m, got \"0\"");
  expect_bad_input(plan + files + " --sample-step=-0.1", "--sample-step: above 0 m, got \"-0.1\"");
  expect_bad_input(plan + files + " --sample-step inf", "--sample-step: expected a finite number, got \"inf\"");
  expect_bad_input(plan + files + " --sample-step 1e-9",
                   "steps of at most 1e-09 m and 0.05 rad, must be at most 1e+07");
}

TEST_F(Tool, LeadsByWaypointsToTheNearestOfSeveralGoals) {
  const Run near = run("plan " + map_ + " --start 10,10,0 --goal 50,50,90deg --goal 50,10 --json " + file("p.json"));
  EXPECT_EQ(near.code, 0) << near.err << near.out;
  EXPECT_NE(near.out.find("goal                (50.000, 10.000), heading 0.0000 rad"), std::string::npos) << near.out;
  const std::string direct = read("p.json");
  EXPECT_NE(direct.find("\"goal_index\":1"), std::string::npos) << direct;
  const Run tour =
      run("plan " + map_ + " --start 10,10,0 --waypoint 10,50 --waypoint 50,50,0 --goal 50,10,-90deg --json " +
          file("p.json") + " --svg " + file("p.svg"));
  EXPECT_EQ(tour.code, 0) << tour.err << tour.out;
  EXPECT_NE(tour.out.find("waypoint            (10.000, 50.000), any heading"), std::string::npos) << tour.out;
  EXPECT_NE(read("p.svg").find(">waypoint 2</text>"), std::string::npos);
  EXPECT_NE(read("p.json").find("\"passed\":["), std::string::npos);
  EXPECT_NE(tour.out.find("valid               yes"), std::string::npos);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 0);
  const Run none = run("plan " + map_ + " --start 10,10,0 --goal 30,30 --goal 31,31,0");
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.out.find("goal                (30.000, 30.000), any heading"), std::string::npos) << none.out;
  expect_bad_input("plan " + map_ + " --start 10,10,0 --goal 30", "--goal");
  expect_bad_input("plan " + map_ + " --start 10,10,0 --goal 30,30 --waypoint 1,x", "--waypoint");
}

TEST_F(Tool, GivesAlternatives) {
  const Run both = run("plan " + map_ + " --start 10,28,0 --goal 50,28,0 --alternatives 3 --json " + file("p.json") +
                       " --svg " + file("p.svg"));
  EXPECT_EQ(both.code, 0) << both.err << both.out;
  EXPECT_NE(both.out.find("alternative         2 of 2"), std::string::npos) << both.out;
  EXPECT_EQ(lines_of(read("p.json")).size(), 2u);
  expect_bad_input("plan " + map_ + " --start 10,28,0 --goal 50,28 --alternatives 2", "--alternatives");
  expect_bad_input("plan " + map_ + kAround + " --alternatives 0", "--alternatives");
}

TEST_F(Tool, AChangedPathIsNotValid) {
  ASSERT_EQ(run("plan " + map_ + kAround + " --json " + file("p.json")).code, 0);
  std::string plan = read("p.json");
  const std::size_t at = plan.find("\"goal\":[");
  ASSERT_NE(at, std::string::npos);
  plan.insert(at + 8, "1");
  put("p.json", plan);
  const Run result = run("validate " + map_ + " --path " + file("p.json"));
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("NOT VALID"), std::string::npos);
}

TEST_F(Tool, ValidatesAPlanForItsOwnRobot) {
  const std::string robot =
      put("long.json", R"({"format":"arcway-robot","version":1,"length":3,"width":1,"wheelbase":2})");
  ASSERT_EQ(run("plan " + map_ + kAround + " --robot " + robot + " --json " + file("p.json")).code, 0);
  const std::string validate = "validate " + map_ + " --path " + file("p.json");
  const Run own = run(validate);
  EXPECT_EQ(own.code, 0) << own.out << own.err;
  EXPECT_NE(own.out.find("that of the plan: 3.000 x 1.000 m"), std::string::npos) << own.out;
  const std::string wide =
      put("wide.json", R"({"format":"arcway-robot","version":1,"length":3,"width":9,"wheelbase":2})");
  const Run other = run(validate + " --robot " + wide);
  EXPECT_EQ(other.code, 1) << other.out;
  EXPECT_NE(other.out.find("wide.json: 3.000 x 9.000 m"), std::string::npos) << other.out;

  const std::string plan = read("p.json"), width = R"("width":1,)";
  ASSERT_NE(plan.find(width), std::string::npos) << plan;
  put("p.json", std::string(plan).replace(plan.find(width), width.size(), R"("width":-1,)"));
  expect_bad_input(validate, "p.json: robot: vehicle: width is -1");
}

TEST_F(Tool, ValidatesWhatAPlanSaysOfItself) {
  ASSERT_EQ(run("plan " + map_ + kAround + " --json " + file("p.json")).code, 0);
  const std::string plan = read("p.json");
  for (const char* total : {"travel_time", "length", "gear_changes"}) {
    const std::string key = "\"" + std::string(total) + "\":";
    std::string changed = plan;
    put("p.json", changed.insert(changed.rfind(key, changed.find("\"path\":")) + key.size(), "1"));
    const Run result = run("validate " + map_ + " --path " + file("p.json"));
    EXPECT_EQ(result.code, 1) << total;
    EXPECT_NE(result.out.find("the file says 1"), std::string::npos) << result.out;
  }
  const std::size_t path = plan.find("\"path\":[") + 8;
  put("p.json", plan.substr(0, path) + plan.substr(plan.find("],\"statistics\"")));
  const Run nowhere = run("validate " + map_ + " --path " + file("p.json"));
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_NE(nowhere.out.find("NOT VALID"), std::string::npos) << nowhere.out;
}

TEST_F(Tool, ValidatesEachPlanOfAFile) {
  const std::string header = "q,sx,sy,stheta,gx,gy,gtheta\n";
  const auto plan = [&](const std::string& queries) {
    const std::string file_of_queries = put("q.csv", header + queries);
    return run("plan " + map_ + " --queries " + file_of_queries + " --out " + file("r.csv") + " --json " +
               file("p.json"));
  };
  const std::string validate = "validate " + map_ + " --path " + file("p.json");
  ASSERT_EQ(plan("7,10,10,0,50,50,1.5\n8,30,30,0,50,50,0\n9,10,50,1.5,50,10,0\n").code, 0);
  const Run good = run(validate);
  EXPECT_EQ(good.code, 0) << good.err << good.out;
  for (const char* text : {"p.json:1: query 7: valid\n", "p.json:2: query 8: no path to check (start in collision)\n",
                           "p.json:3: query 9: valid\n", "2 of 2 paths, 1 plan has none"})
    EXPECT_NE(good.out.find(text), std::string::npos) << text << "\n" << good.out;

  std::string changed = read("p.json");
  const std::size_t at = changed.rfind("\"goal\":[");
  ASSERT_NE(at, std::string::npos);
  put("p.json", changed.insert(at + 8, "1"));
  const Run bad = run(validate);
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.out.find("p.json:3: query 9: NOT VALID\n"), std::string::npos) << bad.out;
  EXPECT_NE(bad.out.find("1 of 2 paths"), std::string::npos) << bad.out;

  ASSERT_EQ(plan("8,30,30,0,50,50,0\n9,30,31,0,50,50,0\n").code, 0);
  EXPECT_EQ(run(validate).code, 1);
  put("p.json", read("p.json") + "{\"format\":1}\n");
  expect_bad_input(validate, "p.json:3: format: expected");
}

TEST_F(Tool, ValidatesAPlanThatStays) {
  const auto validate = [&](const std::string& goal) {
    put("p.json", R"({"format":"arcway-plan","version":1,"start":[10,10,0],"goal":)" + goal + R"(,"path":[]})");
    return run("validate " + map_ + " --path " + file("p.json"));
  };
  const Run good = validate("[10.0000005,10,0]");
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_NE(good.out.find("p.json: valid\n"), std::string::npos) << good.out;
  const Run bad = validate("[10.00001,10,0]");
  EXPECT_EQ(bad.code, 1);
  EXPECT_NE(bad.out.find("NOT VALID"), std::string::npos) << bad.out << bad.err;
}

TEST_F(Tool, NoPathIsExitCodeOneWithTheReason) {
  const Run inside = run("plan " + map_ + " --start 30,30,0 --goal 50,50,0 --svg " + file("p.svg"));
  EXPECT_EQ(inside.code, 1);
  EXPECT_NE(read("p.svg").find("<g id=\"robot\""), std::string::npos);  // what collides
  EXPECT_NE(inside.out.find("reason"), std::string::npos);
  const Run outside = run("plan " + map_ + " --start 10,10,0 --goal 70,70,0 --json " + file("p.json"));
  EXPECT_EQ(outside.code, 1);
  EXPECT_NE(outside.out.find("reason"), std::string::npos);
  EXPECT_NE(read("p.json").find("\"reason\""), std::string::npos);
}

TEST_F(Tool, ARobotThatIsTooWideGetsAReason) {
  const std::string robot =
      put("wide.json", R"({"format":"arcway-robot","version":1,"length":40,"width":39,"wheelbase":30})");
  const Run result = run("plan " + map_ + kAround + " --robot " + robot);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.out.find("reason"), std::string::npos);
}

TEST_F(Tool, BatchWritesOneLineAQuery) {
  const std::string queries = put("q.csv",
                                  "# a comment\r\nq,sx,sy,stheta,gx,gy,gtheta\r\n7,10,10,0,50,50,1.5\r\n"
                                  "\r\n8,30,30,0,50,50,0\r\n9,10,50,90deg,50,10,0\r\n");
  const Run result =
      run("plan " + map_ + " --queries " + queries + " --out " + file("r.csv") + " --json " + file("r.jsonl"));
  ASSERT_EQ(result.code, 0) << result.err << result.out;
  const std::vector<std::string> lines = lines_of(read("r.csv"));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0].rfind("# build ", 0), 0u);
  EXPECT_EQ(lines[1], "q,status,travel_time_s,length_m,lower_bound_s,min_clearance_m,valid,plan_ms");
  EXPECT_EQ(lines[2].rfind("7,solved,", 0), 0u);
  EXPECT_EQ(lines[3].rfind("8,start in collision,,,,,,", 0), 0u);
  EXPECT_EQ(lines[4].rfind("9,solved,", 0), 0u);
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_EQ(count_of(lines[i], ','), 7u) << lines[i];
  const std::vector<std::string> objects = lines_of(read("r.jsonl"));
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_NE(objects[1].find("\"q\":8"), std::string::npos);
}

TEST_F(Tool, QueryErrorsNameFileAndLine) {
  const auto expect = [&](const std::string& text, const std::string& message) {
    expect_bad_input("plan " + map_ + " --queries " + put("q.csv", text) + " --out " + file("r.csv"), message);
    EXPECT_FALSE(exists("r.csv"));
  };
  const std::string header = "q,sx,sy,stheta,gx,gy,gtheta\n";
  expect("", "no queries");
  expect("a,b\n", "q.csv:1: expected the header");
  expect(header + "0,1,2,3,4,5\n", "q.csv:2: expected 7 fields");
  expect(header + "0,1,2,3,4,5,6\n1,1,two,3,4,5,6\n", "q.csv:3: sy: expected a finite number, got \"two\"");
  expect(header + "0,1,2,3,4,nan,6\n", "q.csv:2: gy: expected a finite number");
}

#ifdef ARCWAY_WITH_ACCEL

TEST_F(Tool, BackendsBuildersAndThreadsGiveTheSameGraphsAndPlans) {
  ASSERT_EQ(run("generate star --obstacles 20 --seed 4 --out " + file("w.geojson")).code, 0);
  const std::string graph = "graph " + file("w.geojson") + " --kind ";
  const std::string plan = "plan " + map_ + kAround + " --csv " + file("p.csv");
  const std::string json = " --json " + file("c.json");
  for (const std::string kind : {"visibility", "reduced", "feasible"}) {
    ASSERT_EQ(run(graph + kind + " --backend reference --edges " + file(kind + ".csv")).code, 0);
  }
  ASSERT_EQ(run(plan + " --backend reference").code, 0);
  const std::string expected_plan = read("p.csv");
  for (const std::string builder : {"pairwise", "tangent-cones"}) {
    for (const std::string threads : {"1", "2", "3", "8"}) {
      const std::string options = " --backend embree --builder " + builder + " --threads " + threads;
      for (const std::string kind : {"visibility", "reduced", "feasible"}) {
        ASSERT_EQ(run(graph + kind + options + json + " --edges " + file("e.csv")).code, 0);
        EXPECT_EQ(read("e.csv"), read(kind + ".csv")) << kind << options;
        EXPECT_NE(read("c.json").find("\"backend\":\"embree\""), std::string::npos);
        if (threads == "1") {
          EXPECT_NE(read("c.json").find("\"threads\":1,"), std::string::npos);
        }
      }
      ASSERT_EQ(run(plan + options + json).code, 0);
      EXPECT_EQ(read("p.csv"), expected_plan) << options;
      EXPECT_NE(read("c.json").find("\"builder\":\"" + builder + "\""), std::string::npos);
    }
  }
}

TEST_F(Tool, PlansOnEmbreeUnlessToldOtherwise) {
  EXPECT_NE(run("plan " + map_ + kAround).out.find("tangent-cones, embree, "), std::string::npos);
  EXPECT_NE(run("plan " + map_ + kAround + " --backend reference").out.find("pairwise, reference, 1 thread"),
            std::string::npos);
}

#else

TEST_F(Tool, SaysThatItHasNoEmbree) {
  expect_bad_input("plan " + map_ + kAround + " --backend embree", "no embree backend");
  expect_bad_input("plan " + map_ + kAround + " --builder tangent-cones", "no tangent-cone builder");
  expect_bad_input("plan " + map_ + kAround + " --threads 2", "one thread");
}

#endif

TEST_F(Tool, UsageErrorsGoToStandardError) {
  expect_bad_input("", "subcommand");
  expect_bad_input("fly", "fly");
  expect_bad_input("fly " + map_ + kAround, "fly");
  expect_bad_input("plan", "WORLD is required\nRun with --help");
  expect_bad_input("plan " + map_ + " --fly", "--fly\nRun with --help");
  expect_bad_input("plan " + map_ + " --svg", "--svg");
  expect_bad_input("plan " + map_, "--start");
  expect_bad_input("plan " + map_ + " --start 10,10 --goal 50,50,0", "expected X,Y,HEADING");
  expect_bad_input("plan " + map_ + " --start 10,10,0x --goal 50,50,0", "expected a finite number");
  expect_bad_input("plan " + map_ + kAround + " --threads 0", "--threads");
  expect_bad_input("plan " + map_ + kAround + " --threads 1025", "--threads");
  expect_bad_input("plan " + map_ + kAround + " --backend gpu", "\"gpu\"");
  expect_bad_input("plan " + map_ + kAround + " --builder magic", "\"magic\"");
  expect_bad_input("plan " + map_ + kAround + " --heuristic none", "--heuristic");
  expect_bad_input("plan " + map_ + " --queries " + map_, "--out");
  const std::string queries = put("q.csv", "q,sx,sy,stheta,gx,gy,gtheta\n");
  expect_bad_input("plan " + map_ + " --queries " + queries + " --out " + map_,
                   "was read, and would be replaced by what is written");
  expect_bad_input("graph " + map_ + " --kind dense", "--kind");
  expect_bad_input("report " ARCWAY_SOURCE_DIR "/bench/results/amd-epyc/results.json", "--out");
  expect_bad_input("generate cubes --out " + file("w.geojson"), "cubes");
  expect_bad_input("generate convex --fill 2 --out " + file("w.geojson"), "fill");
  EXPECT_FALSE(exists("w.geojson"));
}

TEST_F(Tool, BadMapsGetAMessage) {
  const auto map_of = [&](const std::string& ring) {
    return put("bad.geojson", R"({"type":"Polygon","coordinates":[)" + ring + "]}");
  };
  expect_bad_input("plan " + file("none.geojson") + kAround, "none.geojson");
  expect_bad_input("plan " + put("empty.geojson", "") + kAround, "empty.geojson");
  expect_bad_input("plan " + map_of("[[0,0],[4,NaN],[4,4],[0,0]]") + kAround, "bad.geojson");
  expect_bad_input("plan " + map_of("[[0,0],[4,null],[4,4],[0,0]]") + kAround, "bad.geojson");
  expect_bad_input("plan " + map_of("[[0,0],[4,4],[4,0],[0,5],[0,0]]") + kAround, "bad.geojson");
  expect_bad_input("plan " + map_of("[[0,0],[4,4],[0,0]]") + kAround, "bad.geojson");
}

TEST_F(Tool, AFileThatCannotBeWrittenIsBadInput) {
  const std::string wrong = file("no/such/folder/p.json");
  expect_bad_input("plan " + map_ + kAround + " --json " + wrong, "cannot write " + wrong + ": No such file");
  expect_bad_input("plan " + map_ + kAround + " --csv " + file("p.csv") + " --json " + wrong, "cannot write " + wrong);
  EXPECT_FALSE(exists("p.csv"));
  fs::create_symlink("loop", file("loop"));
  expect_bad_input("plan " + map_ + kAround + " --svg " + file("loop"), "cannot write " + file("loop") + ": Too many");
  expect_bad_input("figures --out " + map_ + "/x", "cannot make folder " + map_ + "/x: Not a directory");
  expect_bad_input("report " ARCWAY_SOURCE_DIR "/bench/results/amd-epyc/results.json --out " + map_,
                   "cannot make folder " + map_ + ": ");
}

TEST_F(Tool, AsksWhatWasMeantByUnknownWords) {
  expect_bad_input("plan " + map_ + kAround + " --rebot r.json", "Did you mean --robot?");
  expect_bad_input("plan " + map_ + kAround + " --timelimit=3", "Did you mean --time-limit?");
  expect_bad_input("paln " + map_, "Did you mean plan?");
  expect_bad_input("graph wharehouse/v1000", "unknown family \"wharehouse\", did you mean \"warehouse\"?");
  EXPECT_EQ(run("plan " + map_ + kAround + " --zzz").err.find("Did you mean"), std::string::npos);
}

TEST_F(Tool, AsksWhetherARobotsMeasuresAreMeant) {
  const auto out_of = [&](const std::string& measures) {
    return run("plan " + map_ + kAround + " --robot " +
               put("r.json", R"({"format":"arcway-robot","version":1,)" + measures + "}"))
        .out;
  };
  EXPECT_NE(out_of(R"("length":1,"width":0.5,"wheelbase":2)").find("are length and wheelbase swapped?"),
            std::string::npos);
  EXPECT_NE(out_of(R"("length":6,"width":0.5,"wheelbase":1)").find("reaches 2.5 m beyond each axle"),
            std::string::npos);
  EXPECT_EQ(out_of(R"("length":4.5,"width":1.8,"wheelbase":2.7)").find("wheelbase"), std::string::npos);
}

TEST_F(Tool, AsksAboutARobotsMeasuresInEachCommandThatReadsIt) {
  const std::string robot =
      put("r.json", R"({"format":"arcway-robot","version":1,"length":1,"width":0.5,"wheelbase":2})");
  const std::string with = " --robot " + robot;
  for (const std::string& command :
       {"plan " + map_ + kAround + with + " --json " + file("p.json"), "validate " + map_ + " --path " + file("p.json"),
        "validate " + map_ + " --path " + file("p.json") + with, "graph " + map_ + " --kind feasible" + with,
        "prepare " + map_ + with + " --out " + file("p.arcway"),
        "change " + file("p.arcway") + " --remove 0 --out " + file("q.arcway"),
        "generate convex --queries " + file("q.csv") + with})
    EXPECT_NE(run(command).out.find("are length and wheelbase swapped?"), std::string::npos) << command;
  EXPECT_EQ(run("prepare " + map_ + " --kind reduced --out " + file("p.arcway")).out.find("swapped"),
            std::string::npos);
}

TEST_F(Tool, APoseInCollisionNamesObstaclePlaceAndTheNearestFreePose) {
  const Run start = run("plan " + map_ + " --start 19.5,30,0 --goal 50,50,0");
  EXPECT_EQ(start.code, 1);
  EXPECT_NE(start.out.find("collides with obstacle 0 at (20, 30); the nearest free pose found is (18."),
            std::string::npos)
      << start.out;
  const Run goal = run("plan " + map_ + " --start 10,10,0 --goal 70,50,0");
  EXPECT_NE(goal.out.find("lies outside the bounds"), std::string::npos) << goal.out;
  EXPECT_NE(goal.out.find("no free pose was found within 3.4"), std::string::npos) << goal.out;
}

TEST_F(Tool, RefusesEmptyValues) {
  for (const char* option : {"--robot", "--svg", "--json", "--waypoint", "--time-limit", "--task"})
    expect_bad_input("plan " + map_ + kAround + " " + option + " ''", std::string(option) + ": its value is empty");
  expect_bad_input("plan ''", "WORLD: its value is empty");
  expect_bad_input("prepare " + map_ + " --out ''", "--out: its value is empty");
}

TEST_F(Tool, WritesNoFileTwice) {
  expect_bad_input("plan " + map_ + kAround + " --json " + file("p") + " --csv " + file("p"), "two files of this name");
  EXPECT_FALSE(exists("p"));
  EXPECT_EQ(run("plan " + map_ + kAround + " --json /dev/null --csv /dev/null").code, 0);
}

TEST_F(Tool, ReplacesNothingThatItHasRead) {
  const std::string message = "was read, and would be replaced by what is written";
  const std::string robot = put("r.json", R"({"format":"arcway-robot","version":1})");
  const std::string queries = put("q.csv", "q,sx,sy,stheta,gx,gy,gtheta\n0,10,10,0,50,50,0\n");
  const std::string before = read("r.json") + read("q.csv") + text_of(map_);
  for (const char* option : {"--json", "--csv", "--svg", "--ros-path"})
    expect_bad_input("plan " + map_ + kAround + " " + option + " " + map_, message);
  expect_bad_input("plan " + map_ + kAround + " --robot " + robot + " --json " + robot, message);
  expect_bad_input("plan " + map_ + " --queries " + queries + " --out " + file("o.csv") + " --json " + queries,
                   message);
  expect_bad_input("plan " + map_ + " --queries " + queries + " --out " + map_, message);
  expect_bad_input("graph " + map_ + " --json " + map_, message);
  expect_bad_input("prepare " + map_ + " --out " + map_, message);
  expect_bad_input("doctor " + map_ + " --json " + map_, message);
  expect_bad_input("convert " + map_ + " " + map_, message);
  const std::string wkt = put("x.wkt", "POLYGON((1 1, 2 1, 2 2, 1 1))");
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  expect_bad_input("change " + file("m.arcway") + " --add " + wkt + " --out " + wkt, message);
  EXPECT_EQ(read("x.wkt"), "POLYGON((1 1, 2 1, 2 2, 1 1))");
  fs::create_symlink(map_, file("link"));
  expect_bad_input("prepare " + map_ + " --out " + file("link"), message);
  EXPECT_EQ(read("r.json") + read("q.csv") + text_of(map_), before);
  expect_bad_input("generate star --out " + file("w.wkt"), "writes GeoJSON");
}

TEST_F(Tool, GeneratesDrivenWorldsWithTheirRobotAndDrive) {
  const std::string name = "driven/hugging/r4/g2/c20/s2";
  const std::string map = file("w.geojson"), robot = file("r.json"), drive = file("d.json");
  ASSERT_EQ(run("generate " + name + " --out " + map + " --robot-out " + robot + " --drive-out " + drive).code, 0);
  const Run check = run("validate " + map + " --path " + drive);
  EXPECT_EQ(check.code, 0) << check.out;
  EXPECT_NE(check.out.find("0.0200"), std::string::npos) << check.out;
  EXPECT_EQ(run("validate " + name + " --robot " + robot + " --path " + drive).code, 0);
  expect_bad_input("generate clutter/star --drive-out " + file("e.json"), "only worlds driven/... know a robot");
  expect_bad_input("generate convex --robot-out " + file("e.json"), "--robot-out");
  EXPECT_FALSE(exists("e.json"));
}

TEST_F(Tool, WarnsOfDegrees) {
  const Run plan = run("plan " + map_ + " --start 10,10,0 --goal 50,50,90");
  EXPECT_NE(plan.out.find("goal heading is 90 rad, more than a full turn: did you mean 90deg?"), std::string::npos)
      << plan.out;
  for (const char* heading : {"90deg", "3690deg"})
    EXPECT_EQ(run("plan " + map_ + " --start 10,10,0 --goal 50,50," + heading).out.find("full turn"), std::string::npos)
        << heading;
  const std::string queries = put("q.csv", "q,sx,sy,stheta,gx,gy,gtheta\n0,10,10,0,50,50,90\n1,10,10,45,50,50,0\n");
  const Run batch = run("plan " + map_ + " --queries " + queries + " --out " + file("r.csv"));
  EXPECT_NE(batch.out.find("q.csv:2: gtheta heading is 90 rad, more than a full turn: did you mean 90deg? 1 more of"),
            std::string::npos)
      << batch.out;
  const std::string map =
      put("ll.geojson", R"({"type":"Polygon","coordinates":[[[6,50],[6.001,50],[6.001,50.001],[6,50]]]})");
  EXPECT_NE(run("plan " + map + " --lonlat --start=-90,0,0 --goal=-90,40,0").out.find("meters from there"),
            std::string::npos);
  ASSERT_EQ(run("prepare " + map + " --lonlat --out " + file("ll.arcway")).code, 0);
  expect_bad_input("change " + file("ll.arcway") + " --add " + map + " --lonlat --out " + file("m.arcway"),
                   "projects each map around its own middle");
}

// Two buildings at the equator, 1.800 m apart on WGS 84 and 1.8101 m on a sphere of the same radius: too narrow for a
// body of 1.8 m. Where nothing bounds the map, the way leads around them; between walls there is none.
TEST_F(Tool, ProjectsGapsOnTheEllipsoid) {
  const auto box = [](const std::string& left, const std::string& low, const std::string& right,
                      const std::string& high) {
    const std::string first = "[" + left + "," + low + "]";
    return "[[" + first + ",[" + right + "," + low + "],[" + right + "," + high + "],[" + left + "," + high + "]," +
           first + "]]";
  };
  const auto feature = [](const std::string& role, const std::string& rings) {
    return R"({"type":"Feature","properties":{"role":")" + role + R"("},"geometry":{"type":"Polygon","coordinates":)" +
           rings + "}}";
  };
  const std::string west = "99.99991016847159", east = "100.00008983152841", gap = "0.000008139325293829634",
                    far = "0.00036174779083687265";
  const std::string buildings =
      feature("obstacle", box(west, gap, east, far)) + "," + feature("obstacle", box(west, "-" + far, east, "-" + gap));
  const std::string walls = feature("boundary", box("99.9995", "-0.0003", "100.0005", "0.0003"));
  const auto planned = [&](const std::string& features) {
    const std::string map = put("equator.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    const std::string car = put("car.json", R"({"format":"arcway-robot","version":1,"length":4.5,"width":1.8,)"
                                            R"("wheelbase":2.7,"max_steering_angle":0.55,"safety_margin":0.01})");
    return run("plan " + map + " --lonlat --robot " + car + " --start=-20,0,0 --goal 20,0,0").out;
  };
  const std::string around = planned(buildings);
  EXPECT_NE(around.find(": solved"), std::string::npos) << around;
  EXPECT_EQ(around.find("in 1 segments"), std::string::npos) << around;
  EXPECT_NE(planned(buildings + "," + walls).find(": no passage"), std::string::npos);
}

TEST_F(Tool, MapsOfWallsAloneAreNotEmpty) {
  const std::string walls = put("walls.geojson", R"({"type":"LineString","coordinates":[[30,0],[30,60]]})");
  expect_bad_input("plan " + walls + kAround, "line strings are walls (--wall-width)");
  expect_bad_input("doctor " + walls, "line strings are walls (--wall-width)");
  EXPECT_EQ(run("plan " + walls + kAround + " --wall-width 0.5").code, 0);
}

TEST_F(Tool, WritesZonesAsMasksOfFilters) {
  const auto zone = [](const std::string& properties, const std::string& ring) {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":"Polygon","coordinates":[)" +
           ring + "]}}";
  };
  const std::string map = put(
      "zones.geojson", R"({"type":"FeatureCollection","planar":{"unit":"m"},"features":[)" +
                           zone(R"("role":"keepout","name":"dock")", "[[2,2],[4,2],[4,3],[2,2]]") + "," +
                           zone(R"("role":"speed_limit","max_speed":0.5)", "[[8,0],[9,0],[9,1],[8,1],[8,0]]") + "]}");
  const Run keepout = run("convert " + map + " " + file("k.yaml") + " --filter-mask keepout --mask-resolution 0.5");
  ASSERT_EQ(keepout.code, 0) << keepout.err;
  EXPECT_NE(read("k_parameters.yaml").find("yaml_filename: \"k.yaml\""), std::string::npos);
  ASSERT_EQ(run("convert " + map_ + " " + file("k.geojson") + " --keepout-mask " + file("k.yaml")).code, 0);
  EXPECT_NE(read("k.geojson")
                .find(R"({"role":"keepout","name":"k"},"geometry":{"type":"Polygon","coordinates":)"
                      "[[[2,2],[4,2],[4,3],[3,3],[3,2.5],[2,2.5],[2,2]]]"),
            std::string::npos)
      << read("k.geojson");
  const Run speed = run("convert " + map + " " + file("s.yaml") + " --filter-mask speed");
  ASSERT_EQ(speed.code, 0) << speed.err;
  const std::string how = "--mask-type absolute --mask-base 0.5 --mask-multiplier 0";
  EXPECT_NE(speed.out.find(how), std::string::npos) << speed.out;
  ASSERT_EQ(run("convert " + map_ + " " + file("s.geojson") + " --speed-mask " + file("s.yaml") + " " + how).code, 0);
  EXPECT_NE(read("s.geojson").find(R"("max_speed":0.5})"), std::string::npos) << read("s.geojson");
  const Run none = run("convert " + map_ + " " + file("n.yaml") + " --filter-mask speed");
  EXPECT_NE(none.out.find("the map has no zone of the role speed_limit"), std::string::npos) << none.out;
  expect_bad_input("convert " + map + " " + file("x.yaml"), "--filter-mask: expected keepout or speed for OUT.yaml");
  expect_bad_input("convert " + map + " " + file("x.yaml") + " --filter-mask slow", "expected keepout or speed");
  expect_bad_input("convert " + map + " " + file("x.wkt") + " --filter-mask speed",
                   "OUT is a mask if its name ends in");
  expect_bad_input("convert " + map + " " + file("x.yaml") + " --filter-mask speed --mask-resolution 1e-6",
                   "give a resolution of at least");
  expect_bad_input("convert " + map + " " + file("x.yaml") + " --filter-mask speed --mask-resolution 0",
                   "resolution is 0 m, must be above 0");
}

TEST_F(Tool, ReadsMasksOfFiltersAsZones) {
  put("mask.pgm", "P2\n3 1\n255\n255 0 102\n");
  const std::string mask = put("mask.yaml",
                               "image: mask.pgm\nresolution: 2\norigin: [-8, -4, 0]\nnegate: 0\n"
                               "occupied_thresh: 1\nfree_thresh: 0\nmode: scale\n");
  const Run keepout = run("convert " + map_ + " " + file("k.geojson") + " --keepout-mask " + mask);
  ASSERT_EQ(keepout.code, 0) << keepout.err;
  EXPECT_NE(read("k.geojson")
                .find(R"({"role":"keepout","name":"mask"},"geometry":{"type":"Polygon","coordinates":)"
                      "[[[-6,-4],[-4,-4],[-4,-2],[-6,-2],[-6,-4]]]"),
            std::string::npos)
      << read("k.geojson");
  const std::string speeds = " --speed-mask " + mask + " --mask-base 100 --mask-multiplier -0.5";
  ASSERT_EQ(run("convert " + map_ + " " + file("s.geojson") + speeds + " --mask-max-speed 2").code, 0);
  for (const char* limit : {R"("max_speed":1})", R"("max_speed":1.4})"})
    EXPECT_NE(read("s.geojson").find(limit), std::string::npos) << read("s.geojson");
  ASSERT_EQ(run("convert " + map_ + " " + file("a.geojson") + speeds + " --mask-type absolute").code, 0);
  EXPECT_NE(read("a.geojson").find(R"("max_speed":70})"), std::string::npos) << read("a.geojson");
  EXPECT_EQ(run("plan " + map_ + kAround + " --keepout-mask " + mask).code, 0);
  expect_bad_input("plan " + map_ + kAround + speeds, "limits in percent need the robot's top speed, --mask-max-speed");
  expect_bad_input("plan " + map_ + kAround + speeds + " --mask-type knots", "expected percent or absolute, got");
  expect_bad_input("plan " + map_ + kAround + speeds + " --mask-max-speed 0", "--mask-max-speed: above 0, got");
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway") + " --keepout-mask " + mask).code, 0);
  expect_bad_input("plan " + file("m.arcway") + kAround + " --keepout-mask " + mask, "a prepared map has its zones");
}

TEST_F(Tool, SaysSoWhereStandardOutputCannotBeWritten) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  for (const std::string& arguments : {"plan " + map_ + kAround, std::string("plan --help")}) {
    const Run full = run_command("{ \"" ARCWAY_TOOL "\" " + arguments + " >/dev/full; }");
    EXPECT_EQ(full.code, 2);
    EXPECT_NE(full.err.find("cannot write standard output: No space left"), std::string::npos) << full.err;
  }
}

TEST_F(Tool, ConvertsMapsThere) {
  const std::string data = ARCWAY_SOURCE_DIR "/tests/data/";
  ASSERT_EQ(run("convert " + data + "room.yaml " + file("room.geojson")).code, 0);
  ASSERT_EQ(run("convert " + file("room.geojson") + " " + file("room.wkt")).code, 0);
  ASSERT_EQ(run("convert " + file("room.wkt") + " " + file("room2.wkt")).code, 0);
  EXPECT_EQ(read("room.wkt"), read("room2.wkt"));
  ASSERT_EQ(run("convert " + file("room.geojson") + " " + file("again.geojson")).code, 0);
  EXPECT_EQ(read("room.geojson"), read("again.geojson"));
  ASSERT_EQ(run("convert " + data + "parking_case.csv " + file("case.svg")).code, 0);
  EXPECT_NE(read("case.svg").find("id=\"obstacles\""), std::string::npos);
  expect_bad_input("convert " + map_ + " " + file("map.shp"), ".geojson");
}

TEST_F(Tool, PlansOnMapsOfAnyFormat) {
  const std::string data = ARCWAY_SOURCE_DIR "/tests/data/";
  const Run parking = run("plan " + data + "parking_case.csv --svg " + file("p.svg") + " --ros-path " + file("p.json"));
  EXPECT_EQ(parking.code, 0) << parking.err << parking.out;
  EXPECT_NE(read("p.svg").find("id=\"swept\""), std::string::npos);
  EXPECT_EQ(read("p.json").rfind(R"({"header":{"stamp":{"sec":0,"nanosec":0},"frame_id":"map"},"poses":[)", 0), 0u);
  const Run room = run("plan " + data + "room.yaml --tolerance 1 --start 0,2.5,0 --goal 4,6,180deg");
  EXPECT_EQ(room.code, 0) << room.err << room.out;
  EXPECT_NE(room.out.find("corners traced"), std::string::npos);
  const Run task = run("plan " + data + "rooms.map.scen --task 1 --goal 20.5,3.5,0");
  EXPECT_NE(task.out.find("(3.500, 3.500)"), std::string::npos) << task.err << task.out;
  expect_bad_input("plan " + data + "rooms.map.scen --task 2", "there is no task 2");
  expect_bad_input("plan " + map_ + kAround + " --unknown maybe", "--unknown");
  expect_bad_input("plan " + map_ + kAround + " --cell 0", "--cell");
}

TEST_F(Tool, RefinesCurvesNearThePath) {
  const std::string ponds = ARCWAY_SOURCE_DIR "/tests/data/ponds.svg";
  const std::string plan = "plan " + ponds + " --start 4,-26,0 --goal 36,-4,90deg --json " + file("p.json");
  const Run refined = run(plan);
  EXPECT_EQ(refined.code, 0) << refined.err << refined.out;
  EXPECT_NE(refined.out.find("near the path within 0.01 m; planned 4 times"), std::string::npos) << refined.out;
  EXPECT_EQ(run("validate " + ponds + " --path " + file("p.json")).code, 0);
  const Run finer = run(plan + " --curve-tolerance 0.001");
  EXPECT_NE(finer.out.find("near the path within 0.001 m"), std::string::npos) << finer.out;
  EXPECT_EQ(run("validate " + ponds + " --curve-tolerance 0.001 --path " + file("p.json")).code, 0);
}

TEST_F(Tool, DrawsTheLayersAskedFor) {
  const std::string plan = "plan " + map_ + kAround + " --svg " + file("p.svg");
  ASSERT_EQ(run(plan).code, 0);
  const std::string all = read("p.svg");
  EXPECT_NE(all.find("id=\"swept\""), std::string::npos);
  EXPECT_EQ(all.find("id=\"graph\""), std::string::npos);
  ASSERT_EQ(run(plan + " --svg-inset").code, 0);
  EXPECT_NE(read("p.svg").find(">the smallest clearance, "), std::string::npos);
  ASSERT_EQ(run(plan + " --svg-layers obstacles,graph --svg-view path").code, 0);
  const std::string graph = read("p.svg");
  EXPECT_NE(graph.find("id=\"graph\""), std::string::npos);
  EXPECT_EQ(graph.find("id=\"path\""), std::string::npos);
  expect_bad_input(plan + " --svg-layers walls", "--svg-layers");
  expect_bad_input(plan + " --svg-view goal", "--svg-view");
  for (const std::string option : {"--svg-view path", "--svg-layers path", "--svg-inset"}) {
    const std::string name = option.substr(0, option.find(' '));
    expect_bad_input("plan " + map_ + kAround + " " + option, name + " requires --svg");
  }
}

// tests/data/shared_poses.txt: what the tool, which checks every path that it finds, says of poses on real maps.
TEST_F(Tool, PlansOnRealMaps) {
  const char* shared = std::getenv("ARCWAY_SHARED_DATA");
  if (shared == nullptr || !fs::is_directory(shared)) GTEST_SKIP() << "ARCWAY_SHARED_DATA names no folder of maps";
  const bool all = std::getenv("ARCWAY_LONG_TESTS") != nullptr;
  const std::string data = ARCWAY_SOURCE_DIR "/tests/data/";
  constexpr std::string_view kLong = "long ";
  std::size_t plans = 0;
  for (std::string line : lines_of(text_of(data + "shared_poses.txt"))) {
    if (line.empty() || line.front() == '#') continue;
    SCOPED_TRACE(line);
    ++plans;
    if (line.starts_with(kLong)) {
      if (!all) continue;
      line.erase(0, kLong.size());
    }
    const std::size_t bar = line.find(" | ");
    ASSERT_NE(bar, std::string::npos);
    const std::string status = line.substr(0, bar);
    std::string arguments = line.substr(bar + 3);
    if (const std::size_t robot = arguments.find("--robot "); robot != std::string::npos)
      arguments.insert(robot + 8, data + "robots/");
    const Run result = run("plan " + std::string(shared) + "/" + arguments + " --time-limit 60 --svg " + file("p.svg"));
    EXPECT_EQ(result.code, status == "solved" ? 0 : 1) << result.err << result.out;
    EXPECT_NE(result.out.find(": " + status + "\n"), std::string::npos) << result.out;
    EXPECT_NE(read("p.svg").find("</svg>"), std::string::npos);
    EXPECT_EQ(status == "solved", read("p.svg").find("id=\"path\"") != std::string::npos);
  }
  EXPECT_EQ(plans, 52u);
}

TEST_F(Tool, GraphsOfABox) {
  ASSERT_EQ(run("graph " + map_ + " --kind reduced --edges " + file("e.csv") + " --json " + file("g.json")).code, 0);
  EXPECT_EQ(read("e.csv"), "u,v\n0,1\n0,3\n1,2\n2,3\n");
  EXPECT_NE(read("g.json").find("\"edges\":4"), std::string::npos);
  ASSERT_EQ(run("graph " + map_ + " --kind feasible --edges " + file("f.csv") + " --svg " + file("f.svg")).code, 0);
  const std::vector<std::string> bitangents = lines_of(read("f.csv"));
  ASSERT_FALSE(bitangents.empty());
  EXPECT_EQ(bitangents[0], "u,v");
  EXPECT_EQ(bitangents.size(), 9u);  // each edge of the box both ways
  EXPECT_EQ(run("graph " + map_ + " --kind visibility").code, 0);
}

TEST_F(Tool, GraphsAreRefusedWherePlansAre) {
  const std::string robot = put("r.json", R"({"format":"arcway-robot","version":1,"safety_margin":1e-9})");
  const std::string far = put("far.wkt", "POLYGON((1e6 0, 1000001 0, 1000001 1, 1e6 0))");
  for (const std::string& command :
       {"graph " + far + " --kind feasible", "prepare " + far + " --out " + file("m.arcway"),
        "plan " + far + " --start 0,0,0 --goal 9,0,0"})
    expect_bad_input(command + " --robot " + robot, "safety margin 1e-09 m is too small for coordinates up to 1000001");
  expect_bad_input("graph " + map_ + " --robot " + robot, "--robot: only with --kind feasible");
}

TEST_F(Tool, TakesNamesOfTheCatalogWhereNoSuchFileExists) {
  const std::string name = "clutter/convex/n20/f10/s3";
  const std::string made = "generate " + name + " --out " + file("w.geojson") + " --queries " + file("q.csv");
  ASSERT_EQ(run(made + " --count 5").code, 0) << read("stderr");
  EXPECT_EQ(lines_of(read("q.csv")).size(), 7u);
  for (const std::string& world : {name, file("w.geojson")}) {
    const Run batch = run("plan " + world + " --queries " + file("q.csv") + " --out " + file("r.csv"));
    EXPECT_EQ(batch.code, 0) << batch.err;
    EXPECT_NE(batch.out.find("of 5 solved"), std::string::npos) << batch.out;
    EXPECT_EQ(run("graph " + world + " --edges " + file("e.csv")).code, 0);
    EXPECT_GT(lines_of(read("e.csv")).size(), 100u);
  }
  expect_bad_input("plan clutter/cube/n20 --start 1,1,0 --goal 2,2,0", "unknown kind \"cube\"");
  expect_bad_input("generate clutter/star --seed 3 --out " + file("w.geojson"), "--seed");
  expect_bad_input("generate clutter/star", "--out");
}

TEST_F(Tool, TheDoctorExaminesMapsThatPlanningRefuses) {
  const std::string bow_tie =
      put("bow.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[40,40],[40,40],[40,0],[0,40],[0,0]]]})");
  const Run sick = run("doctor " + bow_tie + " --json " + file("d.json"));
  EXPECT_EQ(sick.code, 1);
  for (const char* text : {"REFUSED", "self-crossing: 1; the map is refused", "repeated vertex: 1", "at (20, 20)"})
    EXPECT_NE(sick.out.find(text), std::string::npos) << text << "\n" << sick.out;
  EXPECT_NE(read("d.json").find(R"("kind":"repeated vertex","place":"geometry, vertex 2","at":[40.0,40.0])"),
            std::string::npos)
      << read("d.json");
  const Run repair = run("doctor " + bow_tie + " --repair " + file("clean.geojson"));
  if (repair.code == 2) {
    EXPECT_NE(repair.err.find("built without"), std::string::npos);
  } else {
    EXPECT_EQ(repair.code, 1);  // of the map that was given
    EXPECT_EQ(run("doctor " + file("clean.geojson")).code, 0);
    EXPECT_EQ(run("graph " + file("clean.geojson")).code, 0);
  }
  const Run far = run("doctor " + put("far.geojson", R"({"type":"Polygon","coordinates":)"
                                                     R"([[[1e15,0],[1.000001e15,0],[1e15,1e9],[1e15,0]]]})"));
  EXPECT_EQ(far.code, 1);
  EXPECT_NE(far.out.find("move the map to the origin"), std::string::npos) << far.out;
  EXPECT_EQ(run("doctor " + map_).code, 0);
  EXPECT_NE(run("doctor " + map_).out.find("nothing found"), std::string::npos);
}

TEST_F(Tool, GenerateGivesTheSameMapForTheSameSeed) {
  const std::string kind = "generate star --obstacles 12 --vertices 7 --fill 0.2 --seed 5 --out ";
  ASSERT_EQ(run(kind + file("a.geojson")).code, 0);
  ASSERT_EQ(run(kind + file("b.geojson")).code, 0);
  EXPECT_EQ(read("a.geojson"), read("b.geojson"));
  EXPECT_EQ(run("graph " + file("a.geojson")).code, 0);
}

TEST_F(Tool, ExplainsACommandByHelp) {
  for (const char* command : {"plan", "graph", "generate", "validate", "doctor", "convert", "bench", "report"}) {
    const Run help = run(std::string("help ") + command);
    EXPECT_EQ(help.code, 0) << help.err;
    EXPECT_EQ(help.out, run(std::string(command) + " --help").out);
  }
  EXPECT_EQ(run("help").out, run("--help").out);
  expect_bad_input("help plna", "did you mean plan?");
}

TEST_F(Tool, WritesItsManualPageAndCompletions) {
  const Run man = run("help --man");
  EXPECT_EQ(man.code, 0) << man.err;
  EXPECT_EQ(man.out.rfind(".TH ARCWAY 1\n", 0), 0u);
  const Run bash = run("help --bash"), zsh = run("help --zsh");
  for (const char* word : {"plan", "validate", "generate"}) {
    EXPECT_NE(man.out.find(std::string(".SH \"arcway ") + word), std::string::npos) << word;
    EXPECT_NE(bash.out.find(std::string("    ") + word + ") options=\""), std::string::npos) << word;
    EXPECT_NE(zsh.out.find(std::string("    ") + word + ")\n"), std::string::npos) << word;
  }
  // Every option that --help names.
  const std::string help = run("plan --help").out;
  for (const char* option : {"--waypoint", "--json", "--time-limit", "--add", "--quiet", "--lonlat"}) {
    EXPECT_NE(help.find(option), std::string::npos) << option;
    EXPECT_NE(bash.out.find(option), std::string::npos) << option;
    EXPECT_NE(zsh.out.find(option), std::string::npos) << option;
    std::string escaped;
    for (const char c : std::string_view(option)) escaped += c == '-' ? "\\-" : std::string(1, c);
    EXPECT_NE(man.out.find(escaped), std::string::npos) << option;
  }
  put("completion.bash", bash.out);
  const Run words = run_command("bash -c 'source \"" + file("completion.bash") +
                                "\"; COMP_WORDS=(arcway plan --way); COMP_CWORD=2; _arcway; echo \"${COMPREPLY[@]}\"'");
  EXPECT_EQ(words.out, "--waypoint\n") << words.err;
  const Run commands = run_command("bash -c 'source \"" + file("completion.bash") +
                                   "\"; COMP_WORDS=(arcway va); COMP_CWORD=1; _arcway; echo \"${COMPREPLY[@]}\"'");
  EXPECT_EQ(commands.out, "validate\n") << commands.err;
}

TEST_F(Tool, PrintsNothingIfQuiet) {
  const Run result = run("plan " + map_ + kAround + " --quiet");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out + result.err, "");
  const Run none = run("plan " + map_ + " --start 30,30,0 --goal 50,50,0 -q");
  EXPECT_EQ(none.code, 1);
  EXPECT_EQ(none.out + none.err, "");
  expect_bad_input("plan nowhere.geojson --quiet", "nowhere.geojson");
}

TEST_F(Tool, ReadsStandardInputAndWritesStandardOutput) {
  const std::string tool = "\"" ARCWAY_TOOL "\" ";
  ASSERT_EQ(run("plan " + map_ + kAround + " --json " + file("p.json") + " --csv " + file("p.csv")).code, 0);
  const Run piped = run_command("cat " + map_ + " | " + tool + "plan - --csv -" + kAround);
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(piped.out, read("p.csv"));
  EXPECT_NE(piped.err.find("travel time"), std::string::npos);
  EXPECT_NE(piped.err.find("wrote               standard output"), std::string::npos) << piped.err;
  const Run chain =
      run_command(tool + "plan " + map_ + kAround + " --json - --quiet | " + tool + "validate " + map_ + " --path -");
  EXPECT_EQ(chain.code, 0) << chain.err << chain.out;
  EXPECT_NE(chain.out.find("-: valid\n"), std::string::npos) << chain.out;
  const Run wrong = run_command("echo nonsense | " + tool + "plan - --start 1,1,0 --goal 2,2,0");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("standard input"), std::string::npos) << wrong.err;
  EXPECT_EQ(wrong.err.find("/proc/"), std::string::npos) << wrong.err;
  expect_bad_input("validate - --path -", "both are standard input");
  // A prepared map is told by its first bytes.
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  EXPECT_EQ(run_command(tool + "plan - " + kAround + " <" + file("m.arcway")).code, 0);
}

TEST_F(Tool, ValidatesWhatItWritesAsSamples) {
  for (const std::string& how : {std::string(kAround), std::string(" --start 10,10,0 --goal 10,14,180deg --reverse")}) {
    ASSERT_EQ(run("plan " + map_ + how + " --csv " + file("p.csv") + " --ros-path " + file("r.json")).code, 0);
    for (const char* name : {"p.csv", "r.json"}) {
      const Run check = run("validate " + map_ + " --path " + file(name));
      EXPECT_EQ(check.code, 0) << name << how << "\n" << check.out << check.err;
    }
  }
  // Without units in the header, and with a sample that lies beside the path.
  std::string csv = read("p.csv");
  const std::string rows = csv.substr(csv.find('\n'));
  put("old.csv", "s,x,y,yaw,curvature,direction,t,v,steer" + rows);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("old.csv")).code, 0);
  std::vector<std::string> lines = lines_of(csv);
  const std::size_t x = lines[4].find(',') + 1;
  lines[4].insert(x, "1");
  std::string moved;
  for (const std::string& line : lines) moved += line + "\n";
  put("moved.csv", moved);
  const Run bad = run("validate " + map_ + " --path " + file("moved.csv"));
  EXPECT_EQ(bad.code, 1) << bad.out;
  EXPECT_NE(bad.out.find("position jump"), std::string::npos) << bad.out;
  put("bad.csv", "s,x,y,yaw,curvature,direction,t,v,steer\n0,1,2,zero,0,1,0,0,0\n");
  expect_bad_input("validate " + map_ + " --path " + file("bad.csv"), "bad.csv:2: yaw_rad: expected a number, found");
}

TEST_F(Tool, AddsObstaclesOfAnotherMap) {
  put("wall.wkt", "POLYGON ((0 25, 20 25, 20 30, 0 30, 0 25))");
  const std::string plan = " --start 10,10,0 --goal 10,50,90deg";
  const auto time_of = [&](const std::string& arguments) {
    const Run result = run("plan " + arguments);
    EXPECT_EQ(result.code, 0) << arguments << result.out << result.err;
    const std::size_t at = result.out.find("travel time");
    return result.out.substr(at, result.out.find('\n', at) - at);
  };
  const std::string without = time_of(map_ + plan), with = time_of(map_ + plan + " --add " + file("wall.wkt"));
  EXPECT_NE(with, without);
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("m.arcway")).code, 0);
  EXPECT_EQ(time_of(file("m.arcway") + plan + " --add " + file("wall.wkt")), with);
  EXPECT_EQ(run("plan " + map_ + plan + " --add " + file("wall.wkt") + " --json " + file("wall.wkt")).code, 2);
  expect_bad_input("plan " + map_ + plan + " --lonlat --add " + file("wall.wkt"), "--lonlat projects each map");
}

TEST_F(Tool, GeneratesQueriesForAnyMap) {
  const Run made = run("generate " + map_ + " --queries " + file("q.csv") + " --count 5");
  ASSERT_EQ(made.code, 0) << made.err;
  const std::vector<std::string> lines = lines_of(read("q.csv"));
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[1], "q,sx_m,sy_m,stheta_rad,gx_m,gy_m,gtheta_rad");
  EXPECT_EQ(run("plan " + map_ + " --queries " + file("q.csv") + " --out " + file("r.csv")).code, 0);
  expect_bad_input("generate " + map_ + " --out " + file("w.geojson"), "is a map already");
}

TEST_F(Tool, KeepsFinishedQueriesWhenInterrupted) {
  ASSERT_EQ(run("generate " + map_ + " --queries " + file("q.csv") + " --count 50000").code, 0);
  // How long the first row takes depends on the machine; 50,000 take far longer on any.
  std::vector<std::string> lines;
  for (const char* seconds : {"3", "12", "48"}) {
    const Run result =
        run_command("timeout --preserve-status -s INT " + std::string(seconds) + " \"" ARCWAY_TOOL "\" plan " + map_ +
                    " --queries " + file("q.csv") + " --out " + file("r.csv"));
    EXPECT_EQ(result.code, 130) << result.err << result.out;
    lines = lines_of(read("r.csv"));
    if (lines.size() > 3) break;
  }
  ASSERT_GT(lines.size(), 3u);
  EXPECT_LT(lines.size(), 20000u);
  EXPECT_EQ(lines[2].rfind("# interrupted: ", 0), 0u) << lines[2];
  EXPECT_EQ(count_of(read("r.csv"), '\n') - 3, lines.size() - 3);
  for (std::size_t i = 3; i < lines.size(); ++i) EXPECT_EQ(lines[i].find("canceled"), std::string::npos) << lines[i];
}

}  // namespace
