#include "core/refine/refine_path.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/base/shortest_text.h"
#include "core/motion/speed_profile.h"
#include "core/refine/circle_chain.h"
#include "core/refine/moves.h"
#include "core/refine/optimize_chain.h"
#include "core/refine/refiner.h"

namespace arcway::internal {

PathRefiner::PathRefiner() : memory_(std::make_unique<Memory>()) {}
PathRefiner::~PathRefiner() = default;
PathRefiner::PathRefiner(PathRefiner&&) noexcept = default;
PathRefiner& PathRefiner::operator=(PathRefiner&&) noexcept = default;

void require_refinement(const RefineOptions& options) {
  if (!(options.smallest_step > 0.0 && std::isfinite(options.smallest_step)))
    throw std::invalid_argument("refinement: smallest step is " + shortest_text(options.smallest_step) +
                                " of the turning radius, must be positive and finite");
}

void PathRefiner::refine(const RefineQuery& query, RefinedPath& result) {
  require_refinement(query.options);
  result.path = query.path;
  result.trials = result.improvements = result.straights_checked = result.turns_checked = 0;
  result.interrupted = false;
  result.travel_time = travel_time(query.path, query.vehicle, query.ends, memory_->profile, query.speed_zones);
  if (chain_of(query.path, query.start, query.goal, memory_->first_chain))
    Refiner(query, *memory_, result).run(memory_->first_chain);
}

RefinedPath refine_path(const RefineQuery& query) {
  RefinedPath result;
  PathRefiner().refine(query, result);
  return result;
}

bool optimizes_turns(const Vehicle& vehicle, const RefineOptions& options) {
  return (options.moves & move_bit("optimize turns")) != 0 && ChainOptimizer::serves(vehicle);
}

}  // namespace arcway::internal
