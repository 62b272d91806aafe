#include "core/model/vertex_map.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace arcway::internal {

namespace {

bool is_same(const World::VertexRange& a, const World::VertexRange& b) {
  return a.first == b.first && a.last == b.last;
}

void insert_ascending(const std::vector<World::VertexRange>& more, std::vector<World::VertexRange>& ranges) {
  const auto first = static_cast<std::ptrdiff_t>(ranges.size());
  ranges.insert(ranges.end(), more.begin(), more.end());
  std::ranges::inplace_merge(ranges, ranges.begin() + first, {}, &World::VertexRange::first);
}

}  // namespace

VertexMap::Ranges::Ranges(std::vector<World::VertexRange> ranges) : all(std::move(ranges)), up_to{0} {
  for (const World::VertexRange& range : all) up_to.push_back(up_to.back() + range.last - range.first);
}

bool VertexMap::Ranges::holds(VertexId v) const {
  const auto next = std::ranges::upper_bound(all, v, {}, &World::VertexRange::first);
  return next != all.begin() && v < (next - 1)->last;
}

VertexId VertexMap::Ranges::place_of(VertexId v) const {
  const auto next = std::ranges::upper_bound(all, v, {}, &World::VertexRange::first);
  return v - up_to[static_cast<std::size_t>(next - all.begin())];
}

VertexId VertexMap::Ranges::at(VertexId place) const {
  std::size_t low = 0, high = all.size();  // number of ranges in front of the vertex
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (all[middle].first - up_to[middle] <= place) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return place + up_to[low];
}

VertexMap::VertexMap(const WorldChange& change) : VertexMap(change.removed_vertices, change.added_vertices) {}

VertexMap::VertexMap(std::vector<World::VertexRange> removed, std::vector<World::VertexRange> added)
    : removed_(std::move(removed)), added_(std::move(added)) {}

VertexId VertexMap::after(VertexId before) const {
  return removed_.holds(before) ? kNone : added_.at(removed_.place_of(before));
}

VertexId VertexMap::before(VertexId after) const {
  return added_.holds(after) ? kNone : removed_.at(added_.place_of(after));
}

bool VertexMap::keeps_numbers() const { return std::ranges::equal(removed_.all, added_.all, is_same); }

VertexMap VertexMap::then(const VertexMap& next) const {
  std::vector<World::VertexRange> removed = removed_.all, removed_later, added = next.added_.all, added_before;
  for (const World::VertexRange& range : next.removed_.all)
    if (const VertexId first = before(range.first); first != kNone)
      removed_later.push_back({first, first + (range.last - range.first)});
  for (const World::VertexRange& range : added_.all)
    if (const VertexId first = next.after(range.first); first != kNone)
      added_before.push_back({first, first + (range.last - range.first)});
  insert_ascending(removed_later, removed);
  insert_ascending(added_before, added);
  return {std::move(removed), std::move(added)};
}

VertexId VertexMap::aligned_with(const VertexMap& other) const {
  struct Run {
    World::VertexRange here;
    VertexId there;
  };
  const auto runs_of = [](const VertexMap& map) {
    std::vector<Run> runs;
    map.visit(
        kNone,
        [&](const World::VertexRange& range, VertexId before) {
          runs.push_back({range, before});
        },
        [](const World::VertexRange&) {});
    return runs;
  };
  const std::vector<Run> mine = runs_of(*this), others = runs_of(other);
  for (auto a = mine.begin(), b = others.begin(); a != mine.end() && b != others.end();) {
    const VertexId first = std::max(a->here.first, b->here.first);
    if (first < std::min(a->here.last, b->here.last) && a->there + b->here.first != b->there + a->here.first)
      return first;
    ++(a->here.last < b->here.last ? a : b);
  }
  return kNone;
}

std::vector<World::VertexRange> VertexMap::added_in_either(const VertexMap& other) const {
  std::vector<World::VertexRange> ranges = added_.all;
  insert_ascending(other.added_.all, ranges);
  ranges.erase(std::unique(ranges.begin(), ranges.end(), is_same), ranges.end());
  return ranges;
}

}  // namespace arcway::internal
