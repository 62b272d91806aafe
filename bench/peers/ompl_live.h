#pragma once

#include "arcway/backend.h"
#include "arcway/vehicle.h"
#include "bench/live/live_planner.h"
#include "datasets/io/random.h"

namespace arcway::internal::peers {

/// OMPL's RRTConnect in a drive, with shortcuts of all radii until its time is up. It asks the same queries as arcway's
/// planners; those follow each change by Backend::changed. Paths are driven by arcway's fastest speed profile from the
/// vehicle's speed on, and count as none where that cannot brake in time. The rest of a motion and braking are those of
/// arcway::replan.
class OmplLivePlanner final : public bench::LivePlanner {
 public:
  OmplLivePlanner(const World& world, const Vehicle& vehicle, Backend backend);
  void change(const bench::MapChange& change) override;
  [[nodiscard]] Replan next(const Trajectory& driven, double time, const ReplanOptions& options) const override;
  [[nodiscard]] const World& world() const override { return world_; }

 private:
  [[nodiscard]] PlanResult plan(const PlanRequest& request, const PlanLimits& limits) const;

  World world_;
  Vehicle vehicle_;
  Backend backend_;
  mutable Random random_{1};
};

}  // namespace arcway::internal::peers
