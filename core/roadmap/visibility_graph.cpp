#include "arcway/visibility_graph.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/roadmap/compress_rows.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway {

using namespace internal;

namespace {

// Lines of sight of one question. Each may try every edge of the map, some 1 us per 1,000 edges: the clock is asked
// between questions.
constexpr std::size_t kSightsAtOnce = 16;

// Asks about lines of sight, as long as there is time.
// @throws Canceled
void ask_while_time(const VisibilityQuery& visibility, std::span<const LineSegment> segments,
                    std::span<std::uint8_t> visible, const Executor& executor) {
  for (std::size_t first = 0; first < segments.size(); first += kSightsAtOnce) {
    end_if_over(executor);
    const std::size_t count = std::min(kSightsAtOnce, segments.size() - first);
    visibility.visible(segments.subspan(first, count), visible.subspan(first, count));
  }
}

// Rows of the pairs u < v of `vertices` that pass `candidate` and see each other.
template <class Candidate>
Rows visible_pairs(const World& world, std::span<const VertexId> vertices, const VisibilityQuery& visibility,
                   const Executor& executor, const Candidate& candidate) {
  Rows rows(world.vertices().size());
  executor.begin_stage("lines of sight");
  executor.for_ranges(vertices.size(), 8, [&](std::size_t begin, std::size_t end) {
    std::vector<LineSegment> segments;
    std::vector<VertexId> targets;
    std::vector<std::uint8_t> visible;
    for (std::size_t i = begin; i < end; ++i) {
      const VertexId u = vertices[i];
      segments.clear();
      targets.clear();
      for (const VertexId v : vertices.subspan(i + 1)) {
        if (!candidate(u, v)) continue;
        segments.push_back({world.vertex(u), world.vertex(v)});
        targets.push_back(v);
      }
      visible.resize(segments.size());
      ask_while_time(visibility, segments, visible, executor);
      for (std::size_t k = 0; k < targets.size(); ++k)
        if (visible[k]) rows[u].push_back(targets[k]);
    }
  });
  return rows;
}

}  // namespace

VisibilityGraph::VisibilityGraph(std::vector<std::uint64_t> row_starts, std::vector<VertexId> targets)
    : row_starts_(std::move(row_starts)), targets_(std::move(targets)) {
  const auto fail = [&](SnapshotArray array, std::size_t index, const std::string& what) {
    throw SnapshotError(array, index, "visibility graph: " + what);
  };
  if (row_starts_.empty()) fail(SnapshotArray::kRowStarts, 0, "missing");
  if (row_starts_.front() != 0)
    fail(SnapshotArray::kRowStarts, 0, "the first one is " + std::to_string(row_starts_.front()));
  for (std::size_t u = 0; u < vertex_count(); ++u) {
    if (row_starts_[u + 1] < row_starts_[u] || row_starts_[u + 1] > targets_.size())
      fail(SnapshotArray::kRowStarts, u + 1,
           std::to_string(row_starts_[u + 1]) + " follows " + std::to_string(row_starts_[u]) +
               ", row starts must rise to the number of targets, " + std::to_string(targets_.size()));
    std::uint64_t lower = u;
    for (std::uint64_t i = row_starts_[u]; i < row_starts_[u + 1]; ++i) {
      const VertexId v = targets_[i];
      if (v <= lower || v >= vertex_count())
        fail(SnapshotArray::kTargets, i,
             "row " + std::to_string(u) + " has target " + std::to_string(v) + " out of order or range");
      lower = v;
    }
  }
  if (row_starts_.back() != targets_.size())
    fail(SnapshotArray::kRowStarts, vertex_count(),
         std::to_string(row_starts_.back()) + " at the end, row starts must rise to the number of targets, " +
             std::to_string(targets_.size()));
}

std::span<const VertexId> VisibilityGraph::row(VertexId u) const {
  return std::span(targets_).subspan(row_starts_[u], row_starts_[u + 1] - row_starts_[u]);
}

VisibilityGraph build_full_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                            const Executor& executor) {
  std::vector<VertexId> vertices;
  for (VertexId v = 0; v < world.vertices().size(); ++v)
    if (!world.is_covered(v)) vertices.push_back(v);
  return compress(visible_pairs(world, vertices, visibility, executor,
                                [&](VertexId u, VertexId v) { return world.vertex(u) != world.vertex(v); }));
}

VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                               const Executor& executor) {
  const Rows rows = visible_pairs(world, world.convex_vertices(), visibility, executor, [&](VertexId u, VertexId v) {
    return is_tangent(world, u, world.vertex(v)) && is_tangent(world, v, world.vertex(u));
  });
  return without_carried_edges(world, compress(rows), executor);
}

std::string to_string(const VisibilityGraph& graph) {
  return std::to_string(graph.vertex_count()) + " vertices, " + std::to_string(graph.edge_count()) + " edges";
}

}  // namespace arcway
