#include "accel/graphs/lazy_rows.h"

#include <memory>
#include <utility>

#include "accel/graphs/changed_rows.h"
#include "accel/graphs/near_pairs.h"

namespace arcway::internal {

LazyRows::LazyRows(const World& world, const Executor& executor)
    : world_(world), neighbors_(world, executor), rows_(world.vertices().size()) {}

std::span<const VertexId> LazyRows::of(VertexId vertex) const {
  return rows_.get(vertex, [&] { return std::make_unique<const std::vector<VertexId>>(neighbors_.of(vertex)); });
}

std::vector<VisibilityRows::Pair> LazyRows::pairs_within(double length,
                                                         const std::function<bool(VertexId, VertexId)>& wanted,
                                                         const Executor& executor) const {
  return lazy_pairs_within(world_, *this, length, wanted, executor);
}

std::optional<VisibilityRows::Changed> LazyRows::changed(const World& after, const WorldChange& change,
                                                         std::shared_ptr<const VisibilityQuery> visibility) const {
  return change_rows(shared_from_this(), after, change, std::move(visibility));
}

std::shared_ptr<const VisibilityRows> make_lazy_rows(const World& world, const Executor& executor) {
  return std::make_shared<const LazyRows>(world, executor);
}

}  // namespace arcway::internal
