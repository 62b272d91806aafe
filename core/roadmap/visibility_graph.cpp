#include "core/roadmap/visibility_graph.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/geometry/direction_order.h"
#include "core/geometry/predicates.h"
#include "core/roadmap/visibility_rows.h"

namespace arcway {

namespace {

using Rows = std::vector<std::vector<VertexId>>;

VisibilityGraph compress(const Rows& rows) {
  std::vector<std::uint64_t> starts(rows.size() + 1, 0);
  for (std::size_t u = 0; u < rows.size(); ++u) starts[u + 1] = starts[u] + rows[u].size();
  std::vector<VertexId> targets;
  targets.reserve(starts.back());
  for (const auto& row : rows) targets.insert(targets.end(), row.begin(), row.end());
  return {std::move(starts), std::move(targets)};
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
      visibility.visible(segments, visible);
      for (std::size_t k = 0; k < targets.size(); ++k)
        if (visible[k]) rows[u].push_back(targets[k]);
    }
  });
  return rows;
}

}  // namespace

VisibilityGraph::VisibilityGraph(std::vector<std::uint64_t> row_starts, std::vector<VertexId> targets)
    : row_starts_(std::move(row_starts)), targets_(std::move(targets)) {
  const auto fail = [&](Table table, std::size_t index, const std::string& what) {
    throw TableError(table, index, "visibility graph: " + what);
  };
  if (row_starts_.empty()) fail(Table::kRowStarts, 0, "missing");
  if (row_starts_.front() != 0) fail(Table::kRowStarts, 0, "the first one is " + std::to_string(row_starts_.front()));
  for (std::size_t u = 0; u < vertex_count(); ++u) {
    if (row_starts_[u + 1] < row_starts_[u] || row_starts_[u + 1] > targets_.size())
      fail(Table::kRowStarts, u + 1,
           std::to_string(row_starts_[u + 1]) + " follows " + std::to_string(row_starts_[u]) +
               ", row starts must rise to the number of targets, " + std::to_string(targets_.size()));
    std::uint64_t lower = u;
    for (std::uint64_t i = row_starts_[u]; i < row_starts_[u + 1]; ++i) {
      const VertexId v = targets_[i];
      if (v <= lower || v >= vertex_count())
        fail(Table::kTargets, i,
             "row " + std::to_string(u) + " has target " + std::to_string(v) + " out of order or range");
      lower = v;
    }
  }
  if (row_starts_.back() != targets_.size())
    fail(Table::kRowStarts, vertex_count(),
         std::to_string(row_starts_.back()) + " at the end, row starts must rise to the number of targets, " +
             std::to_string(targets_.size()));
}

std::span<const VertexId> VisibilityGraph::row(VertexId u) const {
  return std::span(targets_).subspan(row_starts_[u], row_starts_[u + 1] - row_starts_[u]);
}

bool is_tangent(const World& world, VertexId v, const Vec2& p) {
  const Vec2& at = world.vertex(v);
  if (at == p) return false;
  return orientation(p, at, world.vertex(world.previous(v))) * orientation(p, at, world.vertex(world.next(v))) >= 0;
}

Side obstacle_side(const World& world, VertexId v, const Vec2& from) {
  const Vec2& at = world.vertex(v);
  const int side =
      orientation(from, at, world.vertex(world.previous(v))) + orientation(from, at, world.vertex(world.next(v)));
  return side > 0 ? Side::kLeft : Side::kRight;
}

VisibilityGraph build_full_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                            const Executor& executor) {
  std::vector<VertexId> vertices;
  for (VertexId v = 0; v < world.vertices().size(); ++v)
    if (!world.is_covered(v)) vertices.push_back(v);
  return compress(visible_pairs(world, vertices, visibility, executor,
                                [&](VertexId u, VertexId v) { return world.vertex(u) != world.vertex(v); }));
}

VisibilityGraph without_carried_edges(const World& world, const VisibilityGraph& graph, const Executor& executor) {
  const auto rows = rows_of(world, graph);
  Rows kept(graph.vertex_count());
  executor.for_ranges(kept.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<VertexId> around;
    for (auto u = static_cast<VertexId>(begin); u < end; ++u) {
      const auto before = [&](VertexId v, VertexId w) {
        return precedes_about(world.vertex(u), world.vertex(v), world.vertex(w));
      };
      around.assign(rows->of(u).begin(), rows->of(u).end());
      std::sort(around.begin(), around.end(), before);
      for (std::size_t first = 0, last = 0; first < around.size(); first = last) {
        while (last < around.size() && !before(around[first], around[last])) ++last;
        // The edges to all but the nearest place are carried.
        const auto same_direction = std::span(around).subspan(first, last - first);
        const VertexId nearest = *std::ranges::min_element(same_direction, [&](VertexId v, VertexId w) {
          return on_open_segment(world.vertex(v), {world.vertex(u), world.vertex(w)});
        });
        for (const VertexId v : same_direction)
          if (v > u && world.vertex(v) == world.vertex(nearest)) kept[u].push_back(v);
      }
      std::sort(kept[u].begin(), kept[u].end());
    }
  });
  return compress(kept);
}

VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                               const Executor& executor) {
  const Rows rows = visible_pairs(world, world.convex_vertices(), visibility, executor, [&](VertexId u, VertexId v) {
    return is_tangent(world, u, world.vertex(v)) && is_tangent(world, v, world.vertex(u));
  });
  return without_carried_edges(world, compress(rows), executor);
}

}  // namespace arcway
