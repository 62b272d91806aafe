#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/geometry/ray_parity.h"
#include "core/model/world_coverage.h"
#include "core/model/world_data.h"

namespace arcway {

using namespace internal;
namespace {

// Number of vertices up to which a scan of all edges is faster than a tree over them.
constexpr std::size_t kScanVertices = 64;
// Edges examined region by region, per vertex, after which one sweep over all edges takes over.
constexpr std::size_t kRegionPatience = 128;

}  // namespace

struct World::Data::RegionSearch {
  RegionSearch(const Data& the_data, ObstacleId the_region) : data(the_data), region(the_region) {}

  PointLocation locate(VertexId v) {
    const Vec2& p = data.vertices[v];
    const VertexId first = data.region_starts[region], last = data.region_starts[region + 1];
    if (!data.boxes[region].contains(p)) return data.locate(p, region);
    if (last - first <= kScanVertices) {
      looks += last - first;
      return data.locate(p, region);
    }
    if (edge_tree.size() == 0) build_edge_tree(first, last);
    RayParity parity(p);
    edge_tree.visit_overlaps(parity.ray_box(), [&](std::uint32_t e) {
      ++looks;
      parity.add(data.edges[first + e].a, data.edges[first + e].b);
      return true;
    });
    return data.side_of(parity.location(), region);
  }

  void build_edge_tree(VertexId first, VertexId last) {
    std::vector<Box> edge_boxes;
    edge_boxes.reserve(last - first);
    for (VertexId v = first; v < last; ++v) edge_boxes.push_back(arcway::box_of(data.edges[v]));
    edge_tree = BoxTree(edge_boxes);
  }

  const Data& data;
  ObstacleId region;
  BoxTree edge_tree;
  std::size_t looks = 0;  // at edges, about
};

World::Data::Stretches World::Data::stretches_of(std::span<const VertexId> which) const {
  constexpr std::size_t kMostVertices = 16;
  const double widest = 4.0 * (box.max - box.min).maxCoeff() / std::sqrt(static_cast<double>(vertices.size()));
  Stretches stretches;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const VertexId v = which[i];
    Box extended;
    if (i > 0) extended = stretches.boxes.back();
    extended.extend(vertices[v]);
    if (i > 0 && obstacle_of[v] == obstacle_of[which[i - 1]] && i - stretches.starts.back() < kMostVertices &&
        (extended.max - extended.min).maxCoeff() <= widest) {
      stretches.boxes.back() = extended;
      continue;
    }
    stretches.starts.push_back(i);
    stretches.boxes.emplace_back().extend(vertices[v]);
  }
  stretches.starts.push_back(which.size());
  return stretches;
}

void World::Data::mark_covered(std::span<const VertexId> which, std::span<const ObstacleId> regions) {
  covered.resize(vertices.size());
  for (const VertexId v : which) covered[v] = false;
  if (mark_inside(regions, which, kRegionPatience * vertices.size())) return;
  Coverage coverage = sweep_coverage(edges, obstacle_of, has_bounds ? obstacle_count() : kNone);
  covered = std::move(coverage.covered);
  HugeVector<VertexId> all(vertices.size());
  std::iota(all.begin(), all.end(), VertexId{0});
  mark_inside(coverage.left_over, all, std::numeric_limits<std::size_t>::max());
}

void World::Data::mark_all_covered() {
  HugeVector<VertexId> all(vertices.size());
  std::iota(all.begin(), all.end(), VertexId{0});
  std::vector<ObstacleId> regions(boxes.size());
  std::iota(regions.begin(), regions.end(), ObstacleId{0});
  mark_covered(all, regions);
}

bool World::Data::mark_inside(std::span<const ObstacleId> regions, std::span<const VertexId> which, std::size_t most) {
  const Stretches stretches = stretches_of(which);
  const BoxTree stretch_tree(stretches.boxes);
  Box asked;
  for (const Box& stretch : stretches.boxes) asked.extend(stretch);
  // Region by region, so that the tree over the edges of a large one lives only for its turn.
  for (const ObstacleId region : regions) {
    const Box& around = is_bounds(region) ? box : boxes[region];  // what is outside of the bounds is covered
    if (!around.overlaps(asked)) continue;
    RegionSearch search(*this, region);
    const bool is_done = stretch_tree.visit_overlaps(around, [&](std::uint32_t i) {
      ++search.looks;
      const auto stretch = which.subspan(stretches.starts[i], stretches.starts[i + 1] - stretches.starts[i]);
      if (obstacle_of[stretch.front()] == region) return true;
      for (const VertexId v : stretch)
        if (!covered[v] && around.contains(vertices[v])) covered[v] = search.locate(v) == PointLocation::kInside;
      return search.looks <= most;
    });
    if (!is_done) return false;
    most -= std::min(most, search.looks);
  }
  return true;
}

}  // namespace arcway
