#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/cli/arguments.h"
#include "bench/cli/output_files.h"
#include "bench/cli/progress_bar.h"
#include "bench/cli/report_files.h"
#include "bench/cli/signal_stop.h"
#include "bench/cli/study_input.h"
#include "bench/cli/study_peers.h"
#include "bench/report/map_sections.h"
#include "bench/report/results.h"
#include "core/base/shortest_text.h"

namespace arcway::internal::cli {
namespace {

#ifdef ARCWAY_WITH_BENCHMARK
constexpr bool kHasBenchmark = true;
#else
constexpr bool kHasBenchmark = false;
#endif

constexpr const char* kResults = "results.json";

struct BenchArguments {
  std::vector<std::string> maps, robots;
  MapOptions reading;
  std::string queries, seed, time_limit, repetitions, peer_time;
  bool reverse = false;
  std::string out = "arcway-bench";
};

StudyInput typed_input(const BenchArguments& arguments) {
  StudyInput input;
  input.maps = arguments.maps;
  for (const std::string& robot : arguments.robots) input.robots.push_back(read_studied_robot(robot));
  if (!arguments.queries.empty()) input.queries = arguments.queries;
  if (!arguments.seed.empty()) input.seed = parse_count(arguments.seed, "--seed");
  input.reverse = arguments.reverse;
  if (!arguments.time_limit.empty()) input.time_limit = parse_number(arguments.time_limit, "--time-limit");
  if (!arguments.repetitions.empty()) input.repetitions = parse_count(arguments.repetitions, "--repetitions");
  if (!arguments.peer_time.empty()) input.peer_time = parse_number(arguments.peer_time, "--peer-time");
  return input;
}

/// What a scenario says; nothing may be typed beside it that it says itself.
StudyInput scenario_input(const BenchArguments& arguments) {
  for (const auto& [option, is_given] : {std::pair{"--robot", !arguments.robots.empty()},
                                         {"--queries", !arguments.queries.empty()},
                                         {"--seed", !arguments.seed.empty()},
                                         {"--reverse", arguments.reverse},
                                         {"--time-limit", !arguments.time_limit.empty()},
                                         {"--repetitions", !arguments.repetitions.empty()},
                                         {"--peer-time", !arguments.peer_time.empty()}})
    if (is_given) throw UsageError(std::string(option) + ": only with maps; " + arguments.maps[0] + " says it all");
  return read_study_file(arguments.maps[0]);
}

StudyInput input_of(const BenchArguments& arguments) {
  const bool is_scenario = arguments.maps.size() == 1 && is_study_file(arguments.maps[0]);
  StudyInput input = is_scenario ? scenario_input(arguments) : typed_input(arguments);
  if (input.robots.empty()) input.robots.push_back(read_studied_robot(""));
  if (!arguments.peer_time.empty() && !has_peers())
    throw UsageError("--peer-time: this build has no peers; configure it with -DARCWAY_PEER_OMPL=ON");
  return input;
}

/// Files of the results in the folder of --out.
struct ResultFiles {
  explicit ResultFiles(const std::string& folder)
      : results((std::filesystem::path(folder) / kResults).string()),
        peers((std::filesystem::path(folder) / "peers.json").string()),
        report(folder) {}
  [[nodiscard]] std::vector<std::string> all() const {
    std::vector<std::string> files = report.all();
    files.push_back(results);
    if (has_peers()) files.push_back(peers);
    return files;
  }
  std::string results, peers;
  ReportFiles report;
};

std::vector<std::string> inputs_of(const BenchArguments& arguments, const StudyInput& input) {
  std::vector<std::string> files = arguments.maps;
  files.insert(files.end(), arguments.robots.begin(), arguments.robots.end());
  files.insert(files.end(), input.maps.begin(), input.maps.end());
  files.push_back(input.queries);
  return files;
}

int run_bench(const BenchArguments& arguments, std::string& out) {
  if (!kHasBenchmark)
    throw UsageError(
        "bench: this tool was built without Google Benchmark; install it (Debian: libbenchmark-dev) and build again");
  const StudyInput input = input_of(arguments);
  std::string notes;
  const bench::MapStudy study = make_study(input, arguments.reading, notes);
  make_folders(arguments.out);
  const ResultFiles names(arguments.out);
  OutputFiles files(names.all(), inputs_of(arguments, input));

  const SignalStop signals;
  ProgressBar bar;
  const bench::MapStudyProgress progress{
      .stop = signals.token(),
      .show = [show = bar.callback()](const std::string& what, std::size_t done, std::size_t total) {
        show({what.c_str(), done, total});
      }};
#ifdef ARCWAY_WITH_BENCHMARK
  const bench::MapStudyRun run = bench::run_map_study(study, progress);
#else
  const bench::MapStudyRun run;
#endif
  report::Inputs found{.results = report::read_results(run.json, kResults), .before = {}, .peers = {}};
  if (input.peer_time > 0.0 && has_peers() && !input.reverse) found.peers = run_peers(study, input.peer_time, progress);
  const bool is_interrupted = signals.signal() != 0;
  if (!found.results.measurements.empty()) {
    files.add(names.results, run.json);
    if (found.peers) files.add(names.peers, report::peer_results_json(*found.peers));
    out += add_report(files, names.report, found);
    for (const std::string& sentence : report::own_map_findings(found.results)) out += "- " + sentence + "\n";
  }
  out += notes;
  if (is_interrupted) out += row("interrupted", "what was finished before is kept");
  files.write();
  out += files.summary();
  if (is_interrupted) return kExitInterrupted;
  return run.failures == 0 ? kExitSolved : kExitNoPath;
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  CLI::App& command = *app.add_subcommand("bench", "Measure planning on your own maps, for your own robots");
  const auto arguments = std::make_shared<BenchArguments>();
  const StudyInput defaults;
  command
      .add_option("MAP", arguments->maps,
                  std::string(kMapHelp) + "; several, or one scenario (JSON of the format arcway-benchmark) alone")
      ->required();
  const auto option = [&](const char* name, std::string& value, const std::string& what, const char* type) {
    return command.add_option(name, value, what)->type_name(type);
  };
  command.add_option("--robot", arguments->robots, "Robot (JSON, YAML); repeated; default: the paper's")
      ->type_name("R.json")
      ->allow_extra_args(false);
  option("--queries", arguments->queries,
         std::string("So many random ones for each map and robot, or a file: ") + kQueryColumns, "N|Q.csv")
      ->default_str(defaults.queries);
  option("--seed", arguments->seed, "Seed of random queries", "N")->default_str(std::to_string(defaults.seed));
  command.add_flag("--reverse", arguments->reverse, "Drive backwards as well");
  option("--time-limit", arguments->time_limit, "Of one query; default: none", "SECONDS");
  option("--repetitions", arguments->repetitions, "Of each benchmark", "N")
      ->default_str(std::to_string(defaults.repetitions));
  option("--peer-time", arguments->peer_time,
         "Of each planner of OMPL on each of the first ten queries, if this build has them; 0: leave them out",
         "SECONDS")
      ->default_str(shortest_text(defaults.peer_time));
  option("--out", arguments->out, "Folder for results.json (Google Benchmark's JSON) and the report", "DIR")
      ->capture_default_str();
  arguments->reading.add_to(command, "MAP");
  command.callback(
      [arguments, &action] { action = [arguments](std::string& out) { return run_bench(*arguments, out); }; });
}

}  // namespace arcway::internal::cli
