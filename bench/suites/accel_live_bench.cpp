#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arcway/accel/accel_backend.h"
#include "arcway/validation.h"
#include "bench/live/live_drive.h"
#include "bench/live/live_planner.h"
#include "bench/quantiles.h"
#include "bench/resident_memory.h"
#include "bench/robots.h"
#include "bench/suites/corruption.h"
#include "bench/suites/live_cycles.h"
#include "bench/suites/plans.h"
#include "bench/suites/suite.h"
#include "bench/vehicle_worlds.h"
#ifdef ARCWAY_PEER_OMPL
#include "bench/peers/ompl_live.h"
#endif

// A drive through a map in which obstacles move, vanish and come back. In each cycle the planner follows the change,
// and the vehicle plans on from where it is. The same seeds give the same walks of obstacles, as far as the motions of
// the vehicle are the same.
namespace arcway::internal::bench::accel_live_suite {
namespace {

constexpr std::size_t kGoals = 20;
// For changing the map and planning on in a cycle [s]. What takes longer than it may still ends within 10 ms then.
constexpr double kWithin = 0.008;
// Cycles that are planned without a time limit, to compare planners.
constexpr int kCompared = 5;

using MakePlanner = std::function<std::unique_ptr<LivePlanner>(const World&, const Vehicle&)>;

Planner lazy_planner(const World& world, const Vehicle& vehicle) {
  return {world, vehicle, accel_backend(world, kSerialExecutor)};
}

std::unique_ptr<LivePlanner> changed_planner(const World& world, const Vehicle& vehicle) {
  return std::make_unique<ChangedPlanner>(lazy_planner(world, vehicle));
}

std::unique_ptr<LivePlanner> rebuilt_planner(const World& world, const Vehicle& vehicle) {
  return std::make_unique<RebuiltPlanner>(lazy_planner(world, vehicle),
                                          [](const World& w) { return accel_backend(w, kSerialExecutor); });
}

// A drive of a kept vehicle in a world of the catalog.
struct Route {
  const World& world;
  Vehicle vehicle;
  std::vector<Pose> goals;
  Trajectory first;  // to the first of them

  Route(const KeptVehicle& kept, const std::string& world_name)
      : world(shared_world(kept, world_name)), vehicle(kept.vehicle()), first(plan_first(*this)) {}

 private:
  static Trajectory plan_first(Route& route) {
    const std::vector<PlanRequest> requests = queries_for(route.vehicle, route.world, kGoals, 1);
    for (const PlanRequest& request : requests) route.goals.push_back(request.goal);
    return lazy_planner(route.world, route.vehicle).plan(requests.front()).trajectory();
  }
};

bool is_right(const LiveCycle& cycle, const World& world, const Vehicle& vehicle) {
  if (cycle.next.segments.empty()) return true;
  TimedPath path = timed_path_of(cycle.next.segments);
  if (corrupting()) path.segments.back().length += 0.01;
  return validate(world, vehicle, cycle.now.pose, cycle.next.segments.back().segment.end(), path,
                  {.start_speed = cycle.now.signed_speed()})
      .valid();
}

bool are_same(const TimedSegment& a, const TimedSegment& b) {
  return a.segment.start == b.segment.start && a.segment.length == b.segment.length &&
         a.segment.curvature == b.segment.curvature && a.segment.gear == b.segment.gear && a.speed_in == b.speed_in &&
         a.speed_out == b.speed_out && a.duration == b.duration;
}

// Whether planners that follow changes, and planners made anew, give the same motions where time does not matter.
bool agree(const Route& route) {
  const LiveSetting setting{.within = std::numeric_limits<double>::infinity()};
  const std::unique_ptr<LivePlanner> changed = changed_planner(route.world, route.vehicle);
  const std::unique_ptr<LivePlanner> rebuilt = rebuilt_planner(route.world, route.vehicle);
  LiveDrive drive(*changed, route.first, route.goals, setting), other(*rebuilt, route.first, route.goals, setting);
  for (int i = 0; i < kCompared; ++i) {
    const LiveCycle one = drive.next_cycle(), two = other.next_cycle();
    if (one.next.motion != two.next.motion || !std::ranges::equal(one.next.segments, two.next.segments, are_same))
      return false;
  }
  return true;
}

// What came of the cycles of a drive.
struct Record {
  std::vector<double> changes, cycles;  // processor time [s]
  std::size_t with_motion = 0, to_goal = 0, repaired = 0, braking = 0;
  std::int64_t resident_early = 0, resident = 0;  // after a tenth of the cycles, and at the end

