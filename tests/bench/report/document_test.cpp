#include "bench/report/document.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "bench/report/study.h"
#include "datasets/file_io.h"

namespace arcway::report {
namespace {

std::string run(const std::string& name, double seconds, const std::string& more = {}) {
  const std::string time = std::to_string(seconds * 1e9);
  return R"({"name":")" + name + R"(","run_type":"iteration","iterations":1,"real_time":)" + time + R"(,"cpu_time":)" +
         time + R"(,"time_unit":"ns")" + more + "}";
}

std::string file_of(const std::string& runs) {
  return R"({"context":{"processor":"Some <CPU> & more","commit":"abc"},"benchmarks":[)" + runs + "]}";
}

/// Two builders over four sizes, three repetitions each, one size left out.
std::string two_builders(double slowdown) {
  std::string runs;
  for (const int n : {10, 100, 1000, 10000})
    for (int i = 0; i < 3; ++i) {
      const double noise = 1.0 + 0.01 * i;
      runs += run("Build/slow/n:" + std::to_string(n) + "/process_time/real_time", 1e-8 * n * n * noise) + ",";
      runs += run("Build/fast/n:" + std::to_string(n) + "/process_time/real_time", slowdown * 1e-6 * n * noise,
                  R"(,"edges":7)") +
              ",";
    }
  return file_of(runs + R"({"name":"Build/slow/n:100000","run_type":"iteration","error_occurred":true,)" +
                 R"("error_message":"left out: about 99 s expected, the budget is 2 s"})");
}

TEST(Results, GatherRepetitionsAndCounters) {
  const Results results = read_results(two_builders(1.0), "r.json");
  ASSERT_EQ(results.measurements.size(), 9u);
  EXPECT_EQ(results.measurements[0].name, "Build/slow/n:10");
  EXPECT_EQ(results.measurements[0].wall_seconds.size(), 3u);
  EXPECT_EQ(results.measurements[1].counters.at("edges"), 7.0);
  EXPECT_TRUE(results.measurements.back().left_out());
}

TEST(Results, NameFilePlaceAndValueOfAnError) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      (void)read_results(text, "r.json");
    } catch (const FormatError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message("{").find("r.json"), std::string::npos);
  EXPECT_EQ(message("{}"), "r.json: \"context\" is missing");
  EXPECT_EQ(message(file_of(R"({"name":"a","real_time":"x","cpu_time":1})")),
            "r.json: benchmarks[0]: real_time: expected a number, found \"x\"");
}

TEST(Place, SplitsNamesIntoStageVariantAndSize) {
  const SeriesPlace place = place_of("FeasibleGraph/embree/n:100/radii:3");
  EXPECT_EQ(place.stage, "FeasibleGraph");
  EXPECT_EQ(place.variant, "embree/n:100");
  EXPECT_EQ(place.series, "FeasibleGraph/embree/n:100");
  EXPECT_EQ(place.key, "radii");
  EXPECT_EQ(place.size, 3.0);
  EXPECT_EQ(place_of("Predicates/orientation/random").key, "");
}

TEST(Summary, SaysWhatGrowsHowAndWhatWins) {
  const Results results = read_results(two_builders(1.0), "r.json");
  const std::vector<std::string> summary = summary_of(results, studies_of(results));
  ASSERT_EQ(summary.size(), 5u);
  EXPECT_EQ(summary[0], "Build/slow: the time grows like n^2.00 (2.00 to 2.00) from 10 to 10000, where it is 1.01 s.");
  EXPECT_EQ(summary[2], "Build at 10000 n: fast takes 10.1 ms, slow 1.01 s, 100 times as long.");
  EXPECT_NE(summary[4].find("1 sizes were left out"), std::string::npos);
}

TEST(Changes, PutSignificantRegressionsFirst) {
  const Results before = read_results(two_builders(1.0), "a.json"), after = read_results(two_builders(2.0), "b.json");
  const std::vector<Change> changes = changes_between(before, after);
  ASSERT_EQ(changes.size(), 8u);
  EXPECT_NEAR(changes[0].ratio(), 2.0, 1e-6);
  EXPECT_NE(changes[0].name.find("fast"), std::string::npos);
  EXPECT_NEAR(changes[0].p, 0.1, 1e-12) << "three repetitions cannot show more";
  EXPECT_FALSE(changes[0].significant());
}

TEST(Report, NeedsNothingFromOutside) {
  const std::string html = to_html(make_document({read_results(two_builders(1.0), "r.json")}));
  for (const char* outside : {"http://", "https://", "src=", "@import", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  EXPECT_NE(html.find("Some &lt;CPU&gt; &amp; more"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Report, OpensInABrowserWithoutErrors) {
  const char* configured = std::getenv("ARCWAY_BROWSER");
  const std::string browser = configured != nullptr ? configured : "chromium";
  if (std::system((browser + " --version > /dev/null 2>&1").c_str()) != 0)
    GTEST_SKIP() << "no browser \"" << browser << "\"; ARCWAY_BROWSER may name one";
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("arcway-report-" + std::to_string(std::random_device()()));
  std::filesystem::create_directories(folder);
  std::string html = to_html(make_document({read_results(two_builders(1.0), "r.json")}));
  // Presses the button, points at a marker, and says what came of it.
  html += R"(<script>
    document.getElementById('axes').click();
    const mark = document.querySelector('.linear [data-tip]');
    mark.dispatchEvent(new PointerEvent('pointerover', {bubbles: true, clientX: 10, clientY: 10}));
    document.title = [document.body.className, getComputedStyle(document.querySelector('.log')).display,
      document.getElementById('tip').textContent.length > 0,
      document.documentElement.scrollWidth <= innerWidth].join(' ');
  </script>)";
  write_file_atomically(folder / "report.html", html);
  const std::string command =
      browser +
      " --headless --no-sandbox --disable-gpu --window-size=400,900 --user-data-dir=" + (folder / "profile").string() +
      " --enable-logging=stderr --dump-dom file://" + (folder / "report.html").string() + " > " +
      (folder / "dom").string() + " 2> " + (folder / "log").string();
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  const std::string dom = read_file(folder / "dom"), log = read_file(folder / "log");
  EXPECT_EQ(log.find("CONSOLE"), std::string::npos) << log;
  EXPECT_NE(dom.find("<title>linear-axes none true true</title>"), std::string::npos)
      << dom.substr(dom.find("<title>"), 100);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace arcway::report
