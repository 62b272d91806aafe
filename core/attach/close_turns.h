#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/collision/clearance_cost.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/slot_cache.h"

namespace arcway::internal {

/// What turns on the circles of a graph cost that are driven close to obstacles. The headings at which the grown body
/// touches one are found when a search first asks for a circle, and kept. Thread-safe.
class CloseTurns {
 public:
  CloseTurns(std::shared_ptr<const FeasibleGraph> graph, std::shared_ptr<const ClearanceCost> cost);

  /// The cost of a turn on a circle, from a heading on [s]. O(intervals), once the circle's headings are known.
  /// @param turn  [rad], >= 0.
  [[nodiscard]] double cost_of(std::uint32_t circle, double heading, double turn) const;

 private:
  using Close = std::vector<ClearanceCost::CloseHeadings>;

  std::shared_ptr<const FeasibleGraph> graph_;
  std::shared_ptr<const ClearanceCost> cost_;
  SlotCache<Close> close_;  // by circle
};

}  // namespace arcway::internal
