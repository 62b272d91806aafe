#include "core/geometry/edge_sweep.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "core/geometry/predicates.h"

namespace arcway::internal {
namespace {

bool is_left_of(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

}  // namespace

EdgeSweep::EdgeSweep(std::span<const LineSegment> edges)
    : edges_(edges), goes_right_(edges.size()), place_(edges.size(), active_.end()) {
  for (std::uint32_t e = 0; e < edges.size(); ++e) goes_right_[e] = is_left_of(edges[e].a, edges[e].b);
}

int EdgeSweep::side(std::uint32_t e, const Vec2& p) const { return orientation(low(e), high(e), p); }

// The later of two active edges starts within the span of the other one.
bool EdgeSweep::Below::operator()(std::uint32_t e, std::uint32_t f) const {
  const bool e_is_first = is_left_of(sweep->low(e), sweep->low(f));
  const std::uint32_t first = e_is_first ? e : f, second = e_is_first ? f : e;
  int side = sweep->side(first, sweep->low(second));
  if (side == 0) side = sweep->side(first, sweep->high(second));
  if (side == 0) return e < f;
  return (side > 0) == e_is_first;
}

bool EdgeSweep::run(Visitor& visitor) {
  std::vector<std::uint32_t> ends(2 * edges_.size());  // edge, twice; odd for its second end
  std::iota(ends.begin(), ends.end(), 0u);
  const auto at = [&](std::uint32_t end) -> const Vec2& {
    return end % 2 == 0 ? edges_[end / 2].a : edges_[end / 2].b;
  };
  std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (is_left_of(at(a), at(b))) return true;
    return at(a) == at(b) && a < b;
  });
  std::vector<std::uint32_t> here;
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    const Vec2 p = at(ends[first]);
    here.clear();
    while (last < ends.size() && at(ends[last]) == p) here.push_back(ends[last++] / 2);
    list_left(p, here);
    if (!test_passing(visitor)) return false;
    pass(here, p, visitor);
    visitor.visit({p, below_, left_, right_, here});
    const auto lowest = below_ == kNoEdge ? active_.begin() : place_[below_];
    if (!test_neighbors(lowest, visitor)) return false;
    if (right_.empty()) continue;
    // Its neighbors may have been taken out meanwhile.
    const auto highest =
        std::find_if(right_.rbegin(), right_.rend(), [&](std::uint32_t e) { return place_[e] != active_.end(); });
    if (highest != right_.rend() && !test_neighbors(place_[*highest], visitor)) return false;
  }
  return true;
}

// The active edges with the point on them, ascending, and the one below them.
void EdgeSweep::list_left(const Vec2& p, std::span<const std::uint32_t> ends) {
  const auto known =
      std::find_if(ends.begin(), ends.end(), [&](std::uint32_t e) { return place_[e] != active_.end(); });
  auto first = known != ends.end() ? place_[*known] : active_.lower_bound(p);
  auto last = first;
  while (first != active_.begin() && side(*std::prev(first), p) == 0) --first;
  while (last != active_.end() && side(*last, p) == 0) ++last;
  left_.assign(first, last);
  below_ = first == active_.begin() ? kNoEdge : *std::prev(first);
  passing_.clear();
  for (const std::uint32_t e : left_)
    if (high(e) != p) passing_.push_back(e);
}

// Edges that end at the point go, those that start there come.
void EdgeSweep::pass(std::span<const std::uint32_t> ends, const Vec2& p, const Visitor& visitor) {
  right_.clear();
  for (const std::uint32_t e : left_)
    if (place_[e] != active_.end() && high(e) == p) leave(e);
  for (const std::uint32_t e : ends) {
    if (low(e) != p || visitor.is_left_out(e)) continue;
    place_[e] = active_.insert(e).first;
    right_.push_back(e);
  }
  for (const std::uint32_t e : passing_)
    if (place_[e] != active_.end()) right_.push_back(e);
  std::sort(right_.begin(), right_.end(), active_.key_comp());
}

// Edges that pass through the same point must be on one line.
bool EdgeSweep::test_passing(Visitor& visitor) {
  for (std::size_t i = 0; i + 1 < passing_.size();) {
    const std::uint32_t e = passing_[i], f = passing_[i + 1];
    if (side(e, high(f)) == 0 && side(e, low(f)) == 0) {
      ++i;
      continue;
    }
    if (!visitor.crosses(e, f)) return false;
    for (const std::uint32_t edge : {e, f}) {
      if (!visitor.is_left_out(edge)) continue;
      leave(edge);
      std::erase(passing_, edge);
    }
    i -= i > 0 ? 1 : 0;
  }
  return true;
}

// Tests an edge and the one above it, until they do not cross.
bool EdgeSweep::test_neighbors(Order::iterator lower, Visitor& visitor) {
  while (lower != active_.end() && std::next(lower) != active_.end()) {
    const std::uint32_t e = *lower, f = *std::next(lower);
    if (relate(edges_[e], edges_[f]) != SegmentRelation::kCrossing) return true;
    if (!visitor.crosses(e, f)) return false;
    if (visitor.is_left_out(f)) leave(f);
    if (!visitor.is_left_out(e)) continue;
    if (lower == active_.begin()) {
      leave(e);
      return true;
    }
    --lower;
    leave(e);
  }
  return true;
}

void EdgeSweep::leave(std::uint32_t e) {
  active_.erase(place_[e]);
  place_[e] = active_.end();
}

bool SweptDepths::is_region_above(std::uint32_t e) const { return is_left_of(edges_[e].a, edges_[e].b); }

}  // namespace arcway::internal
