#include "core/search/search_times.h"

#include <algorithm>
#include <cmath>

#include "core/attach/close_turns.h"
#include "core/base/infinity.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

// Share by which a path may be too slow for its goal by rounding.
constexpr double kGoalRounding = 1e-12;

}  // namespace

void SearchTimes::begin(const SearchContext& context, bool warm_start) {
  context_ = &context;
  zones_ = context.map.speed_zones.get();
  clearance_ = context.map.clearance_cost.get();
  line_speed_ = context.vehicle.max_speed();
  if (!warm_start) {
    const SearchOptions& options = context.options;
    speeds_.reset(context.vehicle.max_acceleration(), options.time_model, options.ends.start, options.ends.goal);
    clearance_costs_.assign(clearance_ == nullptr ? 0 : speeds_.size(), 0.0);
  }
}

void SearchTimes::truncate(std::size_t size) {
  speeds_.truncate(size);
  if (clearance_ != nullptr) clearance_costs_.resize(size);
}

std::uint32_t SearchTimes::add_stop(std::uint32_t joint) {
  const double cost = clearance_cost(joint);
  joint = speeds_.add_stop(joint, context_->options.cusp_cost);
  if (clearance_ != nullptr) clearance_costs_.resize(speeds_.size(), cost);
  return joint;
}

std::uint32_t SearchTimes::add_connection(const AttachmentCircle& from) {
  const Path& connection = context_->starts[from.attachment].connection;
  std::uint32_t joint = 0;
  const Stretch circle{0.0, context_->vehicle.turn_speed(from.circle.radius), Gear::kForward};
  if (depends_on_places()) {
    joint = add_path(joint, connection, circle.limit, CloseCost::kCounts);
    const bool stops = !connection.empty() && connection.back().gear != circle.gear;
    return stops ? add_stop(joint) : joint;
  }
  for (std::size_t i = 0; i < connection.size(); ++i)
    joint = add_stretch(joint, stretch_of(connection[i]),
                        i + 1 < connection.size() ? stretch_of(connection[i + 1]) : circle);
  return joint;
}

std::uint32_t SearchTimes::add_drive(const Drive& drive) {
  const Vehicle& vehicle = context_->vehicle;
  const std::uint32_t departure = speeds_.add(drive.joint, drive.arc, vehicle.turn_speed(drive.radius), line_speed_);
  return speeds_.add(departure, drive.line, line_speed_, vehicle.turn_speed(drive.next_radius));
}

SpeedTree::Joint SearchTimes::drive(const Drive& drive) const {
  const Vehicle& vehicle = context_->vehicle;
  const auto departure = speeds_.extend(drive.joint, drive.arc, vehicle.turn_speed(drive.radius), line_speed_);
  SpeedTree::Joint arrival = speeds_.extend(departure, drive.line, line_speed_, vehicle.turn_speed(drive.next_radius));
  arrival.time += clearance_cost(drive.joint);
  return arrival;
}

double SearchTimes::time_to_goal(std::uint32_t joint, double arc, double radius, const AttachmentLink& link,
                                 const AttachmentCircle& to) {
  const std::size_t size = speeds_.size();
  joint = add_drive({joint, arc, radius, link.line.length, to.circle.radius});
  Stretch stretch{link.turn * to.circle.radius, context_->vehicle.turn_speed(to.circle.radius), Gear::kForward};
  for (const PathSegment& segment : context_->goals[to.attachment].connection) {
    const Stretch next = stretch_of(segment);
    joint = add_stretch(joint, stretch, next);
    stretch = next;
  }
  return cost_at_goal(add_stretch(joint, stretch, {0.0, context_->options.ends.goal, stretch.gear}), size);
}

double SearchTimes::time_to_goal(std::uint32_t joint, std::uint32_t circle, const PathSegment& arc,
                                 const LinkToGoal& goal) {
  const std::size_t size = speeds_.size();
  const AttachmentLink& link = goal.link;
  const AttachmentCircle& to = goal.to;
  joint = add_turn(joint, circle, arc, context_->vehicle.max_speed());
  last_.assign({{link.line.start, link.line.length, 0.0}});
  const double radius = to.circle.radius;
  last_.push_back({pose_on(to.circle, link.line.start.heading), link.turn * radius, sign_of(to.circle.side) / radius});
  const Path& connection = context_->goals[to.attachment].connection;
  last_.insert(last_.end(), connection.begin(), connection.end());
  if (goal.close_cost < 0.0) goal.close_cost = arcway::internal::clearance_cost(clearance_, last_);
  return cost_at_goal(add_path(joint, last_, context_->options.ends.goal, CloseCost::kIsKnown), size) + goal.close_cost;
}

