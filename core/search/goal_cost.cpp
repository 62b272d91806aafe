#include "core/search/goal_cost.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/infinity.h"
#include "core/collision/clearance_cost.h"

namespace arcway::internal {

namespace {

// Number of lines of links that are measured; each takes some microseconds.
constexpr std::size_t kMostLines = 64;
// Number of circles of goal attachments whose arcs are measured; each takes some microseconds. The first ones, two a
// radius, are those of the goal itself, where a path has no connection.
constexpr std::size_t kMostArcs = 64;

class GoalLinkCosts {
 public:
  GoalLinkCosts(const SearchContext& context, const SearchAttachments& attachments)
      : cost_(*context.map.clearance_cost), attachments_(attachments) {
    for (const Attachment& goal : context.goals) connections_.push_back(cost_.of(goal.connection));
    const std::span<const AttachmentCircle> circles = attachments.goal_circles();
    arcs_.resize(circles.size());
    for (std::size_t i = 0; i < std::min(circles.size(), kMostArcs); ++i)
      arcs_[i] = cost_.close_headings(circles[i].circle.center, circles[i].circle.radius, circles[i].circle.side);
  }

  // Of the arc and the connection.
  [[nodiscard]] double behind_line(const AttachmentLink& link) const {
    const AttachmentCircle& to = attachments_.goal_circles()[link.attachment_circle];
    const Turn turn{to.circle.radius, to.circle.side, link.line.start.heading, link.turn};
    return connections_[to.attachment] + turn_cost(arcs_[link.attachment_circle], turn);
  }
  [[nodiscard]] double of_line(const AttachmentLink& link) const {
    return cost_.of(PathSegment{link.line.start, link.line.length, 0.0});
  }

 private:
  const ClearanceCost& cost_;
  const SearchAttachments& attachments_;
  std::vector<double> connections_;                              // by attachment
  std::vector<std::vector<ClearanceCost::CloseHeadings>> arcs_;  // by goal circle
};

}  // namespace

double least_goal_cost(SearchContext& context, SearchAttachments& attachments) {
  if (!context.map.clearance_cost) return 0.0;
  const GoalLinkCosts costs(context, attachments);
  struct Candidate {
    double cost;  // without the line
    std::uint32_t link;
  };
  std::vector<Candidate> candidates;
  for (std::uint32_t g = 0; g < attachments.goal_links().size(); ++g)
    candidates.push_back({costs.behind_line(attachments.goal_link(g).link), g});
  std::ranges::sort(candidates, {}, &Candidate::cost);
  double least = kInfinity;
  std::size_t measured = 0;
  for (const Candidate& candidate : candidates) {
    if (candidate.cost >= least || measured == kMostLines) return std::min(least, candidate.cost);
    SearchAttachments::GoalLink& goal = attachments.goal_link(candidate.link);
    if (!attachments.is_free(goal)) continue;
    least = std::min(least, candidate.cost + costs.of_line(goal.link));
    ++measured;
  }
  return least;
}

}  // namespace arcway::internal
