#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/report/results.h"
#include "tests/support/json_schema.h"
#include "tests/support/tool.h"

namespace arcway::internal {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using test::Tool;

/// The tool's command `bench`; skipped where it was built without Google Benchmark, which it must say.
class BenchCommand : public Tool {
 protected:
  void SetUp() override {
    Tool::SetUp();
    const Run none = run("bench " + map_ + " --queries 0");
    ASSERT_EQ(none.code, 2);
    if (none.err.find("built without Google Benchmark; install it (Debian: libbenchmark-dev)") != std::string::npos)
      GTEST_SKIP() << none.err;
    robot_ = put("small.json", R"({"format":"arcway-robot","version":1,"length":0.8,"width":0.5,"wheelbase":0.5})");
  }

  [[nodiscard]] report::Results results_in(const std::string& folder) const {
    return report::read_results(read(folder + "/results.json"), "results.json");
  }
  static std::vector<std::string> names_of(const report::Results& results) {
    std::vector<std::string> names;
    for (const report::Measurement& m : results.measurements) names.push_back(m.name);
    return names;
  }
  void expect_refused(const std::string& arguments, const std::string& message) const {
    expect_bad_input("bench " + arguments + " --out " + file("none"), message);
    EXPECT_FALSE(exists("none")) << arguments;
  }

  std::string robot_;
};

TEST_F(BenchCommand, MeasuresEveryRobotOnEveryMap) {
  put("two.wkt", "MULTIPOLYGON (((0 0, 5 0, 5 5, 0 5, 0 0)), ((45 45, 50 45, 50 50, 45 50, 45 45)))");
  const Run result = run("bench " + map_ + " " + file("two.wkt") + " --robot " + robot_ + " --robot " +
                         ARCWAY_SOURCE_DIR "/bench/robots/car.json --queries 3 --repetitions 2 --out " + file("out"));
  ASSERT_EQ(result.code, 0) << result.err << result.out;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("- small on box: 3 of 3 queries are solved, and the validator takes every path. "),
            std::string::npos)
      << result.out;
  const report::Results results = results_in("out");
  EXPECT_EQ(names_of(results),
            (std::vector<std::string>{"ReducedGraph/box", "FeasibleGraph/small/box", "PlanFirst/small/box",
                                      "RealMap/small/box/prepared", "FeasibleGraph/car/box", "PlanFirst/car/box",
                                      "RealMap/car/box/prepared", "ReducedGraph/two", "FeasibleGraph/small/two",
                                      "PlanFirst/small/two", "RealMap/small/two/prepared", "FeasibleGraph/car/two",
                                      "PlanFirst/car/two", "RealMap/car/two/prepared"}));
  for (const report::Measurement& m : results.measurements) EXPECT_EQ(m.cpu_seconds.size(), 2u) << m.name;
  EXPECT_EQ(results.measurements[0].counters.at("edges"), 4.0);
  EXPECT_EQ(results.measurements[3].counters.at("queries"), 3.0);
  for (const char* counter : {"search_seconds_median", "refine_seconds_median", "time_over_bound_median",
                              "expansions_per_query", "trials_per_query"})
    EXPECT_TRUE(results.measurements[3].counters.contains(counter)) << counter;
  const std::string report = read("out/report.md");
  EXPECT_NE(report.find("## What planning costs on each map"), std::string::npos);
  EXPECT_NE(report.find("| small | two | 8 |"), std::string::npos) << report;
  EXPECT_NE(report.find("| small | box | 3 of 3 | 0 | 0 | 0 |"), std::string::npos) << report;
  EXPECT_EQ(report.find("clutters"), std::string::npos) << report;
  EXPECT_TRUE(exists("out/report.html") && exists("out/report.csv"));
  // Counts of two runs are equal, so that a gate can compare them.
  EXPECT_EQ(run("report " + file("out/results.json") + " " + file("out/results.json") + " --gate").code, 0);
}

TEST_F(BenchCommand, WritesWhatOthersReadOfGoogleBenchmark) {
  ASSERT_EQ(run("bench " + map_ + " --queries 2 --repetitions 2 --out " + file("out")).code, 0);
  const json document = json::parse(read("out/results.json"));
  EXPECT_TRUE(document["context"]["caches"].is_array());  // Bencher
  EXPECT_FALSE(document["context"].contains("host_name"));
  ASSERT_EQ(document["benchmarks"].size(), 8u);
  for (const json& one : document["benchmarks"]) {
    for (const char* key : {"name", "run_name", "run_type", "time_unit"}) EXPECT_TRUE(one[key].is_string()) << key;
    for (const char* key : {"repetitions", "repetition_index", "threads", "iterations", "real_time", "cpu_time"})
      EXPECT_TRUE(one[key].is_number()) << key;
  }
  EXPECT_EQ(document["benchmarks"][1]["repetition_index"], 1);
}

