#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "arcway/executor.h"
#include "arcway/path.h"
#include "arcway/planner.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_rows.h"
#include "core/collision/clearance_cost.h"
#include "core/gaps/bottleneck_finder.h"
#include "core/planner/plan_maps.h"
#include "core/planner/slim_maps.h"
#include "core/planner/slim_planner_maps.h"
#include "core/search/point_distance.h"
#include "core/search/zone_routes.h"

namespace arcway::internal {

/// The routes that rows of the strategy look for, in their order.
std::vector<OtherRoute> routes_of_strategy();

struct PlannerMaps;

/// The maps of a planner before a change, for those after it.
struct MapsBefore {
  const PlannerMaps& maps;
  LazyGraphs::Change change;
};

/// All that the queries of one planner share. Immutable but for what is made when first asked for; thread-safe.
struct PlannerMaps {
  /// @param map       of all radii, without a clearance cost.
  /// @param obstacles  the sweep query that knows no zones, used during the call only.
  /// @param rows      of the reduced graph.
  /// @param executor  used during the call only; may end it, see end_if_over.
  /// @param before    of the world before a change; null if all is made anew.
  PlannerMaps(Roadmap map, const std::shared_ptr<const SweepQuery>& obstacles, const PlannerOptions& options,
              const std::shared_ptr<const VisibilityRows>& rows, const Executor& executor,
              const MapsBefore* before = nullptr);
  PlannerMaps(const PlannerMaps&) = delete;  // members refer to `all`

  /// The roadmap of all radii for paths that are driven in a gear all the way, described as if driven forwards. Both
  /// gears have the same one where no zone forbids a direction.
  [[nodiscard]] const Roadmap& in(Gear gear) const {
    return gear == Gear::kReverse && backwards ? *backwards : all.plain;
  }

  std::shared_ptr<const FeasibleGraph> base_graph;      ///< of all radii, without the circles of a preference
  std::shared_ptr<const ClearanceCost> clearance_cost;  ///< of preference and zones, if there are any, whatever it is
  PlanMaps all;
  std::optional<Roadmap> backwards;  ///< see `in`
  SlimMaps slim;
  SlimPlannerMaps slim_plans;
  std::optional<PlanMaps> tightest;  ///< of the tightest radii only, where there are wider ones
  OtherMaps other;                   ///< of several radii, where there are wider ones
  std::optional<PointDistance> point_distance;
  std::optional<ZoneRoutes> zone_routes;  ///< where zones limit the speed
  BottleneckFinder bottleneck;
};

}  // namespace arcway::internal
