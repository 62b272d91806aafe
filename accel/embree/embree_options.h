#pragma once

#include <memory>

#include "arcway/executor.h"
#include "arcway/stop_clock.h"

namespace arcway::internal {

/// How make_embree_queries answers.
struct EmbreeOptions {
  /// Half the width of the bodies that SweepQuery::straight_free is mostly asked about [m]; wider ones are as right and
  /// take longer. 0: half the mean length of the world's edges.
  double body_half_width = 0.0;
  /// Runs batches of 128 and more questions; none: the calling thread does, and no call but free_headings allocates.
  std::shared_ptr<const Executor> batches = nullptr;
  /// Ends the building, which then throws Cancelled.
  StopClock clock = {};
};

}  // namespace arcway::internal
