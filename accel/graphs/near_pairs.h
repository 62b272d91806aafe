#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

#include "arcway/executor.h"
#include "arcway/visibility_rows.h"
#include "arcway/world.h"
#include "core/base/huge_pages.h"
#include "core/roadmap/tangent_edges.h"

namespace arcway::internal {

/// Calls visit(pairs, u, v) for all pairs of convex vertices within a distance, and some others, by a grid of cells of
/// that size. Each thread has its own `pairs`. Returns their union in any order.
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

/// VisibilityRows::pairs_within of rows that find each row when it is first asked for.
inline std::vector<VisibilityRows::Pair> lazy_pairs_within(const World& world, const VisibilityRows& rows,
                                                           double length,
                                                           const std::function<bool(VertexId, VertexId)>& wanted,
                                                           const Executor& executor) {
  if (!(length > 0.0)) return {};
  const auto visit = [&](std::vector<VisibilityRows::Pair>& pairs, VertexId u, VertexId v) {
    const Vec2 &at_u = world.vertex(u), &at_v = world.vertex(v);
    if (!((at_v - at_u).norm() <= length) || !wanted(u, v)) return;
    if (!is_tangent(world, u, at_v) || !is_tangent(world, v, at_u)) return;
    if (std::ranges::binary_search(rows.of(u), v)) pairs.emplace_back(std::minmax(u, v));
  };
  std::vector<VisibilityRows::Pair> pairs = collect_near_pairs(world, length, executor, visit);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace arcway::internal
