#include "core/curved_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace arcway {
namespace {

// Poses along the path, no two neighbours farther apart.
std::vector<Vec2> samples_of(const PlanResult& result, double spacing) {
  std::vector<Vec2> samples;
  for (const TimedSegment& timed : result.segments) {
    const double steps = std::ceil(timed.segment.length / spacing);
    for (double k = 0.0; k < steps; ++k)
      samples.push_back(timed.segment.at(timed.segment.length * k / steps).position());
  }
  samples.push_back(result.goal.position());
  return samples;
}

class CurvedPlanner {
 public:
  CurvedPlanner(const CurvedWorld& world, const CurveTolerances& tolerances) : world_(world), limits_(tolerances) {
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
  [[nodiscard]] double smallest() const {
    double least = limits_.first;
    for (const auto& curve : tolerances_)
      for (const double tolerance : curve) least = std::min(least, tolerance);
    return least;
  }
  // Whether anything was left to refine.
  bool refine(const PlanResult& result, const Footprint& body) {
    const double reach = 2.0 * (body.front + body.rear);
    const std::vector<Vec2> samples = samples_of(result, 0.5 * reach);
    bool refined = false;
    for (std::size_t i = 0; i < tolerances_.size(); ++i) {
      for (std::size_t k = 0; k < tolerances_[i].size(); ++k) {
        double& tolerance = tolerances_[i][k];
        if (tolerance <= limits_.last) continue;
        Box hull;
        for (const Vec2& p : world_.curves[i].pieces[k].p) hull.extend(p);
        const auto is_near = [&](const Vec2& p) { return hull.distance_to(p) <= reach + tolerance; };
        if (result.solved() && std::ranges::none_of(samples, is_near)) continue;
        tolerance = std::max(limits_.last, tolerance * limits_.factor);
        refined = true;
      }
    }
    return refined;
  }

 private:
  const CurvedWorld& world_;
  CurveTolerances limits_;
  std::vector<std::vector<double>> tolerances_;  // of each curve and piece
};

}  // namespace

CurvedPlan plan_among_curves(const CurvedWorld& world, const PlanRequest& request, const CurveTolerances& tolerances,
                             const std::function<Planner(const World&)>& make_planner, const PlanLimits& limits) {
  if (!(tolerances.last > 0.0 && tolerances.last <= tolerances.first && std::isfinite(tolerances.first)))
    throw std::invalid_argument("curve tolerances: need 0 < last <= first, finite");
  if (!(tolerances.factor > 0.0 && tolerances.factor < 1.0))
    throw std::invalid_argument("curve tolerances: factor must be in (0, 1)");
  if (tolerances.max_rounds < 1) throw std::invalid_argument("curve tolerances: max_rounds must be at least 1");
  CurvedPlanner curved(world, tolerances);
  std::vector<CurvedPlanRound> rounds;
  while (true) {
    Planner planner = make_planner(curved.make_world());
    PlanResult result = planner.plan(request, limits);
    rounds.push_back({curved.smallest(), planner.world().vertices().size(), result.status,
                      result.solved() ? result.travel_time : std::numeric_limits<double>::infinity()});
    if (rounds.size() == tolerances.max_rounds || result.interrupted ||
        !curved.refine(result, planner.vehicle().footprint()))
      return {std::move(planner), std::move(result), std::move(rounds)};
  }
}

CurvedPlan plan_among_curves(const CurvedWorld& world, const Vehicle& vehicle, const PlanRequest& request,
                             const CurveTolerances& tolerances, const PlannerOptions& options) {
  return plan_among_curves(world, request, tolerances,
                           [&](const World& rings) { return Planner(rings, vehicle, options); });
}

}  // namespace arcway
