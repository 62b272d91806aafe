#include "bench/peers/planner_study.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "arcway/datasets/catalog.h"
#include "arcway/datasets/plan_io.h"
#include "arcway/planner.h"
#include "arcway/turning_radii.h"
#include "bench/cpu_clock.h"
#include "bench/peers/ompl_peer.h"
#include "bench/peers/ours.h"
#include "bench/robots.h"
#include "bench/vehicle_worlds.h"

namespace arcway::internal::peers {
namespace {

using report::PlannerAnswer;
using report::PlannerQuery;

Planner make_planner(const World& world, const Vehicle& vehicle, GraphMode mode) {
  return {world, vehicle, backend_of(world, our_queries(world), our_reduced_graph(world)), {.graph_mode = mode}};
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

const std::vector<std::string> kFourClutters = {"clutter/convex/n100/m10/f15", "clutter/convex/n100/m10/f30",
                                                "clutter/star/n100/m10/f15", "clutter/star/n100/m10/f30"};

PlannerSetting vehicle_setting(const bench::KeptVehicle& kept) {
  return {.name = std::string(kept.name),
          .worlds = kFourClutters,
          .vehicle = kept.vehicle(),
          .scaled = true,
          .queries = 10,
          .shortest_too = false,
          .ompl_2_too = true};
}

PlannerSetting gentle_setting(const bench::GentleRobot& robot) {
  return {
      .name = robot.name(), .worlds = kFourClutters, .vehicle = robot.vehicle(), .queries = 10, .shortest_too = false};
}

bool has_faster_turns(const Vehicle& vehicle, const World& world) { return turning_radii(vehicle, world).size() > 1; }

class Study {
 public:
  Study(const PlannerSetting& setting, const PlannerStudyProgress& progress) : setting_(setting), progress_(progress) {}

  void run() {
    for (const std::string& world : setting_.worlds) progress_.world_done(run_world(world));
  }

  // The queries that were finished before a stop.
  std::vector<PlannerQuery> run_map(const PlannerMap& map) {
    const auto& [name, world, requests] = map;
    const Vehicle& vehicle = setting_.vehicle;
    const bench::CpuClock preparing(bench::CpuClock::Of::kProcess);
    const Planner planner = make_planner(world, vehicle, GraphMode::kEager);
    progress_.line(setting_.name + ", " + name + ": arcway prepared in " + text_of("%.3g s", preparing.seconds()));
    std::optional<Planner> tightest;
    if (has_faster_turns(vehicle, world))
      tightest = make_planner(world, bench::without_faster_turns(vehicle), GraphMode::kEager);
    std::vector<PlannerQuery> results;
    for (std::size_t q = 0; q < requests.size() && !progress_.stop.stop_requested(); ++q) {
      const Problem problem{world, vehicle, *planner.queries().sweep, requests[q]};
      PlannerQuery result{setting_.name, name, q, 0.0, {}};
      const double time = plan_ours(planner, problem, result);
      plan_from_the_map(problem, result);
      if (tightest) plan_tightest(*tightest, problem, result);
      if (!setting_.ours_only) run_peers(problem, tightest.has_value(), result, time);
      report(result);
      results.push_back(std::move(result));
    }
    return results;
  }

 private:
  std::vector<PlannerQuery> run_world(const std::string& name) {
    const Vehicle& vehicle = setting_.vehicle;
    if (!setting_.scaled)
      return run_map({name, catalog_world(name), catalog_queries(name, setting_.queries, setting_.seed)});
    const World world = bench::world_for(vehicle, name);
    return run_map({name, world, bench::queries_for(vehicle, world, setting_.queries, setting_.seed)});
  }

  // The travel time; infinity without a path.
  static double plan_ours(const Planner& planner, const Problem& problem, PlannerQuery& result) {
    const bench::CpuClock clock(bench::CpuClock::Of::kThread);
    const PlanResult plan = planner.plan(problem.request);
    const double seconds = clock.seconds();
    const auto add = [&](const char* name, double until, double time, const Path& path) {
      result.answers.push_back({name, name_of(plan.status), until, time, plan.solved() && is_valid(problem, path)});
    };
    result.lower_bound = plan.lower_bound;
    add("arcway", seconds, plan.travel_time, plan.path());
    // The planner's own clock is the wall's: its share of the plan is taken.
    const PlanStatistics& s = plan.statistics;
    const double share = plan.solved() ? s.first_path_seconds / s.total_seconds : 1.0;
    add("arcway first", share * seconds, s.first_travel_time, plan.first_path);
    return plan.solved() ? plan.travel_time : std::numeric_limits<double>::infinity();
  }

  // Plans with nothing prepared, as for a single query.
  static void plan_from_the_map(const Problem& problem, PlannerQuery& result) {
    const bench::CpuClock clock(bench::CpuClock::Of::kThread);
    const PlanResult plan = make_planner(problem.world, problem.vehicle, GraphMode::kLazy).plan(problem.request);
    const double seconds = clock.seconds();
    result.answers.push_back({"arcway, map and all", name_of(plan.status), seconds, plan.travel_time,
                              plan.solved() && is_valid(problem, plan.path())});
  }

  // By the speeds that the vehicle really has on the path.
  static void plan_tightest(const Planner& planner, const Problem& problem, PlannerQuery& result) {
    const bench::CpuClock clock(bench::CpuClock::Of::kThread);
    const PlanResult plan = planner.plan(problem.request);
    const double seconds = clock.seconds();
    const Path path = plan.path();
    result.answers.push_back({"arcway_tightest", name_of(plan.status), seconds, travel_time(path, problem.vehicle),
                              plan.solved() && is_valid(problem, path)});
  }

  void run_peers(const Problem& problem, bool has_wide_turns, PlannerQuery& result, double our_time) {
    Random random(setting_.seed + result.query);
    run_peer(OmplPlanner::kRrtConnect, problem, random, result, our_time);
    if (setting_.first_only) return;
    if (has_wide_turns) run_peer(OmplPlanner::kRrtConnectWide, problem, random, result, our_time);
    if (setting_.shortest_too) run_peer(OmplPlanner::kInformedRrtStar, problem, random, result, our_time);
    if (!setting_.ompl_2_too) return;
    for (const OmplPlanner kind : planners_of_ompl_2()) run_peer(kind, problem, random, result, our_time);
  }

  void run_peer(OmplPlanner kind, const Problem& problem, Random& random, PlannerQuery& result, double our_time) {
    std::vector<double> times = setting_.first_only ? std::vector<double>() : setting_.times;
    if (!setting_.first_only && result.query < setting_.long_queries) times.push_back(setting_.long_time);
    std::ranges::sort(times);
    const double first_within = times.empty() ? setting_.first_within : times.back();
    const PeerRun run = run_ompl(kind, problem, first_within, times, random);
    const auto add = [&](const std::string& when, double limit, const std::optional<PeerSolution>& solution) {
      const std::string planner = name_of(kind) + " " + when;
      if (!solution) {
        result.answers.push_back({planner, "no path in" + text_of(" %g s", limit), limit, 0.0, false});
        return;
      }
      result.answers.push_back(
          {planner, "solved", solution->seconds, solution->travel_time, is_valid(problem, solution->path)});
      if (solution->travel_time < our_time)
        progress_.lost(result.world + " " + planner + " " + plan_text(problem.request, *solution, result));
    };
    if (kind != OmplPlanner::kRrtConnectWide) add("first", first_within, run.first);
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

  const PlannerSetting& setting_;
  const PlannerStudyProgress& progress_;
};

}  // namespace

std::vector<PlannerSetting> standard_settings() {
  const auto clutters = [](const std::string& size) {
    std::vector<std::string> worlds;
    for (const char* kind : {"convex", "star"})
      for (const char* fill : {"f15", "f30", "f45"})
        worlds.push_back(std::string("clutter/") + kind + "/" + size + "/m10/" + fill);
    return worlds;
  };
  std::vector<PlannerSetting> settings;
  for (const bench::KeptVehicle& kept : bench::real_vehicles()) settings.push_back(vehicle_setting(kept));
  for (const bench::GentleRobot& robot : bench::kGentleRobots) settings.push_back(gentle_setting(robot));
  settings.push_back({.name = "n100", .worlds = clutters("n100"), .vehicle = Vehicle()});
  settings.push_back(
      {.name = "n1000", .worlds = clutters("n1000"), .vehicle = Vehicle(), .queries = 5, .long_queries = 5});
  return settings;
}

void planner_study(const PlannerSetting& setting, const PlannerStudyProgress& progress) {
  Study(setting, progress).run();
}

std::vector<PlannerQuery> compare_planners(const PlannerSetting& setting, const PlannerMap& map,
                                           const PlannerStudyProgress& progress) {
  return Study(setting, progress).run_map(map);
}

}  // namespace arcway::internal::peers
