#pragma once

#include <memory>

#include "arcway/distance_query.h"
#include "arcway/export.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway {

/// The queries that a planner asks, all about one world. Copies share the implementations. A planner's are not null.
struct QuerySet {
  std::shared_ptr<const VisibilityQuery> visibility;
  std::shared_ptr<const DistanceQuery> distance;
  std::shared_ptr<const SweepQuery> sweep;
};

/// The brute-force reference implementations: exact; every query checks all edges.
ARCWAY_API QuerySet make_reference_queries(const World& world);

}  // namespace arcway
