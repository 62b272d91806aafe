#include "arcway/accel/graph_builder.h"

#include "accel/expansion/sight_map.h"

namespace arcway {

using namespace internal;

const char* name_of(GraphBuilder builder) { return builder == GraphBuilder::kPairwise ? "pairwise" : "wedge"; }

GraphBuilder faster_graph_builder(const World& world) {
  return world.vertices().size() > SightMap::kMostVertices ? GraphBuilder::kPairwise : GraphBuilder::kWedge;
}

}  // namespace arcway
