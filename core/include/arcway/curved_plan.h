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

/// A ring that is a curve.
struct ARCWAY_API CurvedRing {
  static constexpr std::size_t kBounds = std::numeric_limits<std::size_t>::max();
  std::size_t polygon;  ///< or kBounds
  std::size_t ring;     ///< 0: the outer one; else a hole, from 1
  /// A closed chain of cubics, the obstacle on its left: see circumscribed_ring.
  std::vector<CubicBezier> pieces;
};

/// A world with curved obstacles, for planning on circumscribed rings.
struct CurvedWorld {
  std::vector<Polygon> polygons;
  std::optional<Ring> bounds;
  std::vector<CurvedRing> curves;  ///< take the place of these rings, whatever those are
};

struct CurveTolerances {
  double first = 0.5;    ///< of all pieces at the beginning [m]
  double last = 0.001;   ///< of the pieces near the path in the end [m]; or a sixteenth of the safety margin, if more
  double factor = 0.25;  ///< from one to the next, in (0, 1)
  std::size_t max_iterations = 30;
};

struct CurvedPlanIteration {
  double tolerance;      ///< the smallest one of all pieces [m]
  std::size_t vertices;  ///< of the world
  PlanStatus status;
  double travel_time;  ///< [s]; infinite without a path
};

struct CurvedPlan {
  Planner planner;    ///< of the last iteration
  PlanResult result;  ///< free among its rings, and so among the curves; statistics of the iteration that found it
  std::vector<CurvedPlanIteration> iterations;
};

/// Plans among curves, refined where it matters: begins with coarse rings, then plans again with a finer tolerance for
/// the pieces that lie within two body lengths of the path, until all of those have the last tolerance. Without a path
/// every piece is refined. Rings that stay as they were are not planned on again.
///
/// The cheapest plan of all iterations is kept, if it is free among the rings of the last one. It is, but for rounding:
/// finer rings lie inside of coarser ones. So what an iteration finds on finer rings never makes the plan slower. Nor
/// does a smaller `last`, if the larger one is one of the tolerances on the way to it: `first` times a power of
/// `factor`.
///
/// Finer rings than within a sixteenth of the safety margin cannot matter: where the body grown by 9/16 of it is free
/// among the curves, the body grown by half of it, which is what a planner checks, is free among such rings.
/// @param make_planner  called once an iteration, each time for a vehicle of the same body and margin.
/// @param limits        of all iterations together, their planners' making included, which is not interrupted itself.
/// The
///   best plan found by then is given.
/// @throws what World, Planner and circumscribed_ring throw; std::invalid_argument for tolerances out of range, or
///   naming a curve whose ring is not there.
ARCWAY_API CurvedPlan plan_among_curves(const CurvedWorld& world, const PlanRequest& request,
                                        const CurveTolerances& tolerances,
                                        const std::function<Planner(const World&)>& make_planner,
                                        const PlanLimits& limits = {});
/// The same with the reference queries.
ARCWAY_API CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                                        const CurveTolerances& tolerances = {}, const PlannerOptions& options = {});

}  // namespace arcway
