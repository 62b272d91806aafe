#include "bench/peers/planner_study.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "bench/peers/cpu_clock.h"
#include "bench/peers/ompl_peer.h"
#include "core/planner.h"
#include "datasets/catalogue.h"
#include "datasets/plan_io.h"
#ifdef ARCWAY_WITH_ACCEL
#include "accel/make_queries.h"
#endif

namespace arcway::peers {
namespace {

using report::PlannerAnswer;
using report::PlannerQuery;

QuerySet fastest_queries(const World& world) {
#ifdef ARCWAY_WITH_ACCEL
  return make_embree_queries(world);
#else
  return make_reference_queries(world);
#endif
}

std::string text_of(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// A peer's path as a plan, for the tool to look at.
std::string plan_text(const PlanRequest& request, const PeerSolution& solution, const PlannerQuery& query) {
  PlanResult plan;
  plan.status = PlanStatus::kSolved;
  plan.start = request.start;
  plan.goal = request.goal;
  plan.travel_time = solution.travel_time;
  plan.length = length_of(solution.path);
  plan.lower_bound = query.lower_bound;
  for (const PathSegment& s : solution.path) plan.segments.push_back({s, 0.0, 0.0, 0.0});
  return plan_to_json(plan, query.query);
}

class Study {
 public:
  Study(const PlannerStudyOptions& options, const PlannerStudyProgress& progress)
      : options_(options), progress_(progress) {}

  std::vector<PlannerQuery> run() {
    for (const std::string& world : options_.worlds) {
      run_world(world);
      progress_.world_done(results_);
    }
    return std::move(results_);
  }

 private:
  void run_world(const std::string& name) {
    const World world = catalogue_world(name);
    const Vehicle& vehicle = options_.vehicle;
    const QuerySet queries = fastest_queries(world);
    const CpuClock preparing(CpuClock::Of::kProcess);
    const Planner planner(world, vehicle, queries, {}, SerialExecutor());
    progress_.line(name + ": arcway prepared in " + text_of("%.3g s", preparing.seconds()));
    const std::vector<PlanRequest> requests = catalogue_queries(name, options_.queries, options_.seed);
    for (std::size_t q = 0; q < requests.size(); ++q) {
      const Problem problem{world, vehicle, *queries.sweep, requests[q]};
      PlannerQuery result{name, q, 0.0, {}};
      const double time = plan_ours(planner, problem, result);
      Random random(options_.seed + q);
      run_peer(OmplPlanner::kRrtConnect, problem, random, result, time);
      if (!options_.first_only) run_peer(OmplPlanner::kInformedRrtStar, problem, random, result, time);
      report(result);
      results_.push_back(std::move(result));
    }
  }

  // The travel time; infinity without a path.
  static double plan_ours(const Planner& planner, const Problem& problem, PlannerQuery& result) {
    const CpuClock clock(CpuClock::Of::kThread);
    const PlanResult plan = planner.plan(problem.request);
    const double seconds = clock.seconds();
    result.lower_bound = plan.lower_bound;
    result.answers.push_back(
        {"arcway", name_of(plan.status), seconds, plan.travel_time, plan.solved() && is_valid(problem, plan.path())});
    return plan.solved() ? plan.travel_time : std::numeric_limits<double>::infinity();
  }

  void run_peer(OmplPlanner kind, const Problem& problem, Random& random, PlannerQuery& result, double our_time) {
    std::vector<double> times = options_.first_only ? std::vector<double>() : options_.times;
    if (!options_.first_only && result.query < options_.long_queries) times.push_back(options_.long_time);
    std::ranges::sort(times);
    const double first_within = times.empty() ? options_.first_within : times.back();
    const PeerRun run = run_ompl(kind, problem, first_within, times, random);
    const auto add = [&](const std::string& when, double limit, const std::optional<PeerSolution>& solution) {
      const std::string planner = std::string(name_of(kind)) + " " + when;
      if (!solution) {
        result.answers.push_back({planner, "no path in" + text_of(" %g s", limit), limit, 0.0, false});
        return;
      }
      result.answers.push_back(
          {planner, "solved", solution->seconds, solution->travel_time, is_valid(problem, solution->path)});
      if (solution->travel_time < our_time)
        progress_.lost(result.world + " " + planner + " " + plan_text(problem.request, *solution, result));
    };
    add("first", first_within, run.first);
    for (std::size_t i = 0; i < times.size(); ++i) add(text_of("%g s", times[i]), times[i], run.at_time[i]);
  }

  void report(const PlannerQuery& query) const {
    std::string line = query.world + " " + std::to_string(query.query);
    for (const PlannerAnswer& a : query.answers) {
      line += ", " + a.planner + " " + (a.solved() ? text_of("%.3f s", a.travel_time) : a.status);
      if (a.solved() && !a.valid) line += " INVALID";
    }
    progress_.line(line);
  }

  const PlannerStudyOptions& options_;
  const PlannerStudyProgress& progress_;
  std::vector<PlannerQuery> results_;
};

}  // namespace

std::vector<PlannerQuery> planner_study(const PlannerStudyOptions& options, const PlannerStudyProgress& progress) {
  return Study(options, progress).run();
}

}  // namespace arcway::peers