// The time and cost at the last joint, if it is fast enough. Forgets the joints from `size` on.
double SearchTimes::cost_at_goal(std::uint32_t joint, std::size_t size) {
  const double goal_speed = context_->options.ends.goal;
  const bool is_fast_enough = speeds_[joint].speed >= goal_speed * (1.0 - kGoalRounding);
  const double cost = is_fast_enough ? speeds_[joint].time + clearance_cost(joint) : kInfinity;
  truncate(size);
  return cost;
}

SearchTimes::Stretch SearchTimes::stretch_of(const PathSegment& segment) const {
  return {segment.length, speed_limit(segment, context_->vehicle), segment.gear};
}

std::uint32_t SearchTimes::add_segment(std::uint32_t joint, const PathSegment& segment, double next_limit) {
  return add_parts(joint, segment, next_limit, clearance_ == nullptr ? 0.0 : clearance_->of(segment));
}

std::uint32_t SearchTimes::add_turn(std::uint32_t joint, std::uint32_t circle, const PathSegment& arc,
                                    double next_limit) {
  return add_parts(joint, arc, next_limit, turn_cost(circle, arc.start.heading, arc.length * std::abs(arc.curvature)));
}

double SearchTimes::turn_cost(std::uint32_t circle, double heading, double turn) const {
  const CloseTurns* turns = context_->map.close_turns.get();
  return turns == nullptr ? 0.0 : turns->cost_of(circle, heading, turn);
}

std::vector<ClearanceCost::CloseHeadings> SearchTimes::close_headings(const TurnCircle& circle) const {
  if (clearance_ == nullptr) return {};
  return clearance_->close_headings(circle.center, circle.radius, circle.side);
}

// The parts of a segment between borders of zones, and its clearance cost behind the last one.
std::uint32_t SearchTimes::add_parts(std::uint32_t joint, const PathSegment& segment, double next_limit, double cost) {
  const double own = speed_limit(segment, context_->vehicle), cost_before = clearance_cost(joint);
  if (zones_ != nullptr) {
    zones_->cut(segment, parts_);
  } else {
    parts_.assign({{segment.length, kInfinity}});
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double limit = std::min(own, parts_[i].cap);
    if (speeds_[joint].speed > limit) joint = speeds_.add(joint, 0.0, limit, limit);
    joint = speeds_.add(joint, parts_[i].length, limit,
                        i + 1 < parts_.size() ? std::min(own, parts_[i + 1].cap) : next_limit);
  }
  if (clearance_ != nullptr) clearance_costs_.resize(speeds_.size(), cost_before + cost);
  return joint;
}

// Segments one after the other, with stops where the gear changes.
std::uint32_t SearchTimes::add_path(std::uint32_t joint, std::span<const PathSegment> path, double next_limit,
                                    CloseCost cost) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool is_last = i + 1 == path.size(), stops = !is_last && path[i + 1].gear != path[i].gear;
    const double limit = stops ? 0.0 : is_last ? next_limit : speed_limit(path[i + 1], context_->vehicle);
    joint = cost == CloseCost::kCounts ? add_segment(joint, path[i], limit) : add_parts(joint, path[i], limit, 0.0);
    if (stops) joint = add_stop(joint);
  }
  return joint;
}

// Two joints where the gear changes.
std::uint32_t SearchTimes::add_stretch(std::uint32_t joint, const Stretch& stretch, const Stretch& next) {
  if (stretch.gear == next.gear) return speeds_.add(joint, stretch.length, stretch.limit, next.limit);
  return speeds_.add_stop(speeds_.add(joint, stretch.length, stretch.limit, 0.0), context_->options.cusp_cost);
}

}  // namespace arcway::internal
