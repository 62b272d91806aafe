#include "core/model/outlines.h"

#include <algorithm>

namespace arcway::internal {

namespace {

constexpr std::size_t kPieceEdges = 12;

}  // namespace

Outlines::Outlines(const World& world) {
  const auto add_ring = [&](VertexId first, VertexId last) {
    const VertexId edges = last - first;
    for (VertexId begin = 0; begin < edges; begin += kPieceEdges) {
      Box box;
      starts_.push_back({first + begin, static_cast<std::uint32_t>(points_.size())});
      for (VertexId i = begin; i <= std::min(begin + static_cast<VertexId>(kPieceEdges), edges); ++i) {
        points_.push_back(world.vertex(first + i % edges));
        box.extend(points_.back());
      }
      boxes_.push_back(box);
    }
  };
  for (ObstacleId o = 0; o < world.region_count(); ++o) {
    const auto rings = world.ring_starts(o);
    for (std::size_t r = 0; r < rings.size(); ++r)
      add_ring(rings[r], r + 1 < rings.size() ? rings[r + 1] : world.vertices_of(o).last);
  }
  starts_.push_back({kNone, static_cast<std::uint32_t>(points_.size())});
  tree_ = BoxTree(boxes_);
}

}  // namespace arcway::internal
