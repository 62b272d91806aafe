#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "arcway/query_set.h"
#include "core/attach/roadmap.h"
#include "core/roadmap/lazy_feasible_graph.h"

namespace arcway::internal::test {

/// The roadmap of the tightest turns, with the reference's queries, found as it is asked for.
inline Roadmap lazy_map(const World& world, const Vehicle& vehicle) {
  const QuerySet queries = make_reference_queries(world);
  const std::vector<double> radii{vehicle.min_turning_radius()};
  auto graph = std::make_shared<const LazyFeasibleGraph>(
      FeasibleGraphInputs{world, vehicle, rows_of(world, build_reduced_visibility_graph(world, *queries.visibility)),
                          queries, radii},
      SerialExecutor());
  return {world, vehicle, queries, radii, std::move(graph), std::make_shared<const Outlines>(world)};
}

}  // namespace arcway::internal::test
