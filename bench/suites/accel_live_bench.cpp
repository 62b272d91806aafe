#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arcway/accel/accel_backend.h"
#include "arcway/angle.h"
#include "arcway/datasets/map_file.h"
#include "arcway/replan.h"
#include "arcway/validation.h"
#include "bench/cpu_clock.h"
#include "bench/quantiles.h"
#include "bench/robots.h"
#include "bench/suites/corruption.h"
#include "bench/suites/plans.h"
#include "bench/suites/suite.h"
#include "bench/vehicle_worlds.h"
#include "datasets/io/random.h"

// A drive through a map that changes: in each cycle an obstacle moves, vanishes or comes back, the planner follows, and
// the vehicle plans on from where it is. Every motion is validated. The same seeds give the same changes.
namespace arcway::internal::bench::accel_live_suite {
namespace {

constexpr double kDeadline = 0.01;  // for a plan within a cycle [s]
constexpr double kStep = 0.1;       // of the extent of an obstacle: how far it moves in a cycle

// Seconds of processor time of each cycle, and what came of them.
struct Drive {
  std::vector<double> changes, cycles;
  std::size_t with_motion = 0, to_goal = 0, goals = 0;
  bool is_valid = true;
};

// An obstacle that moves, and its key while it is there.
struct Mover {
  Polygon polygon;
  ObstacleKey key;
  bool is_there = true;
};

class LiveMap {
 public:
  LiveMap(const KeptVehicle& kept, const std::string& world_name)
      : world_(shared_world(kept, world_name)),
        planner_(world_, kept.vehicle(), accel_backend(world_, kSerialExecutor)),
        queries_(queries_for(kept.vehicle(), world_, kGoals, 1)) {
    const std::vector<Polygon> obstacles = to_map_file(world_).obstacles;
    for (ObstacleId o = 0; o < world_.obstacle_count(); ++o) movers_.push_back({obstacles[o], world_.key_of(o)});
    driven_ = planner_.plan(queries_[0]).trajectory();
  }

  // One cycle of `period` seconds.
  void drive_on(double period, Drive& drive) {
    time_ = std::min(time_ + period, driven_->duration());
    const auto [removed, added, mover] = next_change();
    const CpuClock clock(CpuClock::Of::kThread);
    planner_ = planner_.with_obstacles(removed, added);
    drive.changes.push_back(clock.seconds());
    const TrajectoryState now = driven_->at(time_);
    if (now.time >= driven_->duration()) {
      drive.goals += is_to_goal_;
      ++goal_;
    }
    const Pose goal = queries_[goal_ % queries_.size()].goal;
    const Replan next = replan(planner_, *driven_, time_, {.goal = goal, .limits = {.time = kDeadline}});
    drive.cycles.push_back(clock.seconds());
    if (mover != nullptr && !added.empty())
      mover->key = planner_.world().key_of(static_cast<ObstacleId>(planner_.world().obstacle_count() - 1));
    is_to_goal_ = next.motion == NextMotion::kPlanned || next.motion == NextMotion::kKept;
    drive.with_motion += next.motion != NextMotion::kNoMotion;
    drive.to_goal += is_to_goal_;
    if (next.segments.empty()) return;
    drive.is_valid = drive.is_valid && is_right(next, now);
    driven_.emplace(next.segments, planner_.vehicle());
    time_ = 0.0;
  }

 private:
  static constexpr std::size_t kGoals = 20;

  struct Change {
    std::vector<ObstacleKey> removed;
    std::vector<Polygon> added;
    Mover* mover;
  };

  // A change that leaves the vehicle where it is: nothing comes closer to it than its length.
  Change next_change() {
    Mover& mover = movers_[random_.below(movers_.size())];
    Change change{{}, {}, &mover};
    if (mover.is_there) change.removed.push_back(mover.key);
    if (mover.is_there && random_.below(4) == 0) {
      mover.is_there = false;
      return change;
    }
    Box box;
    for (const Vec2& p : mover.polygon.outer) box.extend(p);
    const double angle = kTwoPi * random_.uniform();
    Polygon moved = mover.polygon;
    for (Vec2& p : moved.outer) p += kStep * (box.max - box.min).norm() * direction_of(angle);
    const double room = 2.0 * planner_.vehicle().footprint().farthest();
    const Pose at = driven_->at(time_).pose;
    const bool is_near = box.grown(room + kStep * (box.max - box.min).norm()).contains(at.position());
    if (is_near) return {{}, {}, nullptr};
    mover.polygon = moved;
    mover.is_there = true;
    change.added.push_back(std::move(moved));
    return change;
  }

  [[nodiscard]] bool is_right(const Replan& next, const TrajectoryState& now) const {
    TimedPath path = timed_path_of(next.segments);
    if (corrupting()) path.segments.back().length += 0.01;
    return validate(planner_.world(), planner_.vehicle(), now.pose, next.segments.back().segment.end(), path,
                    {.start_speed = now.signed_speed()})
        .valid();
  }

  const World& world_;
  Planner planner_;
  std::vector<PlanRequest> queries_;
  std::vector<Mover> movers_;
  std::optional<Trajectory> driven_;
  double time_ = 0.0;
  std::size_t goal_ = 0;
  bool is_to_goal_ = true;
  Random random_{7};
};

void time_drive(benchmark::State& state, const KeptVehicle& kept, const std::string& world_name, double rate,
                std::size_t cycles) {
  Drive drive;
  for (auto _ : state) {
    LiveMap map(kept, world_name);
    for (std::size_t i = 0; i < cycles; ++i) map.drive_on(1.0 / rate, drive);
  }
  if (!require(state, drive.is_valid, "the validator refuses a motion")) return;
  set_batch(state, cycles);
  const auto count = static_cast<double>(drive.cycles.size());
  state.counters["change_seconds_median"] = median(drive.changes);
  state.counters["cycle_seconds_median"] = median(drive.cycles);
  state.counters["cycle_seconds_p99"] = quantile(drive.cycles, 0.99);
  state.counters["cycle_seconds_worst"] = quantile(drive.cycles, 1.0);
  state.counters["motion_share"] = static_cast<double>(drive.with_motion) / count;
  state.counters["goal_share"] = static_cast<double>(drive.to_goal) / count;
  state.counters["goals_reached"] = static_cast<double>(drive.goals);
}

void add(Study study) {
  const std::size_t cycles = study == Study::kCheck ? 30 : 1000;
  const std::string world = clutter_name("convex", study == Study::kCheck ? 30 : 150, 10, 15);
  for (const double rate : {10.0, 50.0})
    add_benchmark("Live/amr/hertz:" + std::to_string(static_cast<int>(rate)),
                  [world, rate, cycles](benchmark::State& state) {
                    time_drive(state, real_vehicles().front(), world, rate, cycles);
                  })
        ->Iterations(1)
        ->Repetitions(1);
}

const Suite suite(add, Takes::kAllButQuick);

}  // namespace
}  // namespace arcway::internal::bench::accel_live_suite
