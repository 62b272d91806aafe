#include "arcway/visibility_rows.h"

#include <numeric>
#include <string>
#include <vector>

#include "arcway/snapshot.h"
#include "core/base/prefetch.h"

namespace arcway {

using namespace internal;

namespace {

class GraphRows final : public VisibilityRows {
 public:
  GraphRows(const World& world, const VisibilityGraph& graph) : world_(world), starts_(graph.vertex_count() + 1, 0) {
    const auto vertices = static_cast<VertexId>(graph.vertex_count());
    for (VertexId u = 0; u < vertices; ++u) {
      starts_[u + 1] += graph.row(u).size();
      for (const VertexId v : graph.row(u)) ++starts_[v + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    targets_.resize(starts_.back());
    // The rows are ascending: lower neighbors of a vertex come before its own row.
    std::vector<std::uint64_t> next(starts_.begin(), starts_.end() - 1);
    for (VertexId u = 0; u < vertices; ++u)
      for (const VertexId v : graph.row(u)) {
        targets_[next[u]++] = v;
        targets_[next[v]++] = u;
      }
  }

  [[nodiscard]] std::span<const VertexId> of(VertexId v) const override {
    return std::span(targets_).subspan(starts_[v], starts_[v + 1] - starts_[v]);
  }

  void prefetch(VertexId v) const override { will_need(targets_.data() + starts_[v]); }

  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& /*executor*/) const override {
    std::vector<Pair> pairs;
    for (VertexId u = 0; u + 1 < starts_.size(); ++u)
      for (const VertexId v : of(u))
        if (v > u && (world_.vertex(v) - world_.vertex(u)).norm() <= length && wanted(u, v)) pairs.emplace_back(u, v);
    return pairs;
  }

 private:
  World world_;
  std::vector<std::uint64_t> starts_;
  std::vector<VertexId> targets_;
};

}  // namespace

std::shared_ptr<const VisibilityRows> rows_of(const World& world, const VisibilityGraph& graph) {
  if (graph.vertex_count() != world.vertices().size())
    throw SnapshotError(SnapshotArray::kRowStarts, graph.vertex_count(),
                        "at the end, the world has " + std::to_string(world.vertices().size()) + " vertices");
  for (VertexId u = 0; u < graph.vertex_count(); ++u)
    for (std::uint64_t i = graph.row_starts()[u]; i < graph.row_starts()[u + 1]; ++i)
      if (const VertexId v = graph.targets()[i]; !world.is_graph_vertex(u) || !world.is_graph_vertex(v))
        throw SnapshotError(
            SnapshotArray::kTargets, i,
            "row " + std::to_string(u) + " joins it to " + std::to_string(v) + ", which are not both convex and free");
  return std::make_shared<const GraphRows>(world, graph);
}

}  // namespace arcway
