#include "core/model/world_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace arcway::internal {

WorldHistory::WorldHistory(std::uint64_t world, const WorldHistory& before, const VertexMap& change,
                           std::shared_ptr<const HugeVector<VertexId>> convex)
    : origin_(before.origin_),
      world_(world),
      world_before_(before.world_),
      last_(change),
      map_(before.map_.then(change)),
      convex_(std::move(convex)),
      flipped_(before.flipped_) {}

void WorldHistory::flip(std::span<const VertexId> flipped) {
  std::vector<VertexId> of_origin;
  for (const VertexId v : flipped)
    if (const VertexId was = map_.before(v); was != kNone) of_origin.push_back(was);
  std::ranges::sort(of_origin);
  const std::vector<VertexId> before = std::move(flipped_);
  flipped_.clear();
  std::ranges::set_symmetric_difference(before, of_origin, std::back_inserter(flipped_));
}

VertexId WorldHistory::aligned_with(const WorldHistory& other) const {
  return has_origin_of(other) ? map_.aligned_with(other.map_) : 0;
}

std::vector<VertexId> WorldHistory::flipped_from(const WorldHistory& other) const {
  std::vector<VertexId> flipped_in_one, found;
  if (!has_origin_of(other)) return found;
  std::ranges::set_symmetric_difference(flipped_, other.flipped_, std::back_inserter(flipped_in_one));
  for (const VertexId v : flipped_in_one)
    if (const VertexId now = map_.after(v); now != kNone) found.push_back(now);
  return found;
}

}  // namespace arcway::internal
