#include "accel/graphs/lazy_rows.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "accel/expansion/tangent_neighbors.h"
#include "core/base/huge_pages.h"
#include "core/roadmap/slot_cache.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

namespace {

// Calls visit(pairs, u, v) for all pairs of vertices within a distance, and some others, by a grid of cells of that
// size. Each thread has its own `pairs`. Returns their union in any order.
template <class Visit>
std::vector<VisibilityRows::Pair> collect_near_pairs(const World& world, double distance, const Executor& executor,
                                                     const Visit& visit) {
  constexpr double kMostCells = 1e9;  // a side
  constexpr std::size_t kGrain = 1024;
  struct Item {
    std::uint64_t cell;  // column, then row
    VertexId vertex;
  };
  const Vec2 low = world.box().min;
  // A little larger than the distance, so that rounding never puts a whole cell between such a pair.
  const double size = std::max(distance, (world.box().max - low).maxCoeff() / kMostCells) * (1.0 + 0x1p-20);
  const auto cell_of = [&](const Vec2& p) {
    const Vec2 place = (p - low) / size;
    return (static_cast<std::uint64_t>(place.x()) << 32) + static_cast<std::uint64_t>(place.y());
  };
  HugeVector<Item> items;
  items.reserve(world.convex_vertices().size());
  for (const VertexId v : world.convex_vertices()) items.push_back({cell_of(world.vertex(v)), v});
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.cell != b.cell ? a.cell < b.cell : a.vertex < b.vertex; });
  constexpr std::uint64_t kColumn = std::uint64_t{1} << 32;
  const auto lies_before = [](const Item& item, std::uint64_t cell) { return item.cell + 1 < cell; };
  std::mutex mutex;
  std::vector<VisibilityRows::Pair> pairs;
  executor.for_ranges(items.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<VisibilityRows::Pair> here;
    const auto from = std::lower_bound(items.begin(), items.end(), items[begin].cell + kColumn, lies_before);
    auto next = static_cast<std::size_t>(from - items.begin());  // item of the next column
    for (std::size_t i = begin; i < end; ++i) {
      end_if_over(executor);  // a vertex may have nearly all others near it
      for (std::size_t k = i + 1; k < items.size() && items[k].cell <= items[i].cell + 1; ++k)
        visit(here, items[i].vertex, items[k].vertex);
      while (next < items.size() && lies_before(items[next], items[i].cell + kColumn)) ++next;
      for (std::size_t k = next; k < items.size() && items[k].cell <= items[i].cell + kColumn + 1; ++k)
        visit(here, items[i].vertex, items[k].vertex);
    }
    const std::lock_guard lock(mutex);
    pairs.insert(pairs.end(), here.begin(), here.end());
  });
  return pairs;
}

class LazyRows final : public VisibilityRows {
 public:
  LazyRows(const World& world, const Executor& executor)
      : world_(world), neighbors_(world, executor), rows_(world.vertices().size()) {}

  [[nodiscard]] std::span<const VertexId> of(VertexId vertex) const override {
    return rows_.get(vertex, [&] { return std::make_unique<const std::vector<VertexId>>(neighbors_.of(vertex)); });
  }

  [[nodiscard]] std::vector<Pair> pairs_within(double length, const std::function<bool(VertexId, VertexId)>& wanted,
                                               const Executor& executor) const override {
    if (!(length > 0.0)) return {};
    const auto visit = [&](std::vector<Pair>& pairs, VertexId u, VertexId v) {
      const Vec2 &at_u = world_.vertex(u), &at_v = world_.vertex(v);
      if (!((at_v - at_u).norm() <= length) || !wanted(u, v)) return;
      if (!is_tangent(world_, u, at_v) || !is_tangent(world_, v, at_u)) return;
      if (std::ranges::binary_search(of(u), v)) pairs.emplace_back(std::minmax(u, v));
    };
    std::vector<Pair> pairs = collect_near_pairs(world_, length, executor, visit);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

 private:
  World world_;
  TangentNeighbors neighbors_;
  SlotCache<std::vector<VertexId>> rows_;
};

}  // namespace

std::shared_ptr<const VisibilityRows> make_lazy_rows(const World& world, const Executor& executor) {
  return std::make_shared<const LazyRows>(world, executor);
}

}  // namespace arcway::internal
