#include <gtest/gtest.h>

#include <string>

#include "tests/support/tool.h"

namespace {

using arcway::internal::test::kAround;
using arcway::internal::test::text_of;
using arcway::internal::test::Tool;
using arcway::internal::test::without_times;

// A file of before has the links of before. Headings may differ in the last place where sines do.
TEST_F(Tool, PreparesTheSmallMapThatIsKept) {
  const std::string yard = ARCWAY_SOURCE_DIR "/tests/data/yard";
  ASSERT_EQ(run("prepare " + yard + ".geojson --out " + file("y.arcway")).code, 0);
  EXPECT_EQ(read("y.arcway").size(), text_of(yard + ".arcway").size()) << "make it anew, as tests/data/README.md says";
}

TEST_F(Tool, PlansOnAPreparedMapAsOnTheMap) {
  ASSERT_EQ(run("generate clutter/star/n30/m6/f20/s3 --out " + file("w.geojson") + " --queries " + file("q.csv")).code,
            0);
  const Run prepared = run("prepare " + file("w.geojson") + " --out " + file("w.arcway"));
  ASSERT_EQ(prepared.code, 0) << prepared.err;
  EXPECT_EQ(prepared.err, "");  // no bar where nobody watches
  EXPECT_NE(prepared.out.find("directed bitangents"), std::string::npos);
  ASSERT_EQ(run("prepare " + file("w.geojson") + " --kind reduced --out " + file("r.arcway")).code, 0);
  EXPECT_LT(read("r.arcway").size(), read("w.arcway").size());

  const std::string batch = " --queries " + file("q.csv") + " --out ";
  ASSERT_EQ(run("plan " + file("w.geojson") + batch + file("expected.csv")).code, 0);
  for (const std::string map : {"w.arcway", "r.arcway"}) {
    const Run plan = run("plan " + file(map) + batch + file(map + ".csv"));
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(plan.out.find("prepared, "), std::string::npos) << plan.out;
    EXPECT_EQ(without_times(read(map + ".csv")), without_times(read("expected.csv")));
  }

  // Another robot than the one that the file is for: its graph is checked anew.
  const std::string robot = put("robot.json", R"({"format":"arcway-robot","version":1,"width":0.5})");
  ASSERT_EQ(run("plan " + file("w.geojson") + " --robot " + robot + batch + file("expected.csv")).code, 0);
  ASSERT_EQ(run("plan " + file("w.arcway") + " --robot " + robot + batch + file("r.csv")).code, 0);
  EXPECT_EQ(without_times(read("r.csv")), without_times(read("expected.csv")));
}

TEST_F(Tool, APreparedMapIsAMapForEveryCommand) {
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("box.arcway")).code, 0);
  EXPECT_EQ(run("plan " + file("box.arcway") + kAround + " --json " + file("p.json")).code, 0);
  EXPECT_EQ(run("validate " + file("box.arcway") + " --path " + file("p.json")).code, 0);
  EXPECT_EQ(run("doctor " + file("box.arcway")).code, 0);
  ASSERT_EQ(run("convert " + map_ + " " + file("a.geojson")).code, 0);
  ASSERT_EQ(run("convert " + file("box.arcway") + " " + file("b.geojson")).code, 0);
  EXPECT_EQ(read("a.geojson"), read("b.geojson"));
  const Run again = run("prepare " + file("box.arcway") + " --out " + file("again.arcway"));
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_NE(again.out.find("built by            prepared, "), std::string::npos) << again.out;
  EXPECT_EQ(read("again.arcway"), read("box.arcway"));
}

TEST_F(Tool, TheRobotOfAPreparedMapIsTheDefaultOfEveryCommand) {
  const std::string robot = put("robot.json", R"({"format":"arcway-robot","version":1,"width":2,"max_speed":20})");
  ASSERT_EQ(run("prepare " + map_ + " --robot " + robot + " --out " + file("w.arcway")).code, 0);
  ASSERT_EQ(run("plan " + file("w.arcway") + kAround + " --json " + file("p.json")).code, 0);
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 0);
  std::string plan = read("p.json");
  const std::size_t begin = plan.find("\"robot\":"), end = plan.find("\"start\":");
  put("p.json", plan.erase(begin, end - begin));
  EXPECT_EQ(run("validate " + map_ + " --path " + file("p.json")).code, 1);  // too fast for the paper's
  EXPECT_EQ(run("validate " + file("w.arcway") + " --path " + file("p.json")).code, 0);
  ASSERT_EQ(run("prepare " + file("w.arcway") + " --out " + file("again.arcway")).code, 0);
  EXPECT_EQ(read("again.arcway"), read("w.arcway"));
  ASSERT_EQ(run("graph " + map_ + " --kind feasible --robot " + robot + " --svg " + file("a.svg")).code, 0);
  ASSERT_EQ(run("graph " + file("w.arcway") + " --kind feasible --svg " + file("b.svg")).code, 0);
  EXPECT_EQ(read("a.svg"), read("b.svg"));
}

TEST_F(Tool, PreparesTheSameBytesWhateverBuildsTheGraphs) {
  const std::string prepare = "prepare clutter/star/n20/m6/f20/s3 --out ";
  ASSERT_EQ(run(prepare + file("expected")).code, 0);
  for (const std::string options : {"--threads 1", "--threads 3", "--backend reference", "--builder pairwise"}) {
    const Run other = run(prepare + file("other") + " " + options);
    if (other.err.find("this build has") != std::string::npos) continue;
    ASSERT_EQ(other.code, 0) << other.err;
    EXPECT_EQ(read("other"), read("expected")) << options;
  }
}

TEST_F(Tool, RefusesADamagedPreparedMap) {
  ASSERT_EQ(run("prepare " + map_ + " --out " + file("box.arcway")).code, 0);
  const std::string bytes = read("box.arcway");
  expect_bad_input("plan " + put("cut.arcway", bytes.substr(0, bytes.size() / 2)) + kAround, "cut.arcway: byte ");
  std::string changed = bytes;
  changed[bytes.size() - 20] ^= 1;
  expect_bad_input("plan " + put("changed.arcway", changed) + kAround, "the file is damaged");
  expect_bad_input("prepare " + map_ + " --kind full --out " + file("x"), "--kind: expected reduced or feasible");
  expect_bad_input("prepare " + map_ + " --kind reduced --robot r.json --out " + file("x"), "--robot");
  EXPECT_FALSE(exists("x"));
}

TEST_F(Tool, ShowsABarOnATerminal) {
  if (std::system("script -qec true /dev/null </dev/null >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs script of bsdutils, and a pseudoterminal";
  const std::string prepare = " prepare clutter/star/n300/m10/s3 --backend reference --out " + file("w.arcway");
  const Run watched = run_command("script -qec '\"" ARCWAY_TOOL "\"" + prepare + "' /dev/null </dev/null");
  EXPECT_EQ(watched.code, 0) << watched.out;
  EXPECT_NE(watched.out.find("#."), std::string::npos) << watched.out;
  EXPECT_NE(watched.out.find(" % of "), std::string::npos);
  EXPECT_NE(watched.out.find("prepared"), std::string::npos);
  const Run unwatched = run(prepare);
  EXPECT_EQ(unwatched.code, 0);
  EXPECT_EQ(unwatched.err, "");
}

}  // namespace
