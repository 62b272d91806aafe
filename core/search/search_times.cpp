#include "core/search/search_times.h"

#include "core/base/infinity.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

// Share by which a path may be too slow for its goal by rounding.
constexpr double kGoalRounding = 1e-12;

}  // namespace

void SearchTimes::begin(const SearchContext& context, bool warm_start) {
  context_ = &context;
  line_speed_ = context.vehicle.max_speed();
  if (!warm_start) {
    const SearchOptions& options = context.options;
    speeds_.reset(context.vehicle.max_acceleration(), options.time_model, options.ends.start, options.ends.goal);
  }
}

std::uint32_t SearchTimes::add_connection(const AttachmentCircle& from) {
  const Path& connection = context_->starts[from.attachment].connection;
  std::uint32_t joint = 0;
  const Stretch circle{0.0, context_->vehicle.turn_speed(from.circle.radius), Gear::kForward};
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
  return speeds_.extend(departure, drive.line, line_speed_, vehicle.turn_speed(drive.next_radius));
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
  const double goal_speed = context_->options.ends.goal;
  joint = add_stretch(joint, stretch, {0.0, goal_speed, stretch.gear});
  const bool is_fast_enough = speeds_[joint].speed >= goal_speed * (1.0 - kGoalRounding);
  const double time = is_fast_enough ? speeds_[joint].time : kInfinity;
  speeds_.truncate(size);
  return time;
}

SearchTimes::Stretch SearchTimes::stretch_of(const PathSegment& segment) const {
  return {segment.length, speed_limit(segment, context_->vehicle), segment.gear};
}

// Two joints where the gear changes.
std::uint32_t SearchTimes::add_stretch(std::uint32_t joint, const Stretch& stretch, const Stretch& next) {
  if (stretch.gear == next.gear) return speeds_.add(joint, stretch.length, stretch.limit, next.limit);
  return speeds_.add_stop(speeds_.add(joint, stretch.length, stretch.limit, 0.0), context_->options.cusp_cost);
}

}  // namespace arcway::internal
