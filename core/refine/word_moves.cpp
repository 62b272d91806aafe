// The moves of Refiner that insert words: two arcs and the line between them.

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/refine/refiner.h"

namespace arcway::internal {

bool Refiner::take(const InsertWords& move) {
  find_stations(move);
  for (std::size_t span = stations_.size() - 1; span > 0 && !is_over(); --span)
    for (std::size_t i = 0; i + span < stations_.size() && !done_by_now(); ++i)
      if (stations_[i].line < stations_[i + span].line && insert_word(stations_[i], stations_[i + span])) return true;
  return false;
}

void Refiner::find_stations(const InsertWords& move) {
  stations_.clear();
  for (std::size_t i = 0; i < lines().size(); ++i) {
    const double length = lines()[i].length;
    const auto first = stations_.size();
    stations_.push_back(station(i, 0.0));
    if (length > smallest_)
      for (int k = 1; k < move.parts; ++k) stations_.push_back(station(i, k / static_cast<double>(move.parts)));
    for (const double radii : move.near_ends) {
      const double part = radii * smallest_ / length;
      if (!(part < move.near)) break;
      stations_.push_back(station(i, part));
      stations_.push_back(station(i, 1.0 - part));
    }
    if (length > 0.0) stations_.push_back(station(i, 1.0));
    std::sort(stations_.begin() + static_cast<std::ptrdiff_t>(first), stations_.end(),
              [](const Station& a, const Station& b) { return a.part < b.part; });
  }
}

Station Refiner::station(std::size_t line, double part) const {
  const double twice = 2.0 * vehicle_.max_acceleration();
  const Bitangent& l = lines()[line];
  const auto begin = chain_.begin_of(line), end = chain_.end_of(line);
  const Vec2 ahead = direction_of(l.start.heading);
  const Vec2 p = l.start.position() + part * l.length * ahead;
  const double speed = std::min({vehicle_.max_speed(), std::sqrt(begin.speed * begin.speed + twice * part * l.length),
                                 std::sqrt(end.speed * end.speed + twice * (1.0 - part) * l.length)});
  return {
      line, part, {p.x(), p.y(), l.start.heading}, perpendicular(ahead), begin.time + part * (end.time - begin.time),
      speed};
}

double Refiner::time_between(double length, double v1, double v3) const {
  const double a = vehicle_.max_acceleration();
  if (std::abs(v1 * v1 - v3 * v3) >= 2.0 * a * length) return v1 + v3 > 0.0 ? 2.0 * length / (v1 + v3) : 0.0;
  return segment_time(length, v1, vehicle_.max_speed(), v3, a);
}

std::pair<double, double> Refiner::turns_of(double r0, double turn0, double r1, double turn1) const {
  if (r0 == r1) {
    const double length = (turn0 + turn1) * r0;
    return {length, length / vehicle_.turn_speed(r0)};
  }
  return {turn0 * r0 + turn1 * r1, turn0 * r0 / vehicle_.turn_speed(r0) + turn1 * r1 / vehicle_.turn_speed(r1)};
}

bool Refiner::insert_word(const Station& from, const Station& to) {
  const double saved = chain_.end_of(to.line).clearance_cost - chain_.begin_of(from.line).clearance_cost;  // at most
  const double budget = to.time - from.time + saved;
  // Most pairs are told from the distance alone.
  const double distance = (to.pose.position() - from.pose.position()).norm();
  const double least = std::max(distance / vehicle_.max_speed(), time_between(distance, from.speed, to.speed));
  if (least > budget * (1.0 + kTimeSlack)) return false;
  const double longest = budget * (1.0 + kTimeSlack) * vehicle_.max_speed();  // line of a word
  for (const double radius : radii_)
    for (const Side departure : {Side::kLeft, Side::kRight})
      for (const Side arrival : {Side::kLeft, Side::kRight}) {
        const double r0 = std::max(radius, smallest_on(departure)), r1 = std::max(radius, smallest_on(arrival));
        const TurnCircle first{from.pose.position() + sign_of(departure) * r0 * from.left, r0, departure, kNone};
        const TurnCircle second{to.pose.position() + sign_of(arrival) * r1 * to.left, r1, arrival, kNone};
        const double offset = departure == arrival ? 0.0 : r0 + r1;
        const double square = (second.center - first.center).squaredNorm() - offset * offset;
        if (square > longest * longest) continue;
        const auto line = directed_bitangent(first, second);
        if (!line) continue;
        const double turn0 = turn_between(from.pose.heading, line->start.heading, departure);
        const double turn1 = turn_between(line->start.heading, to.pose.heading, arrival);
        const auto [turns, time] = turns_of(r0, turn0, r1, turn1);
        const double fastest = line->length / vehicle_.max_speed() + time;
        const double straight = time_between(line->length + turns, from.speed, to.speed);
        if (std::max(fastest, straight) >= budget) continue;
        ChainChange change = replaced(chain_.chain(), from.line, to.line, {first, second});
        if (from.line == 0) change.lead_in *= from.part;
        if (to.line + 1 == lines().size()) change.lead_out *= 1.0 - to.part;
        if (accept(change)) return true;
      }
  return false;
}

}  // namespace arcway::internal