TEST_F(BenchCommand, TakesWhatAScenarioSays) {
  fs::create_directories(file("study"));
  fs::copy(map_, file("study/field.geojson"));
  fs::copy(robot_, file("study/small.json"));
  put("study/q.csv", "q,sx_m,sy_m,stheta_rad,gx_m,gy_m,gtheta_rad\n3,5,5,0,50,50,0\n4,5,5,0,5,50,90deg\n");
  const json scenario = {{"format", "arcway-benchmark"},
                         {"version", 1},
                         {"maps", {"field.geojson", "clutter/convex/n5"}},
                         {"robots", {"small.json", {{"format", "arcway-robot"}, {"version", 1}, {"length", 0.9}}}},
                         {"queries", 3},
                         {"seed", 7},
                         {"reverse", true},
                         {"time_limit", 20},
                         {"repetitions", 1},
                         {"peer_time", 0}};
  const json schema = json::parse(test::text_of(ARCWAY_SOURCE_DIR "/datasets/schemas/benchmark.schema.json"));
  EXPECT_EQ(test::broken_rule(schema, scenario), "");
  for (const auto& [key, rule] : schema["properties"].items()) EXPECT_TRUE(scenario.contains(key)) << key;
  const std::string path = put("study/s.json", scenario.dump());
  const Run result = run_command("cd / && \"" ARCWAY_TOOL "\" bench " + path + " --out " + file("out"));
  ASSERT_EQ(result.code, 0) << result.err;
  const report::Results results = results_in("out");
  const std::vector<std::string> names = names_of(results);
  ASSERT_EQ(names.size(), 14u);
  EXPECT_EQ(names[3], "RealMap/small/field/prepared");
  EXPECT_EQ(names[13], "RealMap/robot2/clutter/convex/n5/prepared");
  EXPECT_EQ(results.measurements[3].cpu_seconds.size(), 1u);
  EXPECT_EQ(results.measurements[3].counters.at("queries"), 3.0);

  json by_file = {{"format", "arcway-benchmark"}, {"version", 1}, {"maps", {"field.geojson"}}, {"queries", "q.csv"}};
  EXPECT_EQ(test::broken_rule(schema, by_file), "");
  ASSERT_EQ(run("bench " + put("study/s.json", by_file.dump()) + " --out " + file("out")).code, 0);
  EXPECT_EQ(results_in("out").measurements.back().name, "RealMap/paper/field/prepared");
  EXPECT_EQ(results_in("out").measurements.back().counters.at("queries"), 2.0);
  EXPECT_EQ(results_in("out").measurements.back().cpu_seconds.size(), 5u);
  expect_refused(path + " --queries 3", "--queries: only with maps; " + path + " says it all");
  expect_bad_input("plan " + put("s.json", scenario.dump()) + test::kAround,
                   "of the format arcway-benchmark, not a map");
}

TEST_F(BenchCommand, PlansAsItsOptionsSay) {
  const auto plans = [&](const std::string& options) {
    const Run result = run("bench " + map_ + " --repetitions 1 --out " + file("out") + " " + options);
    EXPECT_EQ(result.code, 0) << options << result.err;
    return results_in("out").measurements.back().counters;
  };
  const std::string behind = " --queries " + put("b.csv", "q,sx,sy,stheta,gx,gy,gtheta\n0,15,10,0,10,10,0\n");
  EXPECT_GT(plans(behind)["time_over_bound_median"], 1.1);
  EXPECT_LT(plans(behind + " --reverse")["time_over_bound_median"], 1.01);
  const std::string sixth = put("six.csv",
                                "q,sx,sy,stheta,gx,gy,gtheta\n0,5,5,0,50,50,0\n1,5,5,0,5,50,0\n2,5,5,0,50,5,0\n"
                                "3,5,5,0,50,50,1\n4,5,5,0,5,50,1\n5,5,5,0,50,5,1\n");
  EXPECT_EQ(plans("--queries " + sixth)["queries"], 6.0);
  EXPECT_EQ(results_in("out").measurements[2].counters["queries"], 5.0);  // from the bare map the first ones
  const auto limited = plans("--time-limit 1e-9 --queries " + sixth);
  EXPECT_EQ(limited.at("time_limit"), 6.0);
  EXPECT_FALSE(limited.contains("time_over_bound_median"));
  const auto first = plans("--queries 4"), again = plans("--queries 4 --seed 1"), other = plans("--queries 4 --seed 2");
  EXPECT_EQ(first.at("expansions_per_query"), again.at("expansions_per_query"));
  EXPECT_EQ(first.at("trials_per_query"), again.at("trials_per_query"));
  EXPECT_NE(first.at("time_over_bound_median"), other.at("time_over_bound_median"));
}

