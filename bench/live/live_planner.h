#pragma once

#include <functional>
#include <utility>

#include "arcway/backend.h"
#include "arcway/planner.h"
#include "arcway/replan.h"
#include "arcway/trajectory.h"
#include "bench/live/walking_obstacles.h"

namespace arcway::internal::bench {

/// Who plans in a drive through a map that changes.
class LivePlanner {
 public:
  virtual ~LivePlanner() = default;
  /// Follows a change of the map.
  virtual void change(const MapChange& change) = 0;
  /// What the vehicle does next: see arcway::replan.
  [[nodiscard]] virtual Replan next(const Trajectory& driven, double time, const ReplanOptions& options) const = 0;
  /// The map after the last change.
  [[nodiscard]] virtual const World& world() const = 0;
};

/// Follows each change by Planner::change_obstacles.
class ChangedPlanner final : public LivePlanner {
 public:
  explicit ChangedPlanner(Planner planner) : planner_(std::move(planner)) {}
  void change(const MapChange& change) override;
  [[nodiscard]] Replan next(const Trajectory& driven, double time, const ReplanOptions& options) const override;
  [[nodiscard]] const World& world() const override { return planner_.world(); }
  [[nodiscard]] const Planner& planner() const { return planner_; }

 private:
  Planner planner_;
};

/// Makes a backend and a planner anew after each change.
class RebuiltPlanner final : public LivePlanner {
 public:
  using MakeBackend = std::function<Backend(const World&)>;
  /// @param make_backend  and options: of the planners after changes.
  RebuiltPlanner(Planner planner, MakeBackend make_backend, PlannerOptions options = {});
  void change(const MapChange& change) override;
  [[nodiscard]] Replan next(const Trajectory& driven, double time, const ReplanOptions& options) const override;
  [[nodiscard]] const World& world() const override { return planner_.world(); }

 private:
  MakeBackend make_backend_;
  PlannerOptions options_;
  Planner planner_;
};

/// The world after a change.
World changed(const World& world, const MapChange& change);

}  // namespace arcway::internal::bench
