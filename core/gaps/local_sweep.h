#pragma once

#include <optional>
#include <vector>

#include "arcway/sweep_query.h"
#include "arcway/vec2.h"
#include "core/model/outlines.h"

namespace arcway::internal {

/// Answers thousands of sweep queries about one place, most of them without asking the sweep query. First it tests the
/// few edges that blocked lately. If none blocks, a rectangle is free if no edge lies between it and a point known to
/// be free. Refers to the query. Not thread-safe.
class LocalSweep {
 public:
  /// @param place  edges of the world that reach into it are kept, if they are few [m].
  LocalSweep(const SweepQuery& sweep, const Outlines& outlines, const Box& place);

  /// See SweepQuery::straight_free.
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
  std::vector<Edge> edges_;   // near the place, those that blocked lately first
  bool has_all_edges_;        // of those that reach into the place
  std::optional<Vec2> free_;  // a point in the place that no obstacle holds or touches
};

}  // namespace arcway::internal
