#pragma once

#include <optional>

#include "arcway/accel/graph_builder.h"
#include "arcway/backend.h"
#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/process_group.h"
#include "arcway/world.h"

namespace arcway {

/// What accel_backend may be told to do otherwise.
struct AccelOptions {
  std::optional<GraphBuilder> builder = std::nullopt;  ///< of the reduced graph; empty: faster_graph_builder(world)
  bool reference_queries = false;                      ///< by brute force, to compare
  /// Processes that build the same whole graph, as PlannerOptions::process_group; must outlive the construction of
  /// planners.
  const ProcessGroup* process_group = nullptr;
};

/// Embree for queries, walks through a triangulation for the reduced visibility graph, whole or row by row: the answers
/// and graphs of reference_backend, bit for bit.
///
///     const Planner planner(world, vehicle, accel_backend(world));
///
/// What takes time is made when a planner asks for it, and queries are shared by all planners on this backend: see
/// make_embree_queries, make_lazy_rows and build_reduced_visibility_graph_by_tangent_cones for cost, memory and what
/// they throw, which planners pass on.
/// @param executor  must outlive the construction of planners; none: a TbbExecutor in the caller's arena.
ARCWAY_API Backend accel_backend(const World& world);
ARCWAY_API Backend accel_backend(const World& world, const Executor& executor, const AccelOptions& options = {});

}  // namespace arcway