TEST_F(BenchCommand, RefusesWhatTheSchemaRefuses) {
  const json schema = json::parse(test::text_of(ARCWAY_SOURCE_DIR "/datasets/schemas/benchmark.schema.json"));
  const json right = {{"format", "arcway-benchmark"}, {"version", 1}, {"maps", {"box.geojson"}}, {"repetitions", 1}};
  const auto refuse = [&](const json& patch, const std::string& message) {
    json wrong = right;
    wrong.merge_patch(patch);
    EXPECT_NE(test::broken_rule(schema, wrong), "") << patch;
    expect_refused(put("s.json", wrong.dump()), message);
  };
  refuse({{"maps", nullptr}}, "missing key \"maps\"");
  refuse({{"maps", json::array()}}, "s.json: maps: names no map");
  refuse({{"maps", "box.geojson"}}, "s.json: maps: expected an array");
  refuse({{"version", 2}}, "version: expected 1, found 2");
  refuse({{"robot", "small.json"}}, "unknown key \"robot\", did you mean \"robots\"?");
  refuse({{"robots", {3}}}, "robots[0]: expected a robot or the name of its file, found 3");
  refuse({{"robots", {{{"length", 1}, {"wheels", 4}}}}}, "wheels");
  refuse({{"queries", 0}}, "--queries: at least 1");
  refuse({{"queries", 2.5}}, "queries: expected a whole number");
  refuse({{"seed", -1}}, "seed: expected a whole number");
  refuse({{"reverse", 1}}, "reverse: expected true or false");
  refuse({{"time_limit", -1}}, "--time-limit: above 0 s");
  refuse({{"repetitions", 0}}, "--repetitions: 1 to 1000");
  refuse({{"peer_time", "long"}}, "peer_time: expected a number");
}

TEST_F(BenchCommand, RefusesBadInputBeforeItMeasures) {
  expect_refused(file("nowhere.geojson"), "cannot read " + file("nowhere.geojson"));
  expect_refused(map_ + " --robot " + map_, "box.geojson");
  expect_refused(map_ + " --robot " + put("r.json", R"({"format":"arcway-robot","version":1,"length":-1})"), "length");
  expect_refused(map_ + " --queries none.csv", "none.csv");
  expect_refused(map_ + " --queries " + put("e.csv", "q,sx,sy,stheta,gx,gy,gtheta\n"), "e.csv has no queries");
  const std::string queries =
      put("q.csv", "q,sx,sy,stheta,gx,gy,gtheta\n0,5,5,0,50,50,0\n7,5,5,0,30,30,0\n9,5,5,0,50,50,0\n");
  expect_refused(map_ + " --queries " + queries,
                 "box for paper: query 7 of " + queries +
                     ": the goal (30, 30, 0): the body, grown by half of the safety margin, collides with obstacle 0");
  expect_refused(map_ + " --robot " +
                     put("long.json", R"({"format":"arcway-robot","version":1,"length":100,)"
                                      R"("wheelbase":50})"),
                 "box for long: random queries: no free pair");
  const Run warned =
      run("bench " + map_ + " --queries 1 --repetitions 1 --robot " +
          put("w.json", R"({"format":"arcway-robot","version":1,"wheelbase":9})") + " --out " + file("warned"));
  EXPECT_NE(warned.out.find("are length and wheelbase swapped?"), std::string::npos) << warned.out << warned.err;
  expect_refused(map_ + " --repetitions 0", "--repetitions: 1 to 1000, got \"0\"");
  expect_refused(map_ + " --time-limit 0", "--time-limit: above 0 s, got \"0\"");
  expect_refused(map_ + " --seed x", "--seed: expected a whole number");
  expect_bad_input("bench " + map_ + " --queries 1 --out " + map_, "cannot make folder " + map_);
}

TEST_F(BenchCommand, KeepsWhatWasFinishedBeforeAnInterruption) {
  const std::string tool = "\"" ARCWAY_TOOL "\" bench " + map_ + " --queries 5 --repetitions 1000 --out " + file("out");
  // `timeout` sends its signal to the tool and to the tool's group; they count as one, as do two of the same moment.
  for (const std::string& command : {"timeout --preserve-status -s INT 3 " + tool,
                                     "(" + tool + " & sleep 3; kill -TERM $!; kill -TERM $!; wait $!)"}) {
    const Run result = run_command(command);
    EXPECT_EQ(result.code, 130) << result.err << result.out;
    EXPECT_NE(result.out.find("interrupted"), std::string::npos) << result.out;
    const report::Results results = results_in("out");
    ASSERT_EQ(results.measurements.size(), 1u);  // the first benchmark alone takes 100 s
    EXPECT_EQ(results.measurements[0].error, "");
    EXPECT_GT(results.measurements[0].cpu_seconds.size(), 1u);
    EXPECT_LT(results.measurements[0].cpu_seconds.size(), 100u);
    EXPECT_TRUE(exists("out/report.html"));
    fs::remove_all(file("out"));
  }
}

}  // namespace
}  // namespace arcway::internal
