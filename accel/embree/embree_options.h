#pragma once

#include <memory>

#include "arcway/executor.h"
#include "arcway/stop_clock.h"

namespace arcway::internal {

/// Options of make_embree_queries.
struct EmbreeOptions {
  /// Half the width of the bodies that SweepQuery::straight_free is mostly asked about [m]; 0: half the mean length of
  /// the world's edges. Queries about wider bodies are as exact and take longer.
  double body_half_width = 0.0;
  /// Runs batches of 128 and more queries in parallel; null: on the calling thread, and only free_headings allocates.
  std::shared_ptr<const Executor> batches = nullptr;
  /// Stops the build, which then throws Canceled.
  StopClock clock = {};
};

}  // namespace arcway::internal
