#pragma once

#include <memory>

#include "arcway/distance_query.h"
#include "arcway/export.h"
#include "arcway/sweep_query.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway {

/// The queries a planner works with, all about one world. Copies share the implementations.
struct QuerySet {
  std::shared_ptr<const VisibilityQuery> visibility;
  std::shared_ptr<const DistanceQuery> distance;
  std::shared_ptr<const SweepQuery> sweep;
};

/// The exact brute-force reference implementation.
ARCWAY_API QuerySet make_reference_queries(const World& world);

}  // namespace arcway
