#include "arcway/accel/graph_builder.h"

#include "accel/expansion/free_space_triangulation.h"

namespace arcway {

using namespace internal;

const char* name_of(GraphBuilder builder) { return builder == GraphBuilder::kPairwise ? "pairwise" : "tangent-cones"; }

GraphBuilder faster_graph_builder(const World& world) {
  return world.vertices().size() > FreeSpaceTriangulation::kMostVertices ? GraphBuilder::kPairwise
                                                                         : GraphBuilder::kTangentCones;
}

}  // namespace arcway
