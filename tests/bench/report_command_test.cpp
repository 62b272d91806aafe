#include <gtest/gtest.h>

#include <string>

#include "tests/support/tool.h"

namespace arcway::internal {
namespace {

using test::Tool;

std::string results(int edges) {
  return R"({"context":{"processor":"P","commit":"c)" + std::to_string(edges) +
         R"("},"benchmarks":[{"name":"Graph/n:10","real_time":1,"cpu_time":1,"edges":)" + std::to_string(edges) + "}]}";
}

TEST_F(Tool, GateFailsWhereACountRose) {
  const std::string old_file = put("old.json", results(100)), new_file = put("new.json", results(110));
  const Run same = run("report " + old_file + " " + old_file + " --gate");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_NE(same.out.find("Nothing rose beyond its limit."), std::string::npos) << same.out;
  const Run rose = run("report " + old_file + " " + new_file + " --gate");
  EXPECT_EQ(rose.code, 1) << rose.err;
  EXPECT_NE(rose.out.find("Old: old.json, commit c100, on P\nNew: new.json, commit c110, on P\n"), std::string::npos)
      << rose.out;
  EXPECT_NE(rose.out.find("| Graph/n:10 | edges | 100 | 110 | 1.100 | count, at most +5 % |"), std::string::npos)
      << rose.out;
  EXPECT_EQ(run("report " + new_file + " " + old_file + " --gate").code, 0);
  EXPECT_EQ(run("report " + old_file + " " + new_file + " --gate --gate-counts 10.5%").code, 0);
  const Run both = run("report " + old_file + " " + new_file + " --gate --out " + file("out"));
  EXPECT_EQ(both.code, 1) << both.err;
  EXPECT_TRUE(exists("out/report.html"));
}

TEST_F(Tool, GateSaysWhatIsWrongWithItsLimits) {
  const std::string two = "report " + put("old.json", results(100)) + " " + put("new.json", results(110));
  expect_bad_input(two + " --gate --gate-counts 5", "--gate-counts: expected a percentage such as 5%, got \"5\"");
  expect_bad_input(two + " --gate --gate-counts -1%", "--gate-counts: at least 0%");
  expect_bad_input(two + " --gate --gate-counts x%", "--gate-counts: expected a finite number");
  expect_bad_input(two + " --gate --gate-times 0.9", "--gate-times: a factor of at least 1, got \"0.9\"");
  expect_bad_input(two + " --gate-times 2", "--gate-times: only with --gate");
  expect_bad_input(two, "--gate");
  expect_bad_input("report " + file("old.json") + " --gate", "--gate: needs two files of arcway_bench, OLD and NEW");
}

}  // namespace
}  // namespace arcway::internal
