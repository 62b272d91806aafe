#include "core/model/world_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace arcway::internal {

WorldHistory::WorldHistory(const WorldHistory& before, const VertexMap& change, const std::vector<VertexId>& flipped,
                           std::shared_ptr<const HugeVector<VertexId>> convex)
    : origin_(before.origin_), map_(before.map_.then(change)), convex_(std::move(convex)) {
  std::vector<VertexId> of_origin;
  for (const VertexId v : flipped)
    if (const VertexId was = map_.before(v); was != kNone) of_origin.push_back(was);
  std::ranges::sort(of_origin);  // the bounds' vertices are behind those of added obstacles
  std::ranges::set_symmetric_difference(before.flipped_, of_origin, std::back_inserter(flipped_));
}

VertexId WorldHistory::common_with(const WorldHistory& other) const {
  if (!has_origin_of(other)) return 0;
  VertexId common = map_.common_with(other.map_);
  std::vector<VertexId> flipped_in_one;
  std::ranges::set_symmetric_difference(flipped_, other.flipped_, std::back_inserter(flipped_in_one));
  for (const VertexId v : flipped_in_one)
    if (const VertexId now = map_.after(v); now != kNone) common = std::min(common, now);
  return common;
}

bool WorldHistory::differs_within(VertexId first, VertexId last) const {
  const auto at = std::ranges::lower_bound(flipped_, first);
  return at != flipped_.end() && *at < last;
}

}  // namespace arcway::internal
