#include "core/search/arrival_path.h"

#include <array>
#include <utility>

#include "core/base/hash_of.h"
#include "core/roadmap/feasible_graph.h"
#include "core/roadmap/turn_circle.h"

namespace arcway::internal {

namespace {

void append_arc(Path& path, const TurnCircle& circle, double from_heading, double turn) {
  if (turn > 0.0) path.push_back(arc_on(circle, from_heading, turn));
}

void append_line(Path& path, const Pose& start, double length) {
  if (length > 0.0) path.push_back({start, length, 0.0});
}

}  // namespace

std::uint32_t turn_on(const Roadmap& map, std::uint32_t circle) {
  const TurnCircle& c = map.graph->circles()[circle];
  return Way::turn_around(map.world.obstacle_of(c.vertex), c.side == Side::kLeft);
}

void ArrivalPath::write(std::uint32_t last, const AttachmentLink& goal, Path path, SearchResult& result) {
  chain_.clear();
  for (std::uint32_t at = last; at != kNone; at = labels_[at].parent) chain_.push_back(at);
  append_start(path);
  append_graph(goal, path);
  append_goal(goal, path);
  result.first_circle = labels_[chain_.back()].circle;
  result.last_circle = labels_[last].circle;
  result.way = way();
  result.path = std::move(path);
}

Way ArrivalPath::way() const {
  Way way{.number = 1};  // 0 is no way
  std::uint32_t last = kNone;
  for (std::size_t i = chain_.size(); i-- > 0;) {
    const std::uint32_t turn = turn_on(context_.map, labels_[chain_[i]].circle);
    if (std::exchange(last, turn) == turn) continue;
    way.number = hash_of(std::array{way.number, std::uint64_t{turn}});
    if (way.count < way.turns.size()) way.turns[way.count++] = turn;
  }
  return way;
}

void ArrivalPath::append_start(Path& path) const {
  const AttachmentLink& start = attachments_.start_link(labels_[chain_.back()].index);
  const AttachmentCircle& from = attachments_.start_circles()[start.attachment_circle];
  path = context_.starts[from.attachment].connection;
  append_arc(path, from.circle, from.heading, start.turn);
  append_line(path, start.line.start, start.line.length);
}

void ArrivalPath::append_graph(const AttachmentLink& goal, Path& path) const {
  for (std::size_t i = chain_.size(); i-- > 0;) {
    const ArrivalLabel& label = labels_[chain_[i]];
    const TurnCircle& circle = context_.graph.circles()[label.circle];
    const bool at_end = i == 0;
    const FeasibleGraph::Link* link =
        at_end ? nullptr : &context_.graph.links_from(label.circle)[labels_[chain_[i - 1]].index];
    const double heading = at_end ? goal.line.start.heading : link->heading;
    append_arc(path, circle, label.heading, turn_between(label.heading, heading, circle.side));
    append_line(path, pose_on(circle, heading), at_end ? goal.line.length : link->length);
  }
}

void ArrivalPath::append_goal(const AttachmentLink& goal, Path& path) const {
  const AttachmentCircle& to = attachments_.goal_circles()[goal.attachment_circle];
  append_arc(path, to.circle, goal.line.start.heading, goal.turn);
  const Path& connection = context_.goals[to.attachment].connection;
  path.insert(path.end(), connection.begin(), connection.end());
}

}  // namespace arcway::internal
