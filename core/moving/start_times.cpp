#include "core/moving/start_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcway::internal {

double MotionPhase::time_at(double s) const {
  const double share = std::clamp((s - from) / (to - from), 0.0, 1.0);
  const double speed = std::sqrt(std::lerp(speed_in * speed_in, speed_out * speed_out, share));
  const double driven = share * (to - from);
  return driven > 0.0 ? time + 2.0 * driven / (speed_in + speed) : time;
}

TimeSet::TimeSet(std::vector<TimeInterval> intervals) {
  std::ranges::sort(intervals, {}, &TimeInterval::begin);
  for (const TimeInterval& next : intervals) {
    if (!intervals_.empty() && next.begin <= intervals_.back().end) {
      intervals_.back().end = std::max(intervals_.back().end, next.end);
    } else {
      intervals_.push_back(next);
    }
  }
}

bool TimeSet::contains(double time) const {
  return std::ranges::any_of(intervals_, [time](const TimeInterval& i) { return i.begin <= time && time <= i.end; });
}

std::vector<TimeInterval> TimeSet::gaps(double from, double to) const {
  std::vector<TimeInterval> gaps;
  for (const TimeInterval& covered : intervals_) {
    if (covered.end < from) continue;
    if (covered.begin > to) break;
    if (covered.begin > from) gaps.push_back({from, covered.begin});
    from = covered.end;
  }
  if (from < to) gaps.push_back({from, to});
  return gaps;
}

namespace {

// Adds the start times of a motion that is on a segment of the plane of places and times, within one phase.
void add_starts(const MotionPhase& phase, const Vec2& a, const Vec2& b, TimeInterval& starts) {
  const double low = std::max(phase.from, std::min(a.x(), b.x())), high = std::min(phase.to, std::max(a.x(), b.x()));
  if (low > high) return;
  const auto add = [&](double s, double t) {
    starts.begin = std::min(starts.begin, t - phase.time_at(s));
    starts.end = std::max(starts.end, t - phase.time_at(s));
  };
  if (a.x() == b.x()) {
    for (const Vec2& p : {a, b}) add(p.x(), p.y());
    return;
  }
  const double slowness = (b.y() - a.y()) / (b.x() - a.x());
  const auto add_at = [&](double s) { add(s, a.y() + (s - a.x()) * slowness); };
  add_at(low);
  add_at(high);
  // The place where the speed is that of the side.
  const double speed = 1.0 / slowness, acceleration = phase.acceleration();
  if (!(slowness > 0.0) || acceleration == 0.0) return;
  const double s = phase.from + 0.5 * (speed - phase.speed_in) * (speed + phase.speed_in) / acceleration;
  if (s > low && s < high) add_at(s);
}

}  // namespace

TimeSet blocked_starts(std::span<const MotionPhase> motion, std::span<const BlockedPlaces> blocked) {
  std::vector<TimeInterval> found;
  if (motion.empty()) return {};
  for (const BlockedPlaces& places : blocked) {
    if (places.last < motion.front().from || places.first > motion.back().to) continue;
    TimeInterval starts{INFINITY, -INFINITY};
    for (std::size_t i = 0; i < places.corners.size(); ++i)
      for (const MotionPhase& phase : motion)
        add_starts(phase, places.corners[i], places.corners[(i + 1) % places.corners.size()], starts);
    // The sides where the motion begins and ends are cut out of the polygon.
    const MotionPhase& last = motion.back();
    for (const auto& [s, time] : {std::pair(motion.front().from, 0.0), std::pair(last.to, last.time_at(last.to))}) {
      const TimeSet stays = blocked_stays(s, {&places, 1});
      for (const TimeInterval& stay : stays.intervals()) {
        starts.begin = std::min(starts.begin, stay.begin - time);
        starts.end = std::max(starts.end, stay.end - time);
      }
    }
    if (starts.begin <= starts.end) found.push_back(starts);
  }
  return TimeSet(std::move(found));
}

TimeSet blocked_stays(double place, std::span<const BlockedPlaces> blocked) {
  std::vector<TimeInterval> found;
  for (const BlockedPlaces& places : blocked) {
    if (place < places.first || place > places.last) continue;
    TimeInterval stay{INFINITY, -INFINITY};
    for (std::size_t i = 0; i < places.corners.size(); ++i) {
      const Vec2 &a = places.corners[i], &b = places.corners[(i + 1) % places.corners.size()];
      if (place < std::min(a.x(), b.x()) || place > std::max(a.x(), b.x())) continue;
      const double share = a.x() == b.x() ? 0.0 : (place - a.x()) / (b.x() - a.x());
      for (const double t :
           {std::lerp(a.y(), b.y(), share), a.x() == b.x() ? b.y() : a.y() + share * (b.y() - a.y())}) {
        stay.begin = std::min(stay.begin, t);
        stay.end = std::max(stay.end, t);
      }
    }
    if (stay.begin <= stay.end) found.push_back(stay);
  }
  return TimeSet(std::move(found));
}

}  // namespace arcway::internal
