#include "core/roadmap/extend_feasible_graph.h"

#include <utility>

namespace arcway::internal {

std::shared_ptr<const LazyFeasibleGraph> extend_feasible_graph(std::shared_ptr<const FeasibleGraph> base,
                                                               const Vehicle& vehicle, const AddedCircles& added,
                                                               const StopClock& clock) {
  auto checks = std::make_shared<const CircleChecks>(base->checks(), vehicle, added, clock);
  return std::make_shared<const LazyFeasibleGraph>(std::move(checks), std::move(base));
}

}  // namespace arcway::internal
