#include "core/moving/start_times.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcway::internal {

double PlacedPhase::time_at(double s) const { return time + phase.time(std::clamp(s - from, 0.0, phase.length)); }

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

constexpr TimeInterval kNever{INFINITY, -INFINITY};

void extend(TimeInterval& interval, double time) {
  interval.begin = std::min(interval.begin, time);
  interval.end = std::max(interval.end, time);
}

// Adds the start times of a motion that is on a segment of the plane of places and times, within one phase.
void add_starts(const PlacedPhase& placed, const Vec2& a, const Vec2& b, TimeInterval& starts) {
  const double low = std::max(placed.from, std::min(a.x(), b.x()));
  const double high = std::min(placed.to(), std::max(a.x(), b.x()));
  if (low > high) return;
  const auto add = [&](double s, double t) { extend(starts, t - placed.time_at(s)); };
  if (a.x() == b.x()) {
    for (const Vec2& p : {a, b}) add(p.x(), p.y());
    return;
  }
  const double slowness = (b.y() - a.y()) / (b.x() - a.x());
  const auto add_at = [&](double s) { add(s, a.y() + (s - a.x()) * slowness); };
  add_at(low);
  add_at(high);
  // The place where the speed is that of the side.
  const Phase& phase = placed.phase;
  const double speed = 1.0 / slowness, acceleration = phase.acceleration();
  if (!(slowness > 0.0) || acceleration == 0.0) return;
  const double s = placed.from + 0.5 * (speed - phase.speed_in) * (speed + phase.speed_in) / acceleration;
  if (s > low && s < high) add_at(s);
}

}  // namespace

TimeSet blocked_starts(std::span<const PlacedPhase> motion, std::span<const BlockedPlaces> blocked) {
  if (motion.empty()) return {};
  const PlacedPhase &first = motion.front(), &last = motion.back();
  std::vector<TimeInterval> found;
  for (const BlockedPlaces& places : blocked) {
    if (places.last < first.from || places.first > last.to()) continue;
    TimeInterval starts = kNever;
    for (std::size_t i = 0; i < places.corners.size(); ++i)
      for (const PlacedPhase& placed : motion)
        add_starts(placed, places.corners[i], places.corners[(i + 1) % places.corners.size()], starts);
    // The sides where the motion begins and ends are cut out of the polygon.
    for (const auto& [s, time] : {std::pair(first.from, 0.0), std::pair(last.to(), last.time_at(last.to()))}) {
      const TimeSet stays = blocked_stays(s, {&places, 1});
      for (const TimeInterval& stay : stays.intervals())
        for (const double t : {stay.begin, stay.end}) extend(starts, t - time);
    }
    if (starts.begin <= starts.end) found.push_back(starts);
  }
  return TimeSet(std::move(found));
}

TimeSet blocked_stays(double place, std::span<const BlockedPlaces> blocked) {
  std::vector<TimeInterval> found;
  for (const BlockedPlaces& places : blocked) {
    if (place < places.first || place > places.last) continue;
    TimeInterval stay = kNever;
    for (std::size_t i = 0; i < places.corners.size(); ++i) {
      const Vec2 &a = places.corners[i], &b = places.corners[(i + 1) % places.corners.size()];
      if (a.x() == place) extend(stay, a.y());
      if ((a.x() < place) != (b.x() < place)) extend(stay, std::lerp(a.y(), b.y(), (place - a.x()) / (b.x() - a.x())));
    }
    if (stay.begin <= stay.end) found.push_back(stay);
  }
  return TimeSet(std::move(found));
}

}  // namespace arcway::internal
