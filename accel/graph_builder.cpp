#include "accel/graph_builder.h"

namespace arcway {

namespace {

constexpr std::size_t kMostWedgeVertices = std::size_t{1} << 28;

}  // namespace

const char* name_of(GraphBuilder builder) { return builder == GraphBuilder::kPairwise ? "pairwise" : "wedge"; }

GraphBuilder faster_graph_builder(const World& world) {
  return world.vertices().size() > kMostWedgeVertices ? GraphBuilder::kPairwise : GraphBuilder::kWedge;
}

}  // namespace arcway
