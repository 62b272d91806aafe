#pragma once

#include <optional>
#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Answers thousands of questions about one place with a sweep query, which most of the time need not be asked: the
/// same few edges are in the way again and again, and what meets none of them is free if no edge lies between it and
/// what was free before. Refers to the query. Not thread-safe.
class LocalSweep {
 public:
  /// @param place  edges of the world that get here are remembered, as long as they are few.
  LocalSweep(const SweepQuery& sweep, const Outlines& outlines, const Box& place);

  /// As SweepQuery::straight_free.
  [[nodiscard]] bool straight_free(const SweptRectangle& rectangle);

 private:
  struct Edge {
    LineSegment segment;
    Box box;
  };

  // Whether a segment in the place meets no edge.
  [[nodiscard]] bool sees(const LineSegment& line) const;

  const SweepQuery& sweep_;
  Box place_;
  std::vector<Edge> edges_;   // near the place, those that were in the way lately first
  bool has_all_edges_;        // that get to the place
  std::optional<Vec2> free_;  // a point in the place that no obstacle holds or touches
};

}  // namespace arcway::internal
