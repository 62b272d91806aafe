#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "arcway/closed_spline.h"
#include "arcway/export.h"
#include "arcway/planner.h"
#include "arcway/polygon.h"
#include "arcway/vehicle.h"
#include "arcway/world.h"

namespace arcway {

/// A curve in place of one ring of a CurvedWorld.
struct ARCWAY_API CurvedRing {
  static constexpr std::size_t kBounds = std::numeric_limits<std::size_t>::max();
  std::size_t polygon;  ///< index of the polygon, or kBounds
  std::size_t ring;     ///< 0: its outer ring; i > 0: its hole i - 1
  /// A closed chain of cubics with the obstacle on its left, see circumscribed_ring.
  std::vector<CubicBezier> pieces;
};

/// A world with curved obstacles, for planning on circumscribed rings.
struct CurvedWorld {
  std::vector<Polygon> polygons;
  std::optional<Ring> bounds;
  std::vector<CurvedRing> curves;  ///< each replaces a ring of `polygons` or the bounds, whatever that holds
};

/// How closely rings follow the curves in the iterations of plan_among_curves.
struct CurveTolerances {
  double first = 0.5;  ///< of all pieces in the first iteration [m]
  double last =
      0.001;  ///< of the pieces near the path in the end [m]; a sixteenth of the safety margin if that is more
  double factor = 0.25;             ///< from one tolerance to the next, in (0, 1)
  std::size_t max_iterations = 30;  ///< at least 1
};

/// What one iteration planned on and found.
struct CurvedPlanIteration {
  double tolerance;      ///< the smallest one of all pieces [m]
  std::size_t vertices;  ///< of the world
  PlanStatus status;
  double travel_time;  ///< [s]; infinite without a path
};

/// The result of plan_among_curves.
struct CurvedPlan {
  Planner planner;    ///< of the last iteration
  PlanResult result;  ///< free among the rings of `planner`, and so among the curves; its statistics are those of the
                      ///< iteration that found it
  std::vector<CurvedPlanIteration> iterations;
};

/// Plans among curved obstacles, on polygons that are refined where it matters:
/// 1. All curves become coarse rings, and the planner plans on them.
/// 2. The pieces within two body lengths of the path get a finer tolerance; without a path, all pieces do.
/// 3. The planner plans again, until all pieces near the path have the last tolerance.
///
/// The cheapest plan of all iterations is kept if it is free among the last rings. It is, but for rounding, as finer
/// rings lie inside coarser ones. A further iteration therefore never makes the plan slower. A smaller `last` does not
/// either, if the larger one is `first` times a power of `factor`.
///
/// Rings finer than a sixteenth of the safety margin cannot matter. A planner checks the body grown by half of the
/// margin. Where the body grown by 9/16 of it is free among the curves, the planner's body is free among such rings.
/// @param make_planner  called once an iteration, for vehicles of one body and margin.
/// @param limits  for all iterations together, construction of planners included; a construction is not interrupted.
///   The best plan found by then is returned.
/// @throws std::invalid_argument for tolerances out of range, or naming a curve whose ring does not exist; and what
///   World, Planner and circumscribed_ring throw.
ARCWAY_API CurvedPlan plan_among_curves(const CurvedWorld& world, const PlanRequest& request,
                                        const CurveTolerances& tolerances,
                                        const std::function<Planner(const World&)>& make_planner,
                                        const PlanLimits& limits = {});
/// Overload with planners of reference_backend.
ARCWAY_API CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                                        const CurveTolerances& tolerances = {}, const PlannerOptions& options = {});

}  // namespace arcway
