#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/file_io.h"
#include "bench/context/context.h"
#include "bench/peers/visibility_study.h"
#include "bench/report/peer_results.h"
#ifdef ARCWAY_PEER_CGAL
#include "bench/peers/cgal_peer.h"
#endif
#ifdef ARCWAY_PEER_OMPL
#include "arcway/datasets/robot.h"
#include "bench/peers/ompl_peer.h"
#include "bench/peers/planner_study.h"
#endif

namespace arcway::internal::peers {
namespace {

constexpr int kExitBadInput = 2;  // as of the tool

struct Options {
  VisibilityStudyOptions visibility;
#ifdef ARCWAY_PEER_OMPL
  PlannerSetting planners{.name = {}, .worlds = {}, .vehicle = Vehicle()};  // where no standard one is meant
  std::vector<std::string> settings;
  std::optional<std::size_t> queries, long_queries;  // also for the standard settings
#endif
  std::string only, out, lost, robot;
  bool update = false, ours = false;
};

/// As a run of all has them.
std::vector<std::string> setting_names() {
  std::vector<std::string> names;
#ifdef ARCWAY_PEER_OMPL
  for (const PlannerSetting& setting : standard_settings()) names.push_back(setting.name);
#endif
  return names;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "JSON for `arcway report`");
  app.add_flag("--update", options.update, "Keep what the file has of other studies and settings");
  app.add_option("--only", options.only, "one of the studies")->check(CLI::IsMember({"visibility", "planners"}));
  app.add_option("--obstacles", options.visibility.obstacles, "sizes of the visibility study")->delimiter(',');
  app.add_option("--repetitions", options.visibility.repetitions, "of each side of a duel")->capture_default_str();
  app.add_option("--limit", options.visibility.limit, "leave out what takes longer [s]")->capture_default_str();
#ifdef ARCWAY_PEER_OMPL
  PlannerSetting& p = options.planners;
  app.add_option("--settings", options.settings, "of the study of planners; default: all")
      ->delimiter(',')
      ->check(CLI::IsMember(setting_names()));
  app.add_option("--worlds", p.worlds, "a setting of its own, to which the options below belong")->delimiter(',');
  app.add_option("--queries", options.queries, "a world");
  app.add_option("--long-queries", options.long_queries, "the first ones of a world, which have the long time");
  app.add_option("--times", p.times, "when to look at the peers' best path [s]")->delimiter(',')->capture_default_str();
  app.add_option("--long-time", p.long_time, "once more, on the long queries [s]")->capture_default_str();
  app.add_flag("--ours", options.ours,
               "Only plan with arcway anew; answers of peers stay those of the file, by --update")
      ->needs("--update");
  app.add_flag("--first-only", p.first_only, "RRTConnect's first path and nothing else");
  app.add_option("--first-within", p.first_within, "the time for that [s]")->capture_default_str();
  app.add_option("--seed", p.seed, "of queries, peers and shortcuts")->capture_default_str();
  app.add_option("--robot", options.robot, "JSON; default: the paper's");
  app.add_option("--lost", options.lost,
                 "queries that a peer alone solves, or with a faster path, and its path as a plan");
#endif
}

report::PeerResults new_results() {
  report::PeerResults results;
  results.context = bench::machine_and_build();
#ifdef ARCWAY_PEER_CGAL
  results.context.emplace_back("cgal", cgal_version());
#endif
#ifdef ARCWAY_PEER_OMPL
  results.context.emplace_back(ompl_name(), ompl_version());
#endif
  return results;
}

#ifdef ARCWAY_PEER_OMPL
std::vector<PlannerSetting> chosen_settings(const Options& options) {
  std::vector<PlannerSetting> chosen;
  if (options.planners.worlds.empty()) {
    chosen = standard_settings();
    const auto is_left_out = [&](const PlannerSetting& s) {
      return std::ranges::find(options.settings, s.name) == options.settings.end();
    };
    if (!options.settings.empty()) std::erase_if(chosen, is_left_out);
  } else {
    PlannerSetting& own = chosen.emplace_back(options.planners);
    own.name = options.robot.empty() ? "paper's robot" : options.robot;
    if (!options.robot.empty()) own.vehicle = Vehicle(read_robot(read_file(options.robot), options.robot));
  }
  for (PlannerSetting& setting : chosen) {
    setting.ours_only = options.ours;
    setting.queries = options.queries.value_or(setting.queries);
    setting.long_queries = options.long_queries.value_or(setting.long_queries);
  }
  return chosen;
}

// One setting after the other.
void study_planners(const Options& options, const std::function<void(const std::string&)>& say,
                    const std::function<void()>& save, report::PeerResults& results) {
  std::string lost;
  for (const PlannerSetting& setting : chosen_settings(options)) {
    const PlannerStudyProgress progress{.line = say,
                                        .lost = [&](const std::string& line) { lost += line + "\n"; },
                                        .world_done =
                                            [&](const std::vector<report::PlannerQuery>& queries) {
                                              results.queries.insert(results.queries.end(), queries.begin(),
                                                                     queries.end());
                                              save();
                                            }};
    planner_study(setting, progress);
    if (!options.lost.empty()) write_file_atomically(options.lost, lost);
  }
}
#endif

void run_studies(const Options& options) {
  const auto say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  const std::vector<std::string> order = setting_names();
  const report::PeerResults earlier =
      options.update ? report::read_peer_results(read_file(options.out), options.out) : report::PeerResults();
  report::PeerResults results = new_results();
  const auto save = [&] {
    if (options.out.empty()) return;
    report::PeerResults run = results;
    if (options.ours) run.queries = report::answered_anew(earlier.queries, results.queries);
    write_file_atomically(options.out, report::peer_results_json(report::renewed(earlier, std::move(run), order)));
  };
  if (options.only != "planners") results.duels = visibility_study(options.visibility, say);
  save();
#ifdef ARCWAY_PEER_OMPL
  seed_ompl(options.planners.seed);
  if (options.only != "visibility") study_planners(options, say, save, results);
#endif
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Compares arcway with its peers: the same questions, the same exact checks, in turn.", "arcway_peers");
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kExitBadInput;
  }
  run_studies(options);
  return 0;
}

}  // namespace
}  // namespace arcway::internal::peers

int main(int argc, char** argv) {
  try {
    return arcway::internal::peers::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "arcway_peers: %s\n", error.what());
  }
  return arcway::internal::peers::kExitBadInput;
}
