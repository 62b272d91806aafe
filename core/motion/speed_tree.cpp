#include "core/motion/speed_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/infinity.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

constexpr int kSamples = 5;              // number of speeds at which two joints are compared
constexpr int kHalvings = 8;             // number of halvings of a range between them where samples do not decide
constexpr double kTimeRounding = 1e-12;  // share of a time that rounding may change

}  // namespace

void SpeedTree::reset(double acceleration, TimeModel time_model, double start_speed, double goal_speed) {
  acceleration_ = acceleration;
  time_model_ = time_model;
  start_speed_ = start_speed;
  goal_speed_ = goal_speed;
  top_limit_ = start_speed;
  joints_.assign(1, Joint{});
  joints_[0].speed = start_speed;
}

SpeedTree::Joint SpeedTree::extend(const Joint& from, double length, double limit, double next_limit) const {
  Joint joint{kNoJoint, length, limit, 0.0, 0.0};
  if (from.speed > limit && from.before == kNoJoint) {  // a start that is too fast
    joint.time = kInfinity;
    return joint;
  }
  if (time_model_ == TimeModel::kSegments) {
    joint.speed = std::min(limit, next_limit);
    joint.time = from.time + relaxed_segment_time(length, from.speed, limit, joint.speed, acceleration_);
    return joint;
  }
  const double change = 2.0 * acceleration_ * length;
  joint.speed = std::min({limit, next_limit, std::sqrt(from.speed * from.speed + change)});
  if (!(length > 0.0)) {
    joint.time = joint.speed < from.speed ? time_at(from, joint.speed) : from.time;
  } else if (from.speed == limit && joint.speed == limit) {
    joint.time = from.time + length / limit;
  } else if (const double entry = std::sqrt(joint.speed * joint.speed + change); entry < from.speed) {
    joint.time = time_at(from, entry) + 2.0 * length / (entry + joint.speed);
  } else {
    joint.time = from.time + segment_time(length, from.speed, limit, joint.speed, acceleration_);
  }
  return joint;
}

SpeedTree::Joint SpeedTree::extend(std::uint32_t from, double length, double limit, double next_limit) const {
  Joint joint = extend(joints_[from], length, limit, next_limit);
  joint.before = from;
  return joint;
}

std::uint32_t SpeedTree::add(std::uint32_t from, double length, double limit, double next_limit) {
  top_limit_ = std::max(top_limit_, limit);
  joints_.push_back(extend(from, length, limit, next_limit));
  return static_cast<std::uint32_t>(joints_.size() - 1);
}

std::uint32_t SpeedTree::add_stop(std::uint32_t from, double wait) {
  const double time = time_at(joints_[from], 0.0) + wait;
  joints_.push_back({kNoJoint, 0.0, 0.0, 0.0, time});
  return static_cast<std::uint32_t>(joints_.size() - 1);
}

SpeedTree::Passing SpeedTree::pass(const Joint& joint, double speed) const {
  if (time_model_ == TimeModel::kSegments) return {joint.time, joint.speed};
  if (joint.time == kInfinity) return {kInfinity, joint.speed};
  const double exit = speed;
  const double a = acceleration_;
  double braking = 0.0;
  const Joint* at = &joint;
  while (at->before != kNoJoint) {
    const Joint& before = joints_[at->before];
    const double length = at->length;
    if (length > 0.0) {
      const double entry = std::sqrt(speed * speed + 2.0 * a * length);
      if (entry >= before.speed) {
        const double peak = std::sqrt(0.5 * (2.0 * a * length + before.speed * before.speed + speed * speed));
        return {before.time + segment_time(length, before.speed, at->limit, speed, a) + braking,
                std::min(peak, at->limit)};
      }
      braking += 2.0 * length / (entry + speed);
      speed = entry;
    } else if (speed >= before.speed) {
      return {before.time + braking, before.speed};
    }
    at = &before;
  }
  const double gained = (speed - exit) * (speed + exit);
  const bool is_too_slow = at->speed * at->speed > speed * speed + kTolerance * gained;
  return {is_too_slow ? kInfinity : at->time + braking, at->speed};
}

double SpeedTree::lowest(const Joint& joint) const {
  if (start_speed_ == 0.0) return 0.0;
  const double enough = 0.5 * start_speed_ * start_speed_ / acceleration_;  // length to brake on
  double length = 0.0;
  const Joint* at = &joint;
  for (; at->before != kNoJoint; at = &joints_[at->before]) {
    length += at->length;
    if (length >= enough) return 0.0;
  }
  return std::sqrt(std::max(0.0, at->speed * at->speed - 2.0 * acceleration_ * length));
}

bool SpeedTree::dominates(const Joint& a, const Joint& b, double slack) const {
  if (time_model_ == TimeModel::kSegments) return a.time - slack <= b.time;
  // A path that arrives slower than the goal's speed may not get that fast where the other one does.
  if (a.speed < b.speed && a.speed < goal_speed_) return false;
  const double slowest = lowest(b);
  // A path that arrives slower by d makes up for it by accelerating, and loses d / a_max at most.
  const auto upper = [&](double speed) {
    return (speed > a.speed ? a.time + (speed - a.speed) / acceleration_ : time_at(a, speed)) - slack -
           kTimeRounding * b.time;
  };
  const double at_top = upper(b.speed);
  if (at_top > b.time) return false;
  if (upper(slowest) <= b.time) return true;

  // T is convex: chords of a lie above it, tangents of b below it. Braking begins at no more than the top speed. T
  // falls at most by what this rises by, and by just as much where a path was at the top speed.
  const double top = std::max({top_limit_, a.limit, b.limit});
  const auto gain = [&](double speed) { return (1.0 - 0.5 * speed / top) * speed / acceleration_; };
  struct Sample {
    double speed, above, below, slope;
  };
  const auto sample = [&](double speed) {
    const Passing passing = pass(b, speed);
    const double slope = passing.peak > 0.0 ? -(1.0 - speed / passing.peak) / acceleration_ : 0.0;
    return Sample{speed, upper(speed), passing.time, std::min(slope, 0.0)};
  };
  const auto is_above = [&](auto&& self, const Sample& low, const Sample& high, int halvings) -> bool {
    if (high.above > high.below) return false;
    if (high.above + gain(high.speed) <= low.below + gain(low.speed)) return true;
    if (!(high.slope > low.slope)) return true;
    const double width = high.speed - low.speed;
    const double crossing = std::clamp((low.below - high.below + high.slope * width) / (high.slope - low.slope), 0.0,
                                       width);  // of the two tangents
    if (low.above + (high.above - low.above) * crossing / width <= low.below + low.slope * crossing) return true;
    if (halvings == 0) return false;
    const Sample middle = sample(0.5 * (low.speed + high.speed));
    return self(self, low, middle, halvings - 1) && self(self, middle, high, halvings - 1);
  };
  Sample low = sample(slowest);
  if (low.above > low.below || low.below == kInfinity) return false;
  for (int i = 1; i < kSamples; ++i) {
    const Sample high = sample(slowest + (b.speed - slowest) * i / (kSamples - 1));
    if (!is_above(is_above, low, high, kHalvings)) return false;
    low = high;
  }
  return true;
}

}  // namespace arcway::internal
