#include "accel/expansion/free_space_triangulation.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "accel/triangulation/free_space_sweep.h"
#include "core/collision/blocking.h"

namespace arcway::internal {

namespace {

// Runs make_map as one piece of work of the stage "sorting", so that a watcher sees the stage and can stop the build.
bool sort(const Executor& executor, const std::function<bool()>& make_map) {
  bool is_made = false;
  executor.begin_stage("sorting");
  executor.for_ranges(1, 1, [&](std::size_t, std::size_t) { is_made = make_map(); });
  return is_made;
}

}  // namespace

FreeSpaceTriangulation::FreeSpaceTriangulation(const World& world, const Executor& executor, Diagonals shortened)
    : world_(world) {
  if (world.vertices().size() > kMostVertices)
    throw std::length_error("tangent-cone builder: the world has " + std::to_string(world.vertices().size()) +
                            " vertices, at most " + std::to_string(kMostVertices) + " fit");
  if (world.vertices().empty()) return;
  std::optional<FreeSpace> space;
  NodeOrder order;
  if (sort(executor, [&] { return make_uncut_map(world, map_); })) space = sweep(executor, order);
  if (!space) {
    sort(executor, [&] {
      map_ = make_cut_map(world);
      return true;
    });
    space = sweep(executor, order);
    if (!space) throw std::logic_error("tangent-cone builder: edges meet after they have been cut");
  }
  edge_is_covered_ = std::move(space->edge_is_covered);
  map_.incoming = {};
  shorten_diagonals(map_.points, space->triangulation, shortened, executor);
  end_if_over(executor);
  BigVector<BoundaryHalfEdge> boundary = lay_out_half_edges(std::move(space->triangulation), executor);
  lay_out_nodes(order, std::move(boundary), executor);
  map_.point_of = {};
  end_if_over(executor);

  std::vector<Box> boxes;
  for (const ObstacleId o : map_.invalid) {
    const auto [first, last] = world_.vertices_of(o);
    for (VertexId e = first; e < last; ++e) {
      invalid_edges_.push_back(e);
      boxes.push_back(box_of(world_.edges()[e]));
    }
  }
  invalid_tree_ = BoxTree(boxes);
}

// The sweep is sequential. Nodes are numbered beside it, because that needs no triangles.
std::optional<FreeSpace> FreeSpaceTriangulation::sweep(const Executor& executor, NodeOrder& order) {
  executor.begin_stage("triangulation");
  std::optional<FreeSpace> space;
  run_both(
      executor, [&] { space = triangulate_free_space(map_, executor); }, [&] { order = number_nodes(); });
  return space;
}

std::uint32_t FreeSpaceTriangulation::point_at(const Vec2& vertex) const {
  const auto before = [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); };
  return static_cast<std::uint32_t>(std::ranges::lower_bound(points(), vertex, before) - points().begin());
}

double FreeSpaceTriangulation::sure_cross_product() const {
  if (points().empty()) return 0.0;
  const Vec2 size = points().back() - points().front();
  return 0x1p-50 * size.x() * size.y();  // larger than the error bound of the predicates' filter
}

bool FreeSpaceTriangulation::is_blocked_by_invalid(const LineSegment& segment) const {
  return !invalid_tree_.visit_overlaps(box_of(segment),
                                       [&](std::uint32_t i) { return !blocks(world_, invalid_edges_[i], segment); });
}

void FreeSpaceTriangulation::list_left_edges() {
  std::vector<std::uint32_t> ends;
  ends.reserve(map_.edges.size());
  for (const PlanarMap::Edge& edge : map_.edges) ends.push_back(edge.high);
  left_edges_ = BucketIndex(std::move(ends), static_cast<std::uint32_t>(map_.points.size()));
}

}  // namespace arcway::internal
