#pragma once

#include <vector>

#include "core/geometry/vec2.h"
#include "core/outlines.h"
#include "core/query/sweep_query.h"

namespace [[gnu::visibility("default")]] arcway {

/// Answers thousands of questions about one place with a sweep query, which most of the time need not be asked: the
/// same few edges are in the way again and again. Refers to the query. Not thread-safe.
class LocalSweep {
 public:
  /// @param place  edges of the world that get here are remembered, as long as they are few.
  LocalSweep(const SweepQuery& sweep, const Outlines& outlines, const Box& place);

  /// As SweepQuery::straight_free.
  [[nodiscard]] bool straight_free(const SweptRectangle& rectangle);

 private:
  const SweepQuery& sweep_;
  std::vector<LineSegment> edges_;  // near the place, those that were in the way lately first
};

}  // namespace arcway
