#include "core/tasks/path_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/base/stopwatch.h"
#include "core/motion/end_speeds.h"
#include "core/tasks/motion_parts.h"

namespace arcway::internal {
namespace {

// How far from the cut a plan leaves the motion and comes back to it, in terms of the length in which the vehicle stops
// and turns around. Short plans are found soonest; the next ones have more room.
constexpr std::array kRooms{1.0, 3.0, 9.0};
// Steps of bisection to find how far a blocked segment is free.
constexpr int kCutSteps = 5;
// Places tried on each segment to find the nearest one.
constexpr int kPlacesASegment = 8;
// Difference of two poses by rounding [m, rad].
constexpr double kSamePose = 1e-9;

double room_of(const Vehicle& vehicle) {
  const double speed = vehicle.max_speed();
  return 0.5 * speed * speed / vehicle.max_acceleration() + 2.0 * vehicle.min_turning_radius() +
         vehicle.footprint().length();
}

PathSegment part_of(const PathSegment& segment, double begin, double length) {
  return {segment.at(begin), length, segment.curvature, segment.gear};
}

}  // namespace

bool are_same_pose(const Pose& a, const Pose& b) {
  return (a.position() - b.position()).norm() <= kSamePose &&
         std::abs(std::remainder(a.heading - b.heading, kTwoPi)) <= kSamePose;
}

PathRepair::PathRepair(const ReplanQueries& queries, const Trajectory& motion, const TrajectoryState& now, bool reverse)
    : queries_(queries),
      motion_(motion),
      now_(now),
      reverse_(reverse),
      begins_here_(are_same_pose(motion.segments().front().segment.start, now.pose) &&
                   motion.segments().front().speed_in == now.speed) {}

std::optional<std::vector<TimedSegment>> PathRepair::find(const PlanLimits& limits) const {
  const Stopwatch watch;
  const Cut cut = find_cut();
  const double room = room_of(queries_.vehicle), length = motion_.length();
  for (std::size_t i = 0; i < kRooms.size(); ++i) {
    const double leaves = begins_here_ ? std::max(0.0, cut.begin - kRooms[i] * room) : 0.0;
    const double rejoins = std::min(length, cut.end + kRooms[i] * room);
    PlanLimits left = limits;
    left.time = (limits.time - watch.seconds()) / static_cast<double>(kRooms.size() - i);
    if (!(left.time > 0.0) || left.stop.stop_requested()) break;
    if (auto mended = joined(leaves, rejoins, left)) return mended;
    if (leaves == 0.0 && rejoins == length) break;
  }
  return std::nullopt;
}

PathRepair::Cut PathRepair::find_cut() const {
  Cut cut{kInfinity, 0.0};
  double begin = 0.0;
  for (const TimedSegment& timed : motion_.segments()) {
    const PathSegment& segment = timed.segment;
    if (!queries_.is_free({&segment, 1})) {
      if (cut.begin == kInfinity) cut.begin = begin + free_length(segment, false);
      cut.end = begin + segment.length - free_length(segment, true);
    }
    begin += segment.length;
  }
  cut.begin = std::min(cut.begin, cut.end);  // nothing is blocked
  if (!begins_here_) cut.end = std::max(cut.end, nearest());
  return cut;
}

double PathRepair::free_length(const PathSegment& segment, bool at_end) const {
  double free = 0.0, blocked = segment.length;
  for (int i = 0; i < kCutSteps; ++i) {
    const double middle = 0.5 * (free + blocked);
    const PathSegment part = part_of(segment, at_end ? segment.length - middle : 0.0, middle);
    (queries_.is_free({&part, 1}) ? free : blocked) = middle;
  }
  return free;
}

double PathRepair::nearest() const {
  double begin = 0.0, found = 0.0, least = kInfinity;
  for (const TimedSegment& timed : motion_.segments()) {
    const PathSegment& segment = timed.segment;
    for (int i = 0; i <= kPlacesASegment; ++i) {
      const double place = segment.length * i / kPlacesASegment;
      const double distance = (segment.at(place).position() - now_.pose.position()).norm();
      if (distance >= least) continue;
      least = distance;
      found = begin + place;
    }
    begin += segment.length;
  }
  return found;
}

double PathRepair::signed_limited(double speed, Gear gear) const {
  const Vehicle& vehicle = queries_.vehicle;
  return signed_speed(std::min(speed, gear == Gear::kForward ? vehicle.max_speed() : vehicle.max_reverse_speed()),
                      gear);
}

std::optional<std::vector<TimedSegment>> PathRepair::joined(double leaves, double rejoins,
                                                            const PlanLimits& limits) const {
  TrajectoryState from = now_;
  std::vector<TimedSegment> mended;
  if (leaves > 0.0) {
    from = motion_.at_distance(leaves);
    mended = begin_of(motion_, from);
    if (!mended.empty()) from.speed = mended.back().speed_out;
  }
  const TrajectoryState to = motion_.at_distance(rejoins);
  const bool is_end = rejoins == motion_.length();
  const double a = queries_.vehicle.max_acceleration(), distance = (to.pose.position() - from.pose.position()).norm();
  // Half of what the vehicle can gain on the way is left for turns.
  const double speed = is_end ? to.speed : std::min(to.speed, std::sqrt(from.speed * from.speed + a * distance));
  const PlanRequest request{.start = from.pose,
                            .goal = is_end ? motion_.segments().back().segment.end() : to.pose,
                            .reverse = reverse_,
                            .start_speed = signed_limited(from.speed, from.gear),
                            .goal_speed = signed_limited(speed, to.gear)};
  if (!reverse_ && (request.start_speed < 0.0 || request.goal_speed < 0.0)) return std::nullopt;
  const PlanResult plan = queries_.plan(request, limits);
  if (!plan.solved()) return std::nullopt;
  mended.insert(mended.end(), plan.segments.begin(), plan.segments.end());
  if (!is_end) {
    const double end_speed = mended.empty() ? from.speed : mended.back().speed_out;
    const std::vector<TimedSegment> rest = begun_at(end_speed, rest_of(motion_, to), queries_.vehicle);
    mended.insert(mended.end(), rest.begin(), rest.end());
  }
  const bool ends_right = mended.empty() || mended.back().speed_out == motion_.segments().back().speed_out;
  if (!ends_right || !queries_.is_free(path_of(mended))) return std::nullopt;
  return mended;
}

}  // namespace arcway::internal
