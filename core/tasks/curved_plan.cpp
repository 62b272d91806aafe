#include "arcway/curved_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/infinity.h"
#include "core/base/stopwatch.h"
#include "core/planner/no_path.h"
#include "core/tasks/measure_clearance.h"
#include "core/tasks/plan_cost.h"

namespace arcway {

using namespace internal;
namespace {

// The finest tolerance as a share of the safety margin. The body is checked grown by half of the margin. Where it is
// free among the curves when grown by 9/16, it is free among such rings.
constexpr double kFinestShare = 1.0 / 16.0;

// Positions along the path, no two neighbors farther apart.
std::vector<Vec2> samples_of(const PlanResult& result, double spacing) {
  std::vector<Vec2> samples = polyline(result.path(), spacing);
  samples.push_back(result.goal.position());
  return samples;
}

class CurvedPlanner {
 public:
  CurvedPlanner(const CurvedWorld& world, const CurveTolerances& tolerances)
      : world_(world), limits_(tolerances), level_(tolerances.first) {
    for (std::size_t i = 0; i < world.curves.size(); ++i) {
      const CurvedRing& curve = world.curves[i];
      const bool there =
          curve.polygon == CurvedRing::kBounds
              ? world.bounds.has_value() && curve.ring == 0
              : curve.polygon < world.polygons.size() && curve.ring <= world.polygons[curve.polygon].holes.size();
      if (!there) throw std::invalid_argument("curve " + std::to_string(i) + ": there is no such ring");
      tolerances_.emplace_back(curve.pieces.size(), limits_.first);
    }
  }

  [[nodiscard]] World make_world() const {
    std::vector<Polygon> obstacles = world_.polygons;
    std::optional<Ring> bounds = world_.bounds;
    for (std::size_t i = 0; i < tolerances_.size(); ++i) {
      const CurvedRing& curve = world_.curves[i];
      Ring ring = circumscribed_ring(curve.pieces, tolerances_[i]);
      if (curve.polygon == CurvedRing::kBounds) {
        bounds = std::move(ring);
      } else {
        Polygon& polygon = obstacles[curve.polygon];
        (curve.ring == 0 ? polygon.outer : polygon.holes[curve.ring - 1]) = std::move(ring);
      }
    }
    return World(std::move(obstacles), std::move(bounds));
  }
  /// The smallest tolerance of all pieces.
  [[nodiscard]] double level() const { return level_; }
  /// Brings the pieces near the path to the level, without a path every piece; once all of those are there, to the next
  /// level. So which rings are planned on at a level does not depend on the levels to come.
  /// @returns whether anything was left to refine.
  bool refine(const PlanResult& plan, const Vehicle& vehicle) {
    const double finest = std::max(limits_.last, kFinestShare * vehicle.safety_margin());
    const std::vector<double*> near = near_pieces(plan, vehicle.footprint());
    if (std::ranges::all_of(near, [&](const double* tolerance) { return *tolerance <= level_; })) {
      if (near.empty() || level_ <= finest) return false;
      level_ = std::max(finest, level_ * limits_.factor);
    }
    for (double* tolerance : near) *tolerance = level_;
    return true;
  }

 private:
  // The tolerances of the pieces near a plan.
  std::vector<double*> near_pieces(const PlanResult& plan, const Footprint& body) {
    const double reach = 2.0 * body.length();
    const std::vector<Vec2> samples = samples_of(plan, 0.5 * reach);
    std::vector<double*> near;
    for (std::size_t i = 0; i < tolerances_.size(); ++i) {
      for (std::size_t k = 0; k < tolerances_[i].size(); ++k) {
        double& tolerance = tolerances_[i][k];
        Box hull;
        for (const Vec2& p : world_.curves[i].pieces[k].p) hull.extend(p);
        const auto is_near = [&](const Vec2& p) { return hull.distance_to(p) <= reach + tolerance; };
        if (!plan.solved() || std::ranges::any_of(samples, is_near)) near.push_back(&tolerance);
      }
    }
    return near;
  }

  const CurvedWorld& world_;
  CurveTolerances limits_;
  double level_;
  std::vector<std::vector<double>> tolerances_;  // of each curve and piece
};

// Whether a plan is free among the last rings. Finer rings lie inside coarser ones, up to the distance that both are
// moved by (see circumscribed_ring). A plan stays free unless it was free by less than that.
bool is_free(const Planner& planner, const PlanResult& plan) { return planner.is_free(plan.path()); }

// Replaces a plan made on coarser rings by the planner's new one, unless that costs more.
void keep_cheaper(const Planner& planner, double cusp_cost, PlanResult&& found, PlanResult& plan) {
  if (cost_of(found, cusp_cost) <= cost_of(plan, cusp_cost) || !is_free(planner, plan)) {
    plan = std::move(found);
    return;
  }
  measure_clearance(planner.world(), planner.vehicle(), plan);
  plan.scene = found.scene;
  plan.lower_bound = std::min(plan.lower_bound, found.lower_bound);  // among finer rings there may be shorter ways
  plan.interrupted = found.interrupted;
}

}  // namespace

CurvedPlan plan_among_curves(const CurvedWorld& world, const PlanRequest& request, const CurveTolerances& tolerances,
                             const std::function<Planner(const World&)>& make_planner, const PlanLimits& limits) {
  if (!(tolerances.last > 0.0 && tolerances.last <= tolerances.first && std::isfinite(tolerances.first)))
    throw std::invalid_argument("curve tolerances: need 0 < last <= first, finite");
  if (!(tolerances.factor > 0.0 && tolerances.factor < 1.0))
    throw std::invalid_argument("curve tolerances: factor must be in (0, 1)");
  if (tolerances.max_iterations < 1) throw std::invalid_argument("curve tolerances: max_iterations must be at least 1");
  const Stopwatch watch;
  const auto rest = [&] {
    PlanLimits left = limits;
    left.time -= watch.seconds();
    return left;
  };
  CurvedPlanner curved(world, tolerances);
  CurvedPlan plan{make_planner(curved.make_world()), {}, {}};
  const auto plan_iteration = [&] {
    PlanResult found = plan.planner.plan(request, rest());
    plan.iterations.push_back({curved.level(), plan.planner.world().vertices().size(), found.status,
                               found.solved() ? found.travel_time : kInfinity});
    return found;
  };
  plan.result = plan_iteration();
  for (std::size_t iteration = 1; iteration < tolerances.max_iterations && !plan.result.interrupted; ++iteration) {
    if (!curved.refine(plan.result, plan.planner.vehicle())) break;
    const World rings = curved.make_world();
    if (std::ranges::equal(rings.vertices(), plan.planner.world().vertices())) {
      plan.iterations.back().tolerance = curved.level();  // the rings lie within that as well
      continue;
    }
    if (limits.stop.stop_requested() || rest().time <= 0.0) {
      plan.result.interrupted = true;
      break;
    }
    try {
      plan.planner = make_planner(rings);
    } catch (const Canceled&) {
      plan.result.interrupted = true;
      break;
    }
    keep_cheaper(plan.planner, request.cusp_cost, plan_iteration(), plan.result);
  }
  if (plan.result.interrupted && !plan.result.solved()) explain_interruption(limits, plan.result);
  return plan;
}

CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                             const CurveTolerances& tolerances, const PlannerOptions& options) {
  return plan_among_curves(world, request, tolerances,
                           [&](const World& rings) { return Planner(rings, vehicle, options); });
}

}  // namespace arcway
