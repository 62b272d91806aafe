#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "accel/expansion/tangent_neighbors.h"
#include "arcway/executor.h"
#include "arcway/visibility_query.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "arcway/world_change.h"
#include "core/roadmap/slot_cache.h"

namespace arcway::internal {

/// Rows of the reduced visibility graph, each computed by tangent-cone expansion when it is first asked for. A first
/// query on a large map needs only few of them; accel_backend gives them to its planners.
///
/// Triangulates free space, see TangentNeighbors for cost and limits. Each row is kept once, as long as the result
/// lives. All rows take 8 bytes an edge of the graph and about 60 bytes a vertex. Thread-safe.
class LazyRows final : public VisibilityRows, public std::enable_shared_from_this<LazyRows> {
 public:
  LazyRows(const World& world, const Executor& executor);

  [[nodiscard]] std::span<const VertexId> of(VertexId vertex) const override;
  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& executor) const override;
  /// See change_rows.
  [[nodiscard]] std::optional<Changed> changed(const World& after, const WorldChange& change,
                                               std::shared_ptr<const VisibilityQuery> visibility) const override;

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const TangentNeighbors& neighbors() const { return neighbors_; }

 private:
  World world_;
  TangentNeighbors neighbors_;
  SlotCache<std::vector<VertexId>> rows_;
};

/// Lazy rows, as above.
std::shared_ptr<const VisibilityRows> make_lazy_rows(const World& world, const Executor& executor = SerialExecutor());

}  // namespace arcway::internal
