#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/context/context.h"
#include "bench/peers/visibility_study.h"
#include "bench/report/peer_results.h"
#include "datasets/file_io.h"
#ifdef ARCWAY_PEER_CGAL
#include "bench/peers/cgal_peer.h"
#endif
#ifdef ARCWAY_PEER_OMPL
#include "bench/peers/ompl_peer.h"
#include "bench/peers/planner_study.h"
#include "datasets/robot.h"
#endif

namespace arcway::peers {
namespace {

struct Options {
  VisibilityStudyOptions visibility;
#ifdef ARCWAY_PEER_OMPL
  PlannerStudyOptions planners{
      .worlds = {"clutter/convex/n100/m10/f15", "clutter/convex/n100/m10/f30", "clutter/convex/n100/m10/f45",
                 "clutter/star/n100/m10/f15", "clutter/star/n100/m10/f30", "clutter/star/n100/m10/f45"},
      .vehicle = {}};
#endif
  std::string only, out, lost, robot;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "JSON for `arcway report`");
  app.add_option("--only", options.only, "one of the studies")->check(CLI::IsMember({"visibility", "planners"}));
  app.add_option("--obstacles", options.visibility.obstacles, "sizes of the visibility study")->delimiter(',');
  app.add_option("--repetitions", options.visibility.repetitions, "of each side of a duel")->capture_default_str();
  app.add_option("--limit", options.visibility.limit, "leave out what takes longer [s]")->capture_default_str();
#ifdef ARCWAY_PEER_OMPL
  PlannerStudyOptions& p = options.planners;
  app.add_option("--worlds", p.worlds, "of the study of planners")->delimiter(',')->capture_default_str();
  app.add_option("--queries", p.queries, "a world")->capture_default_str();
  app.add_option("--times", p.times, "when to look at the peers' best path [s]")->delimiter(',')->capture_default_str();
  app.add_option("--long-time", p.long_time, "once more, on the first queries of a world [s]")->capture_default_str();
  app.add_option("--long-queries", p.long_queries, "how many those are")->capture_default_str();
  app.add_flag("--first-only", p.first_only, "RRTConnect's first path and nothing else");
  app.add_option("--first-within", p.first_within, "the time for that [s]")->capture_default_str();
  app.add_option("--seed", p.seed, "of queries and peers")->capture_default_str();
  app.add_option("--robot", options.robot, "of the study of planners (JSON); default: the paper's");
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
  results.context.emplace_back("ompl", ompl_version());
#endif
  return results;
}

void run_studies(const Options& options) {
  const auto say = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  report::PeerResults results = new_results();
  const auto save = [&] {
    if (!options.out.empty()) write_file_atomically(options.out, report::peer_results_json(results));
  };
  if (options.only != "planners") results.duels = visibility_study(options.visibility, say);
  save();
#ifdef ARCWAY_PEER_OMPL
  std::string lost;
  const PlannerStudyProgress progress{.line = say,
                                      .lost = [&](const std::string& line) { lost += line + "\n"; },
                                      .world_done =
                                          [&](const std::vector<report::PlannerQuery>& queries) {
                                            results.queries = queries;
                                            save();
                                          }};
  PlannerStudyOptions planners = options.planners;
  if (!options.robot.empty()) planners.vehicle = Vehicle(read_robot(read_file(options.robot), options.robot));
  if (options.only != "visibility") results.queries = planner_study(planners, progress);
  save();
  if (!options.lost.empty()) write_file_atomically(options.lost, lost);
#endif
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Compares arcway with its peers: the same questions, the same exact checks, in turn.", "arcway_peers");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  run_studies(options);
  return 0;
}

}  // namespace
}  // namespace arcway::peers

int main(int argc, char** argv) {
  try {
    return arcway::peers::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "arcway_peers: %s\n", error.what());
  }
  return 2;
}
