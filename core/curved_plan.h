#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/closed_spline.h"
#include "core/geometry/polygon.h"
#include "core/planner.h"
#include "core/vehicle.h"
#include "core/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// A world with curved obstacles, for planning on circumscribed rings.
struct CurvedWorld {
  std::vector<Polygon> polygons;
  /// Closed chains of cubics, the obstacle on their left: see circumscribed_ring.
  std::vector<std::vector<CubicBezier>> curves;
  std::optional<Ring> bounds;
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
  World world;        ///< of the last round
  PlanResult result;  ///< valid among the curves too, as the rings contain them
  std::vector<CurvedPlanRound> rounds;
};

/// Plans among curves, refined where it matters: begins with coarse rings, then plans again with a finer tolerance for
/// the pieces that lie within two body lengths of the path, until all of those have the last tolerance. Without a path
/// every piece is refined. Each round is a whole Planner with the reference queries.
/// @throws what World, Planner and circumscribed_ring throw; std::invalid_argument for tolerances out of range.
CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                             const CurveTolerances& tolerances = {}, const PlannerOptions& options = {});

}  // namespace arcway
