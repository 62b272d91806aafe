#include "core/gaps/local_sweep.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/predicates.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kMostEdges =
    256;  // largest number of edges kept: to find the one in the way among more takes longer than a query
constexpr std::size_t kLately = 6;

}  // namespace

LocalSweep::LocalSweep(const SweepQuery& sweep, const Outlines& outlines, const Box& place)
    : sweep_(sweep), place_(place) {
  has_all_edges_ = outlines.visit_if([&](const Box& box) { return box.overlaps(place); },
                                     [&](const Outlines::Piece& piece) {
                                       for (std::size_t i = 0; i < piece.edge_count(); ++i) {
                                         const LineSegment edge{piece.points[i], piece.points[i + 1]};
                                         const Box box = box_of(edge);
                                         if (box.overlaps(place)) edges_.push_back({edge, box});
                                       }
                                       return edges_.size() < kMostEdges;
                                     });
}

bool LocalSweep::straight_free(const SweptRectangle& rectangle) {
  Box box;
  for (const Vec2& corner : rectangle) box.extend(corner);
  const auto lately = edges_.begin() + static_cast<std::ptrdiff_t>(std::min(kLately, edges_.size()));
  // Whether one of the edges blocks the rectangle. That edge is moved to the front.
  const auto meets_one = [&](auto first, auto last) {
    const auto met = std::find_if(
        first, last, [&](const Edge& edge) { return edge.box.overlaps(box) && intersects(edge.segment, rectangle); });
    if (met == last) return false;
    std::rotate(edges_.begin(), met, met + 1);
    return true;
  };
  if (meets_one(edges_.begin(), lately)) return false;
  if (!has_all_edges_ || !(place_.contains(box.min) && place_.contains(box.max))) {
    if (sweep_.straight_free(rectangle)) return true;
    meets_one(lately, edges_.end());
    return false;
  }
  if (meets_one(lately, edges_.end())) return false;
  // The rectangle meets no edge: it lies inside an obstacle, or is free.
  const bool is_beside_free = free_ && sees({*free_, rectangle[0]});
  if (!is_beside_free && !sweep_.straight_free(rectangle)) return false;
  free_ = rectangle[0];
  return true;
}

bool LocalSweep::sees(const LineSegment& line) const {
  const Box box = box_of(line);
  return std::none_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
    return edge.box.overlaps(box) && relate(edge.segment, line) != SegmentRelation::kDisjoint;
  });
}

}  // namespace arcway::internal
