#include "accel/graphs/pairwise_graph.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>
#include <vector>

#include "accel/graphs/convex_tangents.h"
#include "accel/graphs/tangent_filter.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

using VertexPair = ConvexTangents::VertexPair;

// One piece of work: a range of a region's convex vertices, as indices among all convex vertices.
struct Piece {
  ObstacleId region;
  TangentFilter::Range vertices;
};

// Memory of a thread, kept from piece to piece.
struct Workspace {
  std::vector<VertexPair> pairs;
  std::vector<LineSegment> segments;
  std::vector<std::uint8_t> visible;
};

class PairwiseBuilder {
 public:
  PairwiseBuilder(const World& world, const VisibilityQuery& visibility, TangentSearch search)
      : world_(world), visibility_(visibility), search_(search), filter_(world), convex_(world) {
    for (ObstacleId region = 0; region < world.region_count(); ++region) {
      const bool binary = search == TangentSearch::kBinary && convex_.is_convex(region);
      const std::size_t most =
          binary ? 64 : 8;  // vertices per piece; each has up to as many pairs as the world has vertices
      const auto [first, last] = filter_.range_of(region);
      for (std::size_t u = first; u < last; u += most) pieces_.push_back({region, {u, std::min(u + most, last)}});
    }
    edges_.resize(pieces_.size());
  }

  [[nodiscard]] std::size_t piece_count() const { return pieces_.size(); }

  // Finds the visible tangent pairs u < v with u in the piece.
  void build(std::size_t piece, Workspace& work) {
    auto& [pairs, segments, visible] = work;
    pairs.clear();
    find_tangents(pieces_[piece], pairs);
    std::sort(pairs.begin(), pairs.end());
    segments.clear();
    for (const auto& [u, v] : pairs) segments.push_back({world_.vertex(u), world_.vertex(v)});
    visible.resize(segments.size());
    visibility_.visible(segments, visible);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (visible[i]) edges_[piece].push_back(pairs[i]);
    tangent_pairs_ += pairs.size();
  }

  [[nodiscard]] VisibilityGraph graph() const {
    std::vector<std::uint64_t> starts(world_.vertices().size() + 1, 0);
    for (const auto& edges : edges_)
      for (const auto& [u, v] : edges) ++starts[u + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<VertexId> targets;
    targets.reserve(starts.back());
    for (const auto& edges : edges_)
      for (const auto& [u, v] : edges) targets.push_back(v);
    return {std::move(starts), std::move(targets)};
  }

  [[nodiscard]] PairwiseCounts counts() const { return {vertex_pairs_, binary_pairs_, tangent_pairs_}; }

 private:
  void try_all(TangentFilter::Range from, TangentFilter::Range to, std::vector<VertexPair>& pairs) {
    const std::span<const VertexId> vertices = world_.convex_vertices();
    for (std::size_t u = from.first; u < from.last; ++u) {
      const std::size_t first = std::max(to.first, u + 1);
      if (first >= to.last) continue;
      filter_.for_each_tangent(u, {first, to.last}, [&](VertexId v) { pairs.emplace_back(vertices[u], v); });
      vertex_pairs_ += to.last - first;
    }
  }

  void find_tangents(const Piece& piece, std::vector<VertexPair>& pairs) {
    const std::span<const VertexId> vertices = world_.convex_vertices();
    if (search_ == TangentSearch::kAllPairs || !convex_.is_convex(piece.region)) {
      try_all(piece.vertices, {piece.vertices.first, vertices.size()}, pairs);
      return;
    }
    try_all(piece.vertices, filter_.range_of(piece.region), pairs);
    const VertexId lowest = vertices[piece.vertices.first];
    const VertexId highest = vertices[piece.vertices.last - 1];
    std::uint64_t binary_pairs = 0;
    for (ObstacleId other = piece.region + 1; other < world_.region_count(); ++other) {
      const auto tangents = convex_.is_convex(other) ? convex_.between(piece.region, other) : std::nullopt;
      if (!tangents) {
        try_all(piece.vertices, filter_.range_of(other), pairs);
        continue;
      }
      ++binary_pairs;
      for (const auto& [u, v] : *tangents)
        if (u >= lowest && u <= highest && world_.is_graph_vertex(u) && world_.is_graph_vertex(v))
          pairs.emplace_back(u, v);
    }
    binary_pairs_ += binary_pairs;
  }

  const World& world_;
  const VisibilityQuery& visibility_;
  TangentSearch search_;
  TangentFilter filter_;
  ConvexTangents convex_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<VertexPair>> edges_;  // by piece
  std::atomic<std::uint64_t> vertex_pairs_ = 0, binary_pairs_ = 0, tangent_pairs_ = 0;
};

}  // namespace

VisibilityGraph build_pairwise_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                const Executor& executor, TangentSearch search,
                                                PairwiseCounts* counts) {
  PairwiseBuilder builder(world, visibility, search);
  executor.begin_stage("tangent pairs");
  executor.for_ranges(builder.piece_count(), 1, [&](std::size_t begin, std::size_t end) {
    Workspace work;
    for (std::size_t piece = begin; piece < end; ++piece) builder.build(piece, work);
  });
  if (counts != nullptr) *counts = builder.counts();
  return without_carried_edges(world, builder.graph(), executor);
}

}  // namespace arcway::internal
