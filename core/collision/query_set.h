#pragma once

#include <memory>

#include "core/collision/distance_query.h"
#include "core/collision/sweep_query.h"
#include "core/collision/visibility_query.h"
#include "core/model/world.h"

namespace [[gnu::visibility("default")]] arcway {

/// The queries a planner works with, all about one world. Copies share the implementations.
struct QuerySet {
  std::shared_ptr<const VisibilityQuery> visibility;
  std::shared_ptr<const DistanceQuery> distance;
  std::shared_ptr<const SweepQuery> sweep;
};

/// The exact brute-force reference implementation.
QuerySet make_reference_queries(const World& world);

}  // namespace arcway
