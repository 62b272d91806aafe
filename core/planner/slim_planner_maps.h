#pragma once

#include <memory>

#include "arcway/planner.h"
#include "arcway/stop_clock.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_rows.h"
#include "core/attach/roadmap.h"
#include "core/base/late_value.h"

namespace arcway::internal {

struct PlannerMaps;

/// The maps of a planner for a slimmer body, see PlanSlimBody. Made when first asked for. Thread-safe.
class SlimPlannerMaps {
 public:
  /// @param map  of the real body; must outlive this.
  /// @param obstacles  the sweep query that knows no zones.
  /// @param options  of the planner of the real body.
  /// @param rows  of the reduced graph.
  SlimPlannerMaps(const Roadmap& map, std::shared_ptr<const SweepQuery> obstacles, PlannerOptions options,
                  std::shared_ptr<const VisibilityRows> rows);

  /// The maps; null if the clock is over before they are made. Their graphs are lazy, so that this takes O(vertices).
  [[nodiscard]] const PlannerMaps* operator()(const StopClock& clock) const;

 private:
  const Roadmap& map_;
  std::shared_ptr<const SweepQuery> obstacles_;
  PlannerOptions options_;
  std::shared_ptr<const VisibilityRows> rows_;
  LateValue<std::shared_ptr<const PlannerMaps>> maps_;
};

}  // namespace arcway::internal
