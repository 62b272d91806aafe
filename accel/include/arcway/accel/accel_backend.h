#pragma once

#include <optional>

#include "arcway/accel/graph_builder.h"
#include "arcway/backend.h"
#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/process_group.h"
#include "arcway/world.h"

namespace arcway {

/// Options of accel_backend.
struct AccelOptions {
  std::optional<GraphBuilder> builder =
      std::nullopt;                ///< builder of the reduced graph; empty: faster_graph_builder(world)
  bool reference_queries = false;  ///< queries by brute force, for comparisons
  /// Processes that build the same eager graph together, as PlannerOptions::process_group; null: none. Must outlive the
  /// construction of planners.
  const ProcessGroup* process_group = nullptr;
};

/// A backend with Embree for queries and tangent-cone expansion for the reduced visibility graph, whole or row by row.
/// Answers and graphs equal those of reference_backend, bit for bit.
///
///     const Planner planner(world, vehicle, accel_backend(world));
///
/// Expensive parts are built when a planner asks for them, and shared by all planners on this backend. See
/// make_embree_queries, make_lazy_rows and build_reduced_visibility_graph_by_tangent_cones for cost, memory and
/// exceptions, which planners pass on.
/// @param executor  must outlive the construction of planners; none: a TbbExecutor in the caller's arena.
ARCWAY_API Backend accel_backend(const World& world);
ARCWAY_API Backend accel_backend(const World& world, const Executor& executor, const AccelOptions& options = {});

}  // namespace arcway
