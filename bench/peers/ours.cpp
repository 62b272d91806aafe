#include "bench/peers/ours.h"

#ifdef ARCWAY_WITH_ACCEL
#include "accel/backend/make_queries.h"
#include "arcway/accel/tangent_cone_graph.h"
#include "arcway/accel/visibility_map.h"
#endif

namespace arcway::internal::peers {

#ifdef ARCWAY_WITH_ACCEL
const char* const kOurQueries = "embree";
const char* const kOurReducedBuilder = "tangent-cones";
const char* const kOurFullBuilder = "expansion";
QuerySet our_queries(const World& world) { return make_embree_queries(world); }
VisibilityGraph our_reduced_graph(const World& world) { return build_reduced_visibility_graph_by_tangent_cones(world); }
VisibilityGraph our_full_graph(const World& world) { return build_full_visibility_graph_by_expansion(world); }
#else
const char* const kOurQueries = "reference";
const char* const kOurReducedBuilder = "reference";
const char* const kOurFullBuilder = "reference";
QuerySet our_queries(const World& world) { return make_reference_queries(world); }
VisibilityGraph our_reduced_graph(const World& world) {
  return build_reduced_visibility_graph(world, *our_queries(world).visibility);
}
VisibilityGraph our_full_graph(const World& world) {
  return build_full_visibility_graph(world, *our_queries(world).visibility);
}
#endif

}  // namespace arcway::internal::peers
