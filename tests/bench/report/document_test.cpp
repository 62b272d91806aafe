#include "bench/report/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "arcway/datasets/file_io.h"
#include "bench/report/plot.h"
#include "bench/report/study.h"
#include "tests/support/benchmark_runs.h"

namespace arcway::internal::report {
namespace {

/// Two builders over four sizes, three repetitions each, one size left out.
std::string two_builders(double slowdown) {
  std::string runs;
  for (const int n : {10, 32, 100, 1000, 10000})
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
  ASSERT_EQ(results.measurements.size(), 11u);
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
  EXPECT_EQ(message(file_of("3")).rfind("r.json: benchmarks[0]: ", 0), 0u);
  EXPECT_EQ(
      message(file_of(R"({"name":"a","real_time":1,"cpu_time":1,"batch":"x"})")).rfind("r.json: benchmarks[0]: ", 0),
      0u);
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

TEST(Results, HaveMessagesInQuotesAsCsv) {
  const std::string failed = R"({"name":"a","error_occurred":true,"error_message":"expected \"b\", got c"})";
  EXPECT_EQ(to_csv(read_results(file_of(failed), "r.json")),
            "name,repetitions,wall_median_s,wall_min_s,wall_max_s,cpu_median_s,noise,error\n"
            "a,0,,,,,,\"expected \"\"b\"\", got c\"\n");
}

TEST(Results, LeaveHowOftenABenchmarkRanOutOfItsName) {
  const Results results =
      read_results(file_of(run("Radii/a/radii:3/iterations:1/repeats:1/process_time/real_time", 1.0, "")), "r.json");
  EXPECT_EQ(results.measurements.front().name, "Radii/a/radii:3");
}

TEST(TimeText, HasThreeDigitsAndTheUnitThatSuitsThem) {
  EXPECT_EQ(time_text(0.9994), "999 ms");
  EXPECT_EQ(time_text(0.9996), "1 s");
  EXPECT_EQ(time_text(9.996e-7), "1 µs");
  EXPECT_EQ(time_text(123.4), "123 s");
}

TEST(Results, GiveTheTimeOfOneAnswerOfABatch) {
  const Results results = read_results(file_of(run("Plan/n:10", 0.5, R"(,"batch":20)")), "r.json");
  EXPECT_NEAR(results.measurements.front().wall_seconds.front(), 0.025, 1e-12);
  EXPECT_TRUE(results.measurements.front().counters.empty());
}

std::string file_on(const std::string& processor, const std::string& commit, const std::string& runs) {
  return R"({"context":{"processor":")" + processor + R"(","commit":")" + commit + R"("},"benchmarks":[)" + runs + "]}";
}

TEST(UpdatedResults, KeepWhatTheRunLacks) {
  const std::string earlier = file_on("P", "a", run("Old/n:10/repeats:3", 1.0) + "," + run("Both/n:10/repeats:3", 1.0));
  const std::string newer =
      file_on("P", "b", run("Both/n:10/iterations:1", 2.0) + "," + run("New/n:10/iterations:1", 3.0));
  const std::string updated = updated_results(earlier, newer, "r.json");
  const Results results = read_results(updated, "r.json");
  std::vector<std::string> names;
  for (const Measurement& m : results.measurements) names.push_back(m.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Old/n:10", "Both/n:10", "New/n:10"}));
  EXPECT_EQ(results.measurements[1].wall_seconds, std::vector<double>{2.0});
  const std::vector<std::pair<std::string, std::string>> context{
      {"commit", "a"}, {"processor", "P"}, {"updated_at", "b"}};
  EXPECT_EQ(results.context, context);
  EXPECT_EQ(updated_results(updated, newer, "r.json"), updated);
}

TEST(UpdatedResults, AreOfOneProcessor) {
  EXPECT_THROW((void)updated_results(file_on("P", "a", ""), file_on("Q", "a", ""), "r.json"), FormatError);
  EXPECT_THROW((void)updated_results("{}", file_on("Q", "a", ""), "r.json"), FormatError);
}

TEST(RepeatedResults, HaveTheRunsOfBoth) {
  const std::string earlier = file_on("P", "a", run("Build/n:10", 1.0));
  const std::string repeated = repeated_results(earlier, file_on("P", "a", run("Build/n:10", 2.0)), "r.json");
  const Results results = read_results(repeated, "r.json");
  ASSERT_EQ(results.measurements.size(), 1u);
  EXPECT_EQ(results.measurements[0].wall_seconds, (std::vector<double>{1.0, 2.0}));
  EXPECT_THROW((void)repeated_results(earlier, file_on("Q", "a", ""), "r.json"), FormatError);
  EXPECT_THROW((void)repeated_results(earlier, file_on("P", "b", ""), "r.json"), FormatError);
}

TEST(Sentences, SayWhatGrowsHowAndWhatWins) {
  const Results results = read_results(two_builders(1.0), "r.json");
  const std::vector<std::string> sentences = sentences_of(studies_of(results).front());
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_EQ(sentences[0],
            "Build/slow: the time grows like n^2.00 (2.00 – 2.00) from 10 to 10,000 (n), where it is 1.01 s.");
  EXPECT_EQ(sentences[2], "Build at 10,000 (n): fast takes 10.1 ms, slow 1.01 s, 100 times as long.");
}

TEST(Sentences, MakeNoRatiosOfTimesThatAreTooShortForTheClock) {
  std::string runs;
  for (const char* name :
       {"Build/slow/n:10", "Build/slow/n:20", "Build/slow/n:30", "Build/fast/n:10", "Build/fast/n:30"})
    runs += (runs.empty() ? "" : ",") + run(name, 0.0);
  const Results results = read_results(file_of(runs), "r.json");
  const std::vector<Study> studies = studies_of(results);
  ASSERT_EQ(studies.size(), 1u);
  EXPECT_EQ(sentences_of(studies[0]), std::vector<std::string>{"Build at 30 (n): slow takes " + time_text(0.0) +
                                                               ", fast " + time_text(0.0) + "."});
  EXPECT_TRUE(changes_between(results, results).empty());
  const std::string page = to_html(make_document({.results = results, .before = results, .peers = {}}));
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

/// What the suites call the stages of planning, with times that grow like n.
std::string stages() {
  std::string runs;
  for (const char* series : {"ReducedGraph/tangent-cones", "Plan/lazy", "Plan/graph_reused", "LinesOfSight/embree"})
    for (const int n : {10, 32, 100, 1000, 10000})
      runs += run(std::string(series) + "/obstacles:" + std::to_string(n), 1e-6 * n) + ",";
  runs += run("Quality/convex_f30", 0.1, R"(,"queries":50,"solved_share":0.9,"time_over_bound_median":1.05)") + ",";
  runs += run("Ablation/convex_f30/everything", 0.1, R"(,"solved":45,"compared":44,"gap_percent_median":2.5)") + ",";
  runs += run("Ablation/convex_f30/one radius", 0.1, R"(,"solved":44,"compared":44,"gap_percent_median":4.25)");
  return file_of(runs);
}

Inputs inputs_of(const std::string& json) { return {read_results(json, "r.json"), std::nullopt, std::nullopt}; }

TEST(Summary, TellsAStrangerWhatItCosts) {
  const std::vector<std::string> summary = make_document(inputs_of(stages())).summary;
  ASSERT_EQ(summary.size(), 6u);
  EXPECT_EQ(
      summary[1],
      "Obstacles: to find which corners see each other, the visibility graph, takes a time like n^1.00 (1.00 – 1.00) "
      "with n obstacles of 10 vertices: "
      "100 µs at 1,000 vertices, 10 ms at 100,000 vertices.");
  EXPECT_TRUE(summary[3].starts_with("Quality, the paper's robot: 45 of 50 random queries are solved")) << summary[3];
  EXPECT_NE(summary[4].find("none failed"), std::string::npos);
}

TEST(Tables, SayWhatBecameOfTheQueriesOnARealMap) {
  const Results results = read_results(
      file_of(run("RealMap/coast/prepared/process_time/real_time", 2.0,
                  R"(,"vertices":72247,"body_length_m":12,"prepare_seconds":1.5,"queries":100,"solved":94,)"
                  R"("start_blocked":2,"goal_blocked":3,"no_path":0,"time_limit":1,"first_seconds":0.25,)"
                  R"("plan_seconds_median":0.07,"plan_seconds_p99":0.23)")),
      "r.json");
  const Document document = make_document({.results = results, .before = {}, .peers = {}});
  const auto section = std::ranges::find(document.sections, "Real maps", &Section::title);
  ASSERT_NE(section, document.sections.end());
  const std::vector<std::vector<std::string>> expected{
      {"coast/prepared", "72,247", "12 m", "1.5 s", "100", "94", "5", "0", "1", "250 ms", "70 ms", "230 ms"}};
  EXPECT_EQ(section->table.rows, expected);
}

/// The section of a title; an empty one if the document has none.
Section section_of(const Document& document, const std::string& title) {
  const auto found = std::ranges::find(document.sections, title, &Section::title);
  return found == document.sections.end() ? Section() : *found;
}

TEST(Tables, HaveNoMediansOfFewQueries) {
  const auto quality = [](const std::string& world, int solved) {
    return run("Quality/" + world, 0.1,
               R"(,"queries":20,"solved_share":)" + std::to_string(solved / 20.0) + R"(,"time_over_bound_median":1.5)");
  };
  std::string runs = quality("convex_f15", 10) + "," + quality("convex_f30", 9) + "," + quality("car/convex_f15", 2);
  runs += "," + run("Ablation/convex_f15/everything", 0.1, R"(,"solved":20,"compared":9,"gap_percent_median":2.5)");
  runs += "," + run("Radii/gentle/radii:1", 0.1, R"(,"solved":9,"refined_over_one_median":0.5)");
  runs += "," + run("Search/dijkstra/n32", 0.1, R"(,"queries":9,"solved_share":1,"plan_seconds_median":0.125)");
  const Document document = make_document(inputs_of(file_of(runs)));
  const Section section = section_of(document, "Quality of the plans");
  ASSERT_EQ(section.table.rows.size(), 1u);
  EXPECT_EQ(section.table.rows[0][0], "convex_f15");
  EXPECT_EQ(section.paragraphs.back(),
            "2 rows are not shown: fewer than 10 queries are solved in each, too few for a median.");
  EXPECT_TRUE(section_of(document, "What each part of the planner brings").title.empty());
  EXPECT_TRUE(section_of(document, "Travel time over the number of radii").title.empty());
  const std::vector<std::string> search =
      section_of(document, "Search with each heuristic: single measurements").table.header;
  EXPECT_EQ(std::ranges::find(search, "plan seconds median"), search.end());
  const Section vehicles = section_of(document, "Real vehicles");
  EXPECT_EQ(vehicles.table.rows[0][6], "2 of 20");
  EXPECT_EQ(vehicles.paragraphs[2], "2 worlds are left out of the medians: fewer than 10 queries are solved there.");
}

TEST(Tables, WriteCountersForPeople) {
  const Document document = make_document(inputs_of(file_of(
      run("Other/one", 1.0, R"(,"vertices":1234567,"share":0.25,"tiny":0.000023,"plan_seconds_median":0.00023)"))));
  const Table table = section_of(document, "Other: single measurements").table;
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(std::vector(table.header.begin() + 5, table.header.end()),
            (std::vector<std::string>{"plan seconds median", "share", "tiny", "vertices"}));
  EXPECT_EQ(std::vector(table.rows[0].begin() + 5, table.rows[0].end()),
            (std::vector<std::string>{"230 µs", "0.25", "2.3·10^-5", "1,234,567"}));
}

TEST(Tables, HaveNoColumnsOfDashesAlone) {
  const Table table = without_fillers(
      {{"name", "text", "empty", "number", "dash"}, {{"a", "–", "", "1", "–"}, {"b", "x", "", "–", "–"}}, 3});
  EXPECT_EQ(table.header, (std::vector<std::string>{"name", "text", "number"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"b", "x", "–"}));
  EXPECT_EQ(table.numbers_from, 2u);
}

TEST(Summary, CountsFailures) {
  const std::string failed = R"({"name":"Build/n:7","error_occurred":true,"error_message":"edges differ"})";
  const Document document = make_document(inputs_of(file_of(run("Build/n:10", 1.0) + "," + failed)));
  EXPECT_NE(document.summary[1].find("1 benchmarks failed"), std::string::npos) << document.summary[1];
  EXPECT_NE(to_markdown(document).find("| Build/n:7 | edges differ |"), std::string::npos);
}

/// Of the car all benchmarks, of the others none.
std::string of_the_car() {
  std::string runs;
  for (const char* series : {"PlanPrepared/car", "PlanFirst/car", "Plan/graph_reused", "Plan/lazy"})
    for (const int n : {10, 100, 1000}) runs += run(series + ("/obstacles:" + std::to_string(n)), 1e-5 * n) + ",";
  const auto quality = [](const std::string& world, double seconds, double over_bound) {
    return run("Quality/" + world, seconds,
               R"(,"queries":20,"solved_share":0.9,"plan_seconds_median":)" + std::to_string(seconds) +
                   R"(,"first_path_seconds_median":0.001,"time_over_bound_median":)" + std::to_string(over_bound));
  };
  return file_of(runs + quality("convex_f15", 0.004, 1.02) + "," + quality("car/convex_f15", 0.003, 1.05) + "," +
                 quality("car/star_f15", 0.007, 1.25));
}

TEST(RealVehicles, ComeFirst) {
  const Document document = make_document(inputs_of(of_the_car()));
  EXPECT_EQ(
      document.summary[0],
      "Real vehicles (passenger car): 36 of 40 random queries are solved among 100 obstacles. By vehicle and world, a "
      "first path takes 1 ms in "
      "the median, the plan 3 ms – 7 ms; its travel time is 5.0 – 25.0 % above a lower bound that no path can beat.");
  ASSERT_EQ(document.plots.size(), 2u);
  ASSERT_EQ(document.figures.size(), 1u);
  EXPECT_NE(document.plots[0].find("Time of the stages"), std::string::npos);
  EXPECT_NE(document.plots[1].find("passenger car"), std::string::npos);
  EXPECT_NE(document.figures[0].find("The first plan on a new map"), std::string::npos);
  const Section& section = document.sections.front();
  EXPECT_EQ(section.title, "Real vehicles");
  ASSERT_EQ(section.table.rows.size(), 2u);
  EXPECT_EQ(section.paragraphs[1],
            "Not measured in these results: AMR of 1 m/s, forklift for 1.6 t, single-unit truck, farm tractor.");
  EXPECT_EQ(section.table.rows[0],
            (std::vector<std::string>{"passenger car", "4.74 × 1.76 m", "3.7 m", "13.9 m/s", "2 / 2 m/s²", "2.68",
                                      "36 of 40", "1 ms", "3 ms – 7 ms", "1.050 – 1.250", "10 ms", "10 ms"}))
      << "columns of dashes alone are left out";
  EXPECT_EQ(section.table.rows.back()[0], "the paper's robot");
  EXPECT_EQ(section.table.rows.back()[8], "4 ms");
  const auto quality = std::ranges::find(document.sections, "Quality of the plans", &Section::title);
  ASSERT_NE(quality, document.sections.end());
  EXPECT_EQ(quality->table.rows[0][0], "car/convex_f15");
  EXPECT_EQ(quality->table.rows[2][0], "convex_f15");
}

TEST(RealVehicles, AreFollowedByOtherBodies) {
  const std::string bus =
      run("QualityBody/bus/convex_f15", 0.005, R"(,"queries":20,"solved_share":0.8,"plan_seconds_median":0.005)");
  const std::string car = run("Quality/car/convex_f15", 0.005, R"(,"queries":20,"solved_share":0.9)");
  const Section section = section_of(make_document(inputs_of(file_of(car + "," + bus))), "Real vehicles");
  ASSERT_EQ(section.table.rows.size(), 2u);
  EXPECT_EQ(section.table.rows[0][0], "passenger car");
  EXPECT_EQ(section.table.rows[1][0], "city bus");
  EXPECT_EQ(std::ranges::count(section.table.rows[1], "16 of 20"), 1);
  EXPECT_EQ(std::ranges::count(section.table.rows[1], "12.1 × 2.6 m"), 1);
}

TEST(RealVehicles, AreMissedWhereNothingIsMeasured) {
  const Inputs inputs = inputs_of(stages());
  EXPECT_NE(make_document(inputs).summary[0].find("not measured in these results"), std::string::npos);
  EXPECT_EQ(section_of(make_document(inputs), "Real vehicles").table.rows.size(), 1u) << "the paper's robot";
  const Inputs nothing = inputs_of(file_of(run("Build/n:10", 1.0)));
  EXPECT_TRUE(section_of(make_document(nothing), "Real vehicles").title.empty());
}

TEST(Tables, ReplaceWhatStandsBetweenTheirMarks) {
  const Inputs inputs = inputs_of(stages());
  const std::string text = "before\n<!-- table ablation -->\nold\nrows\n<!-- end of table -->\nafter\n";
  const std::string made = with_tables(text, inputs, "F.md");
  EXPECT_EQ(made,
            "before\n<!-- table ablation -->\n| variant | convex_f30 |\n|---|---:|\n| everything | 2.50 (45) |\n"
            "| one radius | 4.25 (44) |\n<!-- end of table -->\nafter\n");
  EXPECT_EQ(with_tables(made, inputs, "F.md"), made);
  EXPECT_NE(
      with_tables("<!-- table cost -->\n<!-- end of table -->\n", inputs, "F.md").find("| Reduced visibility graph |"),
      std::string::npos);
  EXPECT_THROW((void)with_tables("<!-- table nothing -->\n<!-- end of table -->\n", inputs, "F.md"), FormatError);
  EXPECT_THROW((void)with_tables("<!-- table cost -->\n", inputs, "F.md"), FormatError);
  EXPECT_THROW((void)with_tables("<!-- table duels -->\n<!-- end of table -->\n", inputs, "F.md"), FormatError);
}

TEST(Changes, PutSignificantRegressionsFirst) {
  const Results before = read_results(two_builders(1.0), "a.json"), after = read_results(two_builders(2.0), "b.json");
  const std::vector<Change> changes = changes_between(before, after);
  ASSERT_EQ(changes.size(), 10u);
  EXPECT_NEAR(changes[0].ratio(), 2.0, 1e-6);
  EXPECT_NE(changes[0].name.find("fast"), std::string::npos);
  EXPECT_NEAR(changes[0].p, 0.1, 1e-12) << "three repetitions cannot show more";
  EXPECT_FALSE(changes[0].significant());
}

TEST(Changes, NameFilesCommitsAndMachines) {
  const std::string processor =
      R"({"context":{"processor":"P","cores":"2","commit":"old","date":"2026-11-24T09:45:46"},"benchmarks":[)";
  const Results before = read_results(processor + run("Build/slow/n:10", 1.0) + "]}", "a.json");
  const Document document =
      make_document({.results = read_results(two_builders(1.0), "b.json"), .before = before, .peers = {}});
  const std::string old_run = "a.json, commit old, on P with 2 cores, 2026-11-24";
  const std::string new_run = "b.json, commit abc, on Some <CPU> & more";
  EXPECT_EQ(document.subtitle, "Before: " + old_run + ". After: " + new_run + ".");
  const Section& changes = document.sections.front();
  EXPECT_EQ(changes.title, "Changes");
  EXPECT_EQ(changes.paragraphs[0], "Before: " + old_run + ".");
  EXPECT_EQ(changes.paragraphs[1], "After: " + new_run + ".");
}

TEST(Report, RaisesExponents) {
  const Document document = make_document(inputs_of(stages()));
  const std::string html = to_html(document), markdown = to_markdown(document);
  EXPECT_NE(html.find("n<sup>1.00</sup> (1.00 – 1.00)"), std::string::npos);
  EXPECT_NE(markdown.find("| Reduced visibility graph | n<sup>1.00</sup> (1.00 – 1.00) |"), std::string::npos)
      << markdown;
  EXPECT_EQ(html.find("n^"), std::string::npos);
  EXPECT_EQ(markdown.find("n^"), std::string::npos);
}

TEST(Report, NamesSectionsInWords) {
  const Document document = make_document(inputs_of(stages()));
  EXPECT_EQ(section_of(document, "Reduced visibility graph, by number of obstacles").table.rows.size(), 5u);
  const std::string html = to_html(document);
  EXPECT_NE(html.find("<h2 id=\"reduced-visibility-graph-by-number-of-obstacles\">"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"#what-it-costs\">What it costs</a>"), std::string::npos);
  EXPECT_NE(html.find("<h2 id=\"what-it-costs\">"), std::string::npos);
}

TEST(Report, KeepsTheLinesOfACitation) {
  const std::string html = to_html(make_document(inputs_of(stages())));
  EXPECT_NE(html.find("<pre>@software{arcway,\n  title   = {arcway},\n"), std::string::npos);
  EXPECT_NE(html.find("commit abc}"), std::string::npos);
}

TEST(Report, NeedsNothingFromOutside) {
  const std::string html = to_html(make_document(inputs_of(two_builders(1.0))));
  for (const char* outside : {"http://", "https://", "src=", "@import", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  EXPECT_NE(html.find("Some &lt;CPU&gt; &amp; more"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Report, ShowsCodeAsCode) {
  Document document;
  document.sections.emplace_back().paragraphs = {"`a<b` is so; `c` is not."};
  EXPECT_NE(to_html(document).find("<p><code>a&lt;b</code> is so; <code>c</code> is not.</p>"), std::string::npos);
}

}  // namespace
}  // namespace arcway::internal::report
