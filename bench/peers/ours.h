#pragma once

#include "arcway/query_set.h"
#include "arcway/visibility_graph.h"
#include "arcway/world.h"

namespace arcway::internal::peers {

/// What arcway enters its contests with: accel where this build has it, else the reference.
extern const char* const kOurQueries;
extern const char* const kOurReducedBuilder;
extern const char* const kOurFullBuilder;
QuerySet our_queries(const World& world);
VisibilityGraph our_reduced_graph(const World& world);
VisibilityGraph our_full_graph(const World& world);

}  // namespace arcway::internal::peers
