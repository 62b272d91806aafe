#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/geometry/closed_spline.h"
#include "core/geometry/polygon.h"
#include "core/planner.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// A ring that is a curve.
struct CurvedRing {
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
  double last = 0.001;   ///< of the pieces near the path in the end [m]
  double factor = 0.25;  ///< between two rounds, in (0, 1)
  std::size_t max_rounds = 30;
};

struct CurvedPlanRound {
  double tolerance;      ///< the smallest one of all pieces [m]
  std::size_t vertices;  ///< of the world
  PlanStatus status;
  double travel_time;  ///< [s]; infinite without a path
};

struct CurvedPlan {
  Planner planner;    ///< of the last round
  PlanResult result;  ///< valid among the curves too, as the rings contain them
  std::vector<CurvedPlanRound> rounds;
};

/// Plans among curves, refined where it matters: begins with coarse rings, then plans again with a finer tolerance for
/// the pieces that lie within two body lengths of the path, until all of those have the last tolerance. Without a path
/// every piece is refined.
/// @param make_planner  called once a round.
/// @param limits        of each round; an interrupted one is the last.
/// @throws what World, Planner and circumscribed_ring throw; std::invalid_argument for tolerances out of range, or
///   naming a curve whose ring is not there.
CurvedPlan plan_among_curves(const CurvedWorld& world, const PlanRequest& request, const CurveTolerances& tolerances,
                             const std::function<Planner(const World&)>& make_planner, const PlanLimits& limits = {});
/// The same with the reference queries.
CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                             const CurveTolerances& tolerances = {}, const PlannerOptions& options = {});

}  // namespace arcway
