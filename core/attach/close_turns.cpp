#include "core/attach/close_turns.h"

#include <utility>

namespace arcway::internal {

CloseTurns::CloseTurns(std::shared_ptr<const FeasibleGraph> graph, std::shared_ptr<const ClearanceCost> cost)
    : graph_(std::move(graph)), cost_(std::move(cost)), close_(graph_->circles().size()) {}

double CloseTurns::cost_of(std::uint32_t circle, double heading, double turn) const {
  const TurnCircle& c = graph_->circles()[circle];
  const auto& close = close_.get(
      circle, [&] { return std::make_unique<const Close>(cost_->close_headings(c.center, c.radius, c.side)); });
  double sum = 0.0;
  for (const ClearanceCost::CloseHeadings& of_rule : close)
    sum += of_rule.cost * c.radius * angle_within(of_rule.headings, heading, c.side, turn);
  return sum;
}

}  // namespace arcway::internal
