#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <set>
#include <string>
#include <vector>

#include "bench/peers/comparison.h"
#include "bench/peers/ompl_peer.h"
#include "core/planner.h"
#include "datasets/catalogue.h"
#include "datasets/file_io.h"
#include "datasets/plan_io.h"
#include "datasets/random_queries.h"

namespace arcway::peers {
namespace {

struct Options {
  std::vector<std::string> worlds{"clutter/convex/n100/m10/f15", "clutter/convex/n100/m10/f30",
                                  "clutter/convex/n100/m10/f45", "clutter/star/n100/m10/f15",
                                  "clutter/star/n100/m10/f30",   "clutter/star/n100/m10/f45"};
  std::size_t pairs = 50;
  std::vector<double> times{1.0};
  double first_within = 10.0;
  std::uint64_t seed = 1;
  bool first_only = false;
  std::string out, csv, unsolved;
};

class Comparison {
 public:
  explicit Comparison(Options options) : options_(std::move(options)) {
    std::ranges::sort(options_.times);
    if (options_.first_only) options_.times.clear();
    planners_.emplace_back("arcway");
    for (const OmplPlanner planner : kinds()) {
      planners_.push_back(std::string(name_of(planner)) + " first");
      for (const double time : options_.times) {
        char text[32];
        std::snprintf(text, sizeof text, " %g s", time);
        planners_.push_back(name_of(planner) + std::string(text));
      }
    }
  }

  void run() {
    for (const std::string& name : options_.worlds) run_world(name);
    const std::string table = comparison_table(planners_, rows_);
    std::printf("\nOMPL %s\n\n%s", ompl_version().c_str(), table.c_str());
    if (!options_.out.empty()) write_file_atomically(options_.out, table);
    if (!options_.csv.empty()) write_file_atomically(options_.csv, comparison_csv(planners_, rows_));
    if (!options_.unsolved.empty()) write_file_atomically(options_.unsolved, unsolved_);
  }

 private:
  [[nodiscard]] std::vector<OmplPlanner> kinds() const {
    if (options_.first_only) return {OmplPlanner::kRrtConnect};
    return {OmplPlanner::kRrtConnect, OmplPlanner::kInformedRrtStar};
  }

  void run_world(const std::string& name) {
    const World world = catalogue_world(name);
    const Vehicle vehicle;
    const QuerySet queries = make_reference_queries(world);
    const Planner planner(world, vehicle, queries, {}, SerialExecutor());
    const PrepareStatistics& prepared = planner.prepare_statistics();
    std::fprintf(stderr, "%s: arcway prepared in %.2f s\n", name.c_str(),
                 prepared.visibility_seconds + prepared.feasible_seconds);
    const auto pairs = random_queries(world, queries, vehicle, {.count = options_.pairs, .seed = options_.seed});
    for (std::size_t q = 0; q < pairs.size(); ++q) {
      const Problem problem{world, vehicle, *queries.sweep, pairs[q]};
      const PlanResult ours = planner.plan(pairs[q]);
      Row row{name, q, pairs[q], ours.lower_bound, {}};
      row.answers.push_back(ours.solved() ? std::optional(Answer{ours.statistics.total_seconds, ours.travel_time,
                                                                 ours.path(), is_valid(problem, ours.path())})
                                          : std::nullopt);
      Random random(options_.seed + q);
      for (const OmplPlanner kind : kinds()) {
        const PeerRun run = run_ompl(kind, problem, options_.first_within, options_.times, random);
        row.answers.push_back(answer_of(problem, run.first));
        for (const auto& solution : run.at_time) row.answers.push_back(answer_of(problem, solution));
      }
      report(row, name_of(ours.status));
      rows_.push_back(std::move(row));
    }
  }

  static std::optional<Answer> answer_of(const Problem& problem, const std::optional<PeerSolution>& solution) {
    if (!solution) return std::nullopt;
    return Answer{solution->seconds, solution->travel_time, solution->path, is_valid(problem, solution->path)};
  }

  /// Progress, and the tasks that a peer alone solves.
  void report(const Row& row, const char* status) {
    std::fprintf(stderr, "%s %zu: arcway %s", row.world.c_str(), row.query, status);
    for (std::size_t p = 0; p < planners_.size(); ++p) {
      const auto& answer = row.answers[p];
      std::fprintf(stderr, ", %s ", planners_[p].c_str());
      if (answer) std::fprintf(stderr, "%.3f s%s", answer->travel_time, answer->valid ? "" : " INVALID");
      if (!answer) std::fprintf(stderr, "none");
      if (!answer || row.answers.front() || !unsolved_listed_.insert(row.world + std::to_string(row.query)).second)
        continue;
      PlanResult plan;
      plan.status = PlanStatus::kSolved;
      plan.start = row.request.start;
      plan.goal = row.request.goal;
      plan.travel_time = answer->travel_time;
      plan.length = length_of(answer->path);
      plan.lower_bound = row.lower_bound;
      for (const PathSegment& s : answer->path) plan.segments.push_back({s, 0.0, 0.0, 0.0});
      unsolved_ += row.world + " " + planners_[p] + " " + plan_to_json(plan, row.query) + "\n";
    }
    std::fprintf(stderr, "\n");
  }

  Options options_;
  std::vector<std::string> planners_;
  std::vector<Row> rows_;
  std::string unsolved_;
  std::set<std::string> unsolved_listed_;
};

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Compares arcway with OMPL: the same tasks, the same exact checks.", "arcway_peers");
  app.add_option("--worlds", options.worlds, "names of the catalogue")->delimiter(',')->capture_default_str();
  app.add_option("--pairs", options.pairs, "tasks a world")->capture_default_str();
  app.add_option("--times", options.times, "when to look at the peers' best path [s]")->delimiter(',');
  app.add_option("--first-within", options.first_within, "give up without a first path by then [s]");
  app.add_flag("--first-only", options.first_only, "RRTConnect's first path and nothing else");
  app.add_option("--seed", options.seed, "of tasks and peers")->capture_default_str();
  app.add_option("--out", options.out, "the table as Markdown");
  app.add_option("--csv", options.csv, "a line an answer");
  app.add_option("--unsolved", options.unsolved, "tasks that a peer alone solves, with its path as a plan");
  CLI11_PARSE(app, argc, argv);
  Comparison(std::move(options)).run();
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
