#pragma once

#include <functional>
#include <span>

#include "arcway/replan.h"

namespace arcway::internal {

/// What arcway::replan asks a planner for. Comparisons ask others.
struct ReplanQueries {
  const Vehicle& vehicle;
  std::function<bool(std::span<const PathSegment>)> is_free;  ///< Planner::is_free
  std::function<PlanResult(const PlanRequest&, const PlanLimits&)> plan;
  /// What driving close to obstacles costs on a path [s]; empty: nothing.
  std::function<double(std::span<const PathSegment>)> clearance_cost = {};
  /// Planner::is_free_without_margin; empty: no motion may come into the margin.
  std::function<bool(std::span<const PathSegment>)> is_free_without_margin = {};
};

/// arcway::replan by other queries. The vehicle of the motion is that of the queries.
Replan replan_by(const ReplanQueries& queries, const Trajectory& driven, double time, const ReplanOptions& options);

}  // namespace arcway::internal
