#include "core/model/vertex_map.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace arcway::internal {

VertexMap::VertexMap(const WorldChange& change)
    : VertexMap(change.removed_vertices, {change.first_added, change.end_added}) {}

VertexMap::VertexMap(std::vector<World::VertexRange> removed, World::VertexRange added)
    : removed_(std::move(removed)), removed_up_to_{0}, first_added_(added.first), end_added_(added.last) {
  for (const World::VertexRange& range : removed_)
    removed_up_to_.push_back(removed_up_to_.back() + range.last - range.first);
}

VertexId VertexMap::after(VertexId before) const {
  const auto next = std::ranges::upper_bound(removed_, before, {}, &World::VertexRange::first);
  const auto count = static_cast<std::size_t>(next - removed_.begin());
  if (count > 0 && before < removed_[count - 1].last) return kNone;
  const VertexId kept = before - removed_up_to_[count];
  return kept < first_added_ ? kept : kept + (end_added_ - first_added_);
}

VertexId VertexMap::before(VertexId after) const {
  if (is_added(after)) return kNone;
  const VertexId kept = after < first_added_ ? after : after - (end_added_ - first_added_);
  std::size_t low = 0, high = removed_.size();  // number of ranges in front of the vertex
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (removed_[middle].first - removed_up_to_[middle] <= kept) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return kept + removed_up_to_[low];
}

VertexMap VertexMap::then(const VertexMap& next) const {
  std::vector<World::VertexRange> removed = removed_;
  VertexId still_added = end_added_ - first_added_;
  for (const World::VertexRange& range : next.removed_) {
    const VertexId count = range.last - range.first;
    if (is_added(range.first)) {
      still_added -= count;
    } else {
      const VertexId first = before(range.first);
      removed.push_back({first, first + count});
    }
  }
  // Both parts ascend.
  std::ranges::inplace_merge(removed, removed.begin() + static_cast<std::ptrdiff_t>(removed_.size()), {},
                             &World::VertexRange::first);
  return {std::move(removed), {next.first_added_ - still_added, next.end_added_}};
}

VertexId VertexMap::common_with(const VertexMap& other) const {
  const auto [mine, others] =
      std::ranges::mismatch(removed_, other.removed_, {}, &World::VertexRange::first, &World::VertexRange::first);
  const VertexId same = removed_up_to_[static_cast<std::size_t>(mine - removed_.begin())];
  VertexId common = std::min(first_added_, other.first_added_);
  if (mine != removed_.end()) common = std::min(common, mine->first - same);
  if (others != other.removed_.end()) common = std::min(common, others->first - same);
  return common;
}

}  // namespace arcway::internal
