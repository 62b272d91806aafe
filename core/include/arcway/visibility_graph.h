#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "arcway/executor.h"
#include "arcway/export.h"
#include "arcway/path.h"
#include "arcway/text.h"
#include "arcway/visibility_query.h"
#include "arcway/world.h"

namespace arcway {

/// An edge of a graph, between two vertices a < b.
struct GraphEdge {
  VertexId a, b;
  friend bool operator==(const GraphEdge&, const GraphEdge&) = default;
};

/// The edges of a VisibilityGraph as a range, ascending. It must not outlive the graph. O(1) an edge.
class GraphEdges {
 public:
  class Iterator {
   public:
    using value_type = GraphEdge;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;
    using iterator_concept = std::forward_iterator_tag;
    using reference = GraphEdge;
    using pointer = void;
    Iterator() = default;
    GraphEdge operator*() const { return {row_, targets_[edge_]}; }
    Iterator& operator++() {
      ++edge_;
      find_row();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.edge_ == b.edge_; }

   private:
    friend GraphEdges;
    Iterator(std::span<const std::uint64_t> starts, std::span<const VertexId> targets, std::size_t edge)
        : starts_(starts), targets_(targets), edge_(edge) {
      if (edge == 0) find_row();
    }
    /// The row that has the edge; rows may be empty.
    void find_row() {
      while (edge_ < targets_.size() && starts_[row_ + 1] <= edge_) ++row_;
    }
    std::span<const std::uint64_t> starts_;
    std::span<const VertexId> targets_;
    std::size_t edge_ = 0;
    VertexId row_ = 0;
  };
  GraphEdges(std::span<const std::uint64_t> starts, std::span<const VertexId> targets)
      : starts_(starts), targets_(targets) {}
  [[nodiscard]] Iterator begin() const { return {starts_, targets_, 0}; }
  [[nodiscard]] Iterator end() const { return {starts_, targets_, targets_.size()}; }
  [[nodiscard]] std::size_t size() const { return targets_.size(); }
  [[nodiscard]] bool empty() const { return targets_.empty(); }

 private:
  std::span<const std::uint64_t> starts_;
  std::span<const VertexId> targets_;
};

/// An undirected graph on a world's vertices, in compressed rows: each edge is stored once, in the row of its lower
/// vertex.
class ARCWAY_API VisibilityGraph {
 public:
  VisibilityGraph() = default;
  /// @param row_starts  vertex count + 1 offsets into `targets`.
  /// @param targets  by row, those of row u > u and ascending.
  /// @throws SnapshotError (std::invalid_argument) naming the first entry that breaks this. O(edges).
  VisibilityGraph(std::vector<std::uint64_t> row_starts, std::vector<VertexId> targets);

  [[nodiscard]] std::size_t vertex_count() const { return row_starts_.empty() ? 0 : row_starts_.size() - 1; }
  [[nodiscard]] std::size_t edge_count() const { return targets_.size(); }
  /// All edges: `for (const auto [a, b] : graph.edges())`.
  [[nodiscard]] GraphEdges edges() const { return {row_starts_, targets_}; }
  /// The neighbors v > u of u.
  [[nodiscard]] std::span<const VertexId> row(VertexId u) const;
  [[nodiscard]] std::span<const std::uint64_t> row_starts() const { return row_starts_; }
  [[nodiscard]] std::span<const VertexId> targets() const { return targets_; }
  friend bool operator==(const VisibilityGraph&, const VisibilityGraph&) = default;

 private:
  std::vector<std::uint64_t> row_starts_;
  std::vector<VertexId> targets_;
};

/// "45 vertices, 120 edges".
ARCWAY_API std::string to_string(const VisibilityGraph& graph);

/// The full visibility graph: all pairs of vertices that see each other and are not covered, convex and reflex ones;
/// figure 1 of the paper, all lines. Lines may pass through other vertices. Coincident vertices are not joined. O(n^2)
/// visibility queries.
/// @throws Canceled if the executor's clock is over before it is built.
ARCWAY_API VisibilityGraph build_full_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                       const Executor& executor = SerialExecutor());

/// The reduced visibility graph [Rohnert 1986; section 2 of the paper]. Its vertices are World::convex_vertices. Two of
/// them are joined if
/// - they see each other,
/// - their line is tangent at both, and
/// - no other convex vertex lies on the open segment between them.
///
/// Every pair is tested for tangency, and the s tangent pairs for visibility. O(n^2 + s q) with visibility queries of
/// cost q.
/// @throws Canceled if the executor's clock is over before it is built.
ARCWAY_API VisibilityGraph build_reduced_visibility_graph(const World& world, const VisibilityQuery& visibility,
                                                          const Executor& executor = SerialExecutor());

}  // namespace arcway
