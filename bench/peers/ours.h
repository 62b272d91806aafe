#pragma once

#include "core/collision/query_set.h"
#include "core/model/world.h"
#include "core/roadmap/visibility_graph.h"

namespace arcway::peers {

/// What arcway enters its contests with: accel where this build has it, else the reference.
extern const char* const kOurQueries;
extern const char* const kOurReducedBuilder;
extern const char* const kOurFullBuilder;
QuerySet our_queries(const World& world);
VisibilityGraph our_reduced_graph(const World& world);
VisibilityGraph our_full_graph(const World& world);

}  // namespace arcway::peers