  void add(const LiveCycle& cycle) {
    changes.push_back(cycle.change_seconds);
    cycles.push_back(cycle.seconds());
    with_motion += cycle.next.motion != NextMotion::kNoMotion;
    braking += cycle.next.motion == NextMotion::kBraking;
    repaired += cycle.next.motion == NextMotion::kRepaired;
    to_goal += cycle.leads_to_goal();
  }
  void report(benchmark::State& state) const {
    const auto share = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(cycles.size());
    };
    state.counters["change_seconds_median"] = median(changes);
    state.counters["cycle_seconds_median"] = median(cycles);
    state.counters["cycle_seconds_p99"] = quantile(cycles, 0.99);
    state.counters["cycle_seconds_worst"] = quantile(cycles, 1.0);
    state.counters["motion_share"] = share(with_motion);
    state.counters["goal_share"] = share(to_goal);
    state.counters["repaired_share"] = share(repaired);
    state.counters["stop_share"] = share(braking);
    state.counters["resident_bytes_early"] = static_cast<double>(resident_early);
    state.counters["resident_bytes"] = static_cast<double>(resident);
  }
};

void time_drive(benchmark::State& state, const Route& route, const MakePlanner& make, double rate, std::size_t cycles) {
  Record record;
  std::size_t goals = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const std::unique_ptr<LivePlanner> planner = make(route.world, route.vehicle);
    LiveDrive drive(*planner, route.first, route.goals, {.rate = rate, .within = kWithin});
    for (std::size_t i = 0; i < cycles; ++i) {
      state.ResumeTiming();
      const LiveCycle cycle = drive.next_cycle();
      state.PauseTiming();
      record.add(cycle);
      if (!require(state, is_right(cycle, planner->world(), route.vehicle), "the validator refuses a motion")) return;
      if (i == cycles / 10) record.resident_early = resident_bytes();
    }
    goals = drive.goals_reached();
    record.resident = resident_bytes();
    state.ResumeTiming();
  }
  set_batch(state, cycles);
  record.report(state);
  state.counters["goals_reached"] = static_cast<double>(goals);
}

std::vector<std::pair<std::string, MakePlanner>> all_planners() {
  std::vector<std::pair<std::string, MakePlanner>> planners{{"changed", changed_planner}, {"rebuilt", rebuilt_planner}};
#ifdef ARCWAY_PEER_OMPL
  planners.emplace_back("ompl_rrtconnect_wide", [](const World& world, const Vehicle& vehicle) {
    return std::make_unique<peers::OmplLivePlanner>(world, vehicle, accel_backend(world, kSerialExecutor));
  });
#endif
  return planners;
}

void add(Study study) {
  const bool is_check = study == Study::kCheck;
  const std::size_t cycles = live_cycles() > 0 ? live_cycles() : is_check ? 30 : 1000;
  const std::string world = clutter_name("convex", is_check ? 30 : 150, 10, 15);
  for (const auto& [name, make] : all_planners())
    for (const double rate : {10.0, 50.0})
      add_benchmark("Live/amr/" + name + "/hertz:" + std::to_string(static_cast<int>(rate)),
                    [world, make = make, rate, cycles](benchmark::State& state) {
                      const Route route(real_vehicles().front(), world);
                      if (!require_once(
                              state, "Live/" + world, [&] { return agree(route); },
                              "planners that follow changes and new ones give different motions"))
                        return;
                      time_drive(state, route, make, rate, cycles);
                    })
          ->Iterations(1)
          ->Repetitions(1);
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_live_suite
