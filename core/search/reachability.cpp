#include "core/search/reachability.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "arcway/angle.h"
#include "core/attach/circle_table.h"
#include "core/attach/walk_links.h"

namespace arcway::internal {

namespace {

constexpr std::size_t kLargestBackwardSet =
    4096;                            // number of departures at which the backward-reachable set is given up
constexpr std::size_t kOpen = 5000;  // number of arcs that no dead end around the start has

// Largest number of circles of a lazy graph for which all rows are made. A walk from the start makes many of them
// anyway.
constexpr std::size_t kMostLazyCircles = 300'000;

}  // namespace

void Reachability::forget() {
  open_.clear();
  arcs_.clear();
}

bool Reachability::goal_is_reachable(SearchContext& context, SearchAttachments& attachments) {
  context_ = &context;
  attachments_ = &attachments;
  if (arcs_.empty()) {
    first_arc_.reset(context.graph.circles().size());
  } else {
    context.result.start_connected = true;
  }
  for (std::uint32_t g = 0; g < attachments.goal_links().size(); ++g)
    if (is_known(attachments.goal_link(g))) return true;
  // Start links of the question before have other indices.
  open_.keep_if([](const Arrival& arrival) { return arrival.circle != kNone; });
  for (std::uint32_t s = 0; s < attachments.start_circles().size() && !context.interrupted(); ++s) {
    if (attachments.start_circles()[s].reach < 0.0) continue;
    const auto range = attachments.links_from(s);
    for (std::uint32_t i = range.first; i < range.last; ++i) push(kNone, i);
  }
  for (;;) {
    // Most walks reach the goal long before.
    if (arcs_.size() >= kOpen && !context.result.start_is_open) {
      context.result.start_is_open = true;
      if (goal_is_in_dead_end()) return false;
    }
    if (context.interrupted() || open_.empty()) return context.result.interrupted;
    if (reaches_goal(open_.pop())) return true;
  }
}

// Whether the goal is in a dead end: its backward-reachable set is small, and the start does not lead to it.
bool Reachability::goal_is_in_dead_end() {
  const CircleTable& circles = *context_->map.circles;
  if (attachments_->goal_links().size() > kLargestBackwardSet || !has_links_to(circles)) return false;
  std::vector<Departure> ends;
  for (std::uint32_t g = 0; g < attachments_->goal_links().size(); ++g) {
    SearchAttachments::GoalLink& goal = attachments_->goal_link(g);
    if (attachments_->is_free(goal)) ends.push_back({goal.link.circle, goal.link.line.start.heading});
  }
  const auto backward_set = backward_reachable_set(circles, std::move(ends), kLargestBackwardSet);
  return backward_set && !start_leads_to(*backward_set);
}

// Makes the rows of a lazy graph, if they are not too many, for looking up links by their destination.
bool Reachability::has_links_to(const CircleTable& circles) {
  if (circles.is_lazy() && circles.size() > kMostLazyCircles && !circles.knows_links_to()) return false;
  return circles.find_links_to(context_->options.clock);
}

bool Reachability::start_leads_to(const std::vector<Departure>& backward_set) {
  PerCircle first;
  first.reset(context_->graph.circles().size());
  std::vector<std::uint32_t> next;
  for (std::uint32_t i = 0; i < backward_set.size(); ++i) {
    next.push_back(first.get(backward_set[i].circle));
    first.set(backward_set[i].circle, i);
  }
  for (std::uint32_t s = 0; s < attachments_->start_circles().size() && !context_->interrupted(); ++s) {
    if (attachments_->start_circles()[s].reach < 0.0) continue;
    const auto range = attachments_->links_from(s);
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const AttachmentLink& link = attachments_->start_link(i);
      for (std::uint32_t d = first.get(link.circle); d != kNone; d = next[d])
        if (leads_to(*context_->map.circles, link.line.start.heading, backward_set[d]) && context_->is_free(link.line))
          return true;
    }
  }
  return false;
}

Reachability::Place Reachability::place_of(std::uint32_t circle, std::uint32_t index) const {
  if (circle == kNone)
    return {attachments_->start_link(index).circle, attachments_->start_link(index).line.start.heading};
  const FeasibleGraph::Link& link = context_->graph.links_from(circle)[index];
  return {link.to, link.heading};
}

void Reachability::push(std::uint32_t circle, std::uint32_t index) {
  const Place at = place_of(circle, index);
  const Vec2 position = pose_on(context_->graph.circles()[at.circle], at.heading).position();
  open_.push({(context_->goal - position).norm(), circle, index});
}

bool Reachability::is_known(SearchAttachments::GoalLink& goal) {
  const double heading = goal.link.line.start.heading;
  const Side side = context_->graph.circles()[goal.link.circle].side;
  for (std::uint32_t i = first_arc_.get(goal.link.circle); i != kNone; i = arcs_[i].next)
    if (turn_between(arcs_[i].heading, heading, side) <= arcs_[i].reach) return attachments_->is_free(goal);
  return false;
}

// Takes an arrival if it is free and new; true if the goal is reached from the part of the circle ahead of it.
bool Reachability::reaches_goal(const Arrival& arrival) {
  const FeasibleGraph& graph = context_->graph;
  const auto [c, heading] = place_of(arrival.circle, arrival.index);
  const Side side = graph.circles()[c].side;
  const double reach = graph.free_headings(c).reach(heading, side);
  if (reach < 0.0) return false;
  double limit = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first_arc_.get(c); i != kNone; i = arcs_[i].next) {
    const Arc& other = arcs_[i];
    if (turn_between(other.heading, heading, side) <= other.reach) return false;
    const double ahead = turn_between(heading, other.heading, side);
    if (ahead <= reach) limit = std::min(limit, ahead);
  }
  const bool free = arrival.circle == kNone ? context_->is_free(attachments_->start_link(arrival.index).line)
                                            : graph.is_kept(arrival.circle, arrival.index);
  if (!free) return false;
  context_->result.start_connected = true;
  arcs_.push_back({heading, reach, first_arc_.get(c)});
  first_arc_.set(c, static_cast<std::uint32_t>(arcs_.size() - 1));
  walk_links(context_->links_from(c), side, heading,
             [&, from = c](std::uint32_t index, const FeasibleGraph::Link&, double turn) {
               if (turn > reach || turn >= limit) return false;
               push(from, index);
               return true;
             });
  for (std::uint32_t g = attachments_->first_goal_link(c); g != kNone; g = attachments_->goal_link(g).next) {
    SearchAttachments::GoalLink& goal = attachments_->goal_link(g);
    if (turn_between(heading, goal.link.line.start.heading, side) <= reach && attachments_->is_free(goal)) return true;
  }
  return false;
}

}  // namespace arcway::internal
