#include "core/attach/close_turns.h"

#include <utility>

namespace arcway::internal {

CloseTurns::CloseTurns(std::shared_ptr<const FeasibleGraph> graph, std::shared_ptr<const ClearanceCost> cost)
    : graph_(std::move(graph)), cost_(std::move(cost)), close_(graph_->circles().size()) {}

double CloseTurns::cost_of(std::uint32_t circle, double heading, double turn) const {
  const TurnCircle& c = graph_->circles()[circle];
  const auto& close = close_.get(
      circle, [&] { return std::make_unique<const Close>(cost_->close_headings(c.center, c.radius, c.side)); });
  return turn_cost(close, {c.radius, c.side, heading, turn});
}

}  // namespace arcway::internal
