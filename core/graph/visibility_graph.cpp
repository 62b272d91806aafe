#include "core/graph/visibility_graph.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "core/geometry/predicates.h"

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

// Strict weak order by direction about u, counter-clockwise from +x, exact.
class DirectionOrder {
 public:
  DirectionOrder(const World& world, VertexId u) : world_(world), origin_(world.vertex(u)) {}

  bool operator()(VertexId v, VertexId w) const {
    const bool v_low = in_lower_half(world_.vertex(v));
    const bool w_low = in_lower_half(world_.vertex(w));
    if (v_low != w_low) return w_low;
    return orientation(origin_, world_.vertex(v), world_.vertex(w)) > 0;
  }

 private:
  [[nodiscard]] bool in_lower_half(const Vec2& p) const {
    return p.y() < origin_.y() || (p.y() == origin_.y() && p.x() < origin_.x());
  }
  const World& world_;
  Vec2 origin_;
};

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

std::optional<std::pair<VertexId, VertexId>> foreign_edge(const World& world, const VisibilityGraph& graph) {
  const auto has = [&](VertexId v) { return v < world.vertices().size() && world.is_graph_vertex(v); };
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u))
      if (!has(u) || !has(v)) return std::pair(u, v);
  return std::nullopt;
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
  std::vector<std::uint64_t> starts(graph.vertex_count() + 1, 0);
  for (VertexId u = 0; u < graph.vertex_count(); ++u) {
    starts[u + 1] += graph.row(u).size();
    for (const VertexId v : graph.row(u)) ++starts[v + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<VertexId> neighbours(starts.back());
  std::vector<std::uint64_t> filled(starts.begin(), starts.end() - 1);
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (const VertexId v : graph.row(u)) {
      neighbours[filled[u]++] = v;
      neighbours[filled[v]++] = u;
    }

  std::vector<std::uint64_t> kept_starts(graph.vertex_count() + 1, 0);
  executor.for_ranges(graph.vertex_count(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<VertexId> kept;
    for (std::size_t i = begin; i < end; ++i) {
      const auto u = static_cast<VertexId>(i);
      const std::span<VertexId> around(neighbours.data() + starts[u], starts[u + 1] - starts[u]);
      const DirectionOrder before(world, u);
      std::sort(around.begin(), around.end(), before);
      kept.clear();
      for (std::size_t first = 0, last = 0; first < around.size(); first = last) {
        while (last < around.size() && !before(around[first], around[last])) ++last;
        const std::span<const VertexId> same_direction = around.subspan(first, last - first);
        for (const VertexId v : same_direction) {
          const LineSegment edge{world.vertex(u), world.vertex(v)};
          const bool carried = std::any_of(same_direction.begin(), same_direction.end(),
                                           [&](VertexId w) { return on_open_segment(world.vertex(w), edge); });
          if (v > u && !carried) kept.push_back(v);
        }
      }
      std::sort(kept.begin(), kept.end());
      std::copy(kept.begin(), kept.end(), around.begin());
      kept_starts[u + 1] = kept.size();
    }
  });
  std::partial_sum(kept_starts.begin(), kept_starts.end(), kept_starts.begin());
  std::vector<VertexId> targets;
  targets.reserve(kept_starts.back());
  for (VertexId u = 0; u < graph.vertex_count(); ++u) {
    const auto row = neighbours.begin() + static_cast<std::ptrdiff_t>(starts[u]);
    targets.insert(targets.end(), row, row + static_cast<std::ptrdiff_t>(kept_starts[u + 1] - kept_starts[u]));
  }
  return {std::move(kept_starts), std::move(targets)};
}

VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                               const Executor& executor) {
  const Rows rows = visible_pairs(world, world.convex_vertices(), visibility, executor, [&](VertexId u, VertexId v) {
    return is_tangent(world, u, world.vertex(v)) && is_tangent(world, v, world.vertex(u));
  });
  return without_carried_edges(world, compress(rows), executor);
}

}  // namespace arcway
