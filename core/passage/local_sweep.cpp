#include "core/passage/local_sweep.h"

#include <algorithm>
#include <cstddef>

#include "core/geometry/predicates.h"

namespace arcway {

namespace {

constexpr std::size_t kMostEdges = 256;  // beyond, looking for the one in the way would take longer than asking
constexpr std::size_t kLately = 6;

}  // namespace

LocalSweep::LocalSweep(const SweepQuery& sweep, const Outlines& outlines, const Box& place) : sweep_(sweep) {
  outlines.visit_if([&](const Box& box) { return box.overlaps(place); },
                    [&](const Outlines::Piece& piece) {
                      for (std::size_t i = 0; i < piece.edge_count(); ++i) {
                        const LineSegment edge{piece.points[i], piece.points[i + 1]};
                        if (box_of(edge).overlaps(place)) edges_.push_back(edge);
                      }
                      return edges_.size() < kMostEdges;
                    });
}

bool LocalSweep::straight_free(const SweptRectangle& rectangle) {
  const auto lately = edges_.begin() + static_cast<std::ptrdiff_t>(std::min(kLately, edges_.size()));
  // Whether one of them is in the way. It comes first then.
  const auto meets_one = [&](auto first, auto last) {
    const auto met = std::find_if(first, last, [&](const LineSegment& edge) { return intersects(edge, rectangle); });
    if (met == last) return false;
    std::rotate(edges_.begin(), met, met + 1);
    return true;
  };
  if (meets_one(edges_.begin(), lately)) return false;
  if (sweep_.straight_free(rectangle)) return true;
  meets_one(lately, edges_.end());
  return false;
}

}  // namespace arcway
