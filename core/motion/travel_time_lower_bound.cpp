#include "core/motion/travel_time_lower_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "arcway/angle.h"
#include "core/motion/dubins.h"
#include "core/motion/reeds_shepp.h"
#include "core/motion/speed_profile.h"

namespace arcway::internal {

namespace {

constexpr double kBoundRounding = 1e-12;
// Share that paths between moving ends may be faster, as speed_profile may exceed the acceleration by half of it.
constexpr double kMovingTolerance = 2.0 * kEndTolerance;
// Rounding of the joints of a path in all, as a share of the largest coordinate, and of headings.
constexpr double kJointUlps = 64.0 * std::numeric_limits<double>::epsilon();

double shortest_word(const Pose& start, const Pose& goal, double radius) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const DubinsWord word : kDubinsWords)
    if (const auto path = dubins_word(word, start, goal, radius))
      shortest = std::min(shortest, length_of(path->segments()));
  return shortest;
}

double least_turn(const Pose& start, const Pose& goal, double place_error) {
  const double direct = std::abs(wrap_signed(goal.heading - start.heading));
  const Vec2 d = goal.position() - start.position();
  if (d.isZero(0.0)) return direct;
  const double phi = std::atan2(d.y(), d.x());
  const double by_phi = std::abs(wrap_signed(phi - start.heading)) + std::abs(wrap_signed(goal.heading - phi));
  return std::max(direct, std::min(kPi, by_phi) - 2.0 * place_error / d.norm());
}

double highest_turn_speed(const Vehicle& vehicle) {
  const double top = vehicle.max_speed();
  struct Highest {
    double top;
    double operator()(const ConstantTurnSpeed& law) const { return law.speed; }
    double operator()(const LateralAccelerationLimit&) const { return top; }
    double operator()(const TurnSpeedTable& law) const {
      double highest = 0.0;
      for (const auto& entry : law.entries) highest = std::max(highest, entry.second);
      return highest;
    }
  };
  return std::min(top, std::visit(Highest{top}, vehicle.parameters().turn_speed));
}

// The integral of max(0, 1 / turn_speed - 1 / w) over the first `length` meters from an end at rest.
double time_lost_from_rest(double length, double turn_speed, const Vehicle& vehicle) {
  const double a = vehicle.max_acceleration();
  const double top = vehicle.max_speed();
  const double from =
      0.5 * turn_speed * turn_speed / a;  // where w passes turn_speed, and below where it gets to the top
  if (length <= from) return 0.0;
  const double until = std::min(length, 0.5 * top * top / a);
  const double rising = (until - from) / turn_speed - (std::sqrt(2.0 * until / a) - turn_speed / a);
  return std::max(0.0, rising) + (length - until) * (1.0 / turn_speed - 1.0 / top);
}

// The least time that arcs of a length cost, wherever they lie.
double time_lost_on_arcs(double arcs, const Vehicle& vehicle, const EndSpeeds& ends) {
  const double twice = 2.0 * vehicle.max_acceleration();
  const double turn_speed = highest_turn_speed(vehicle);
  // An end of speed v is as one at rest that lies v^2 / (2 a_max) further out.
  const double start_out = ends.start * ends.start / twice, goal_out = ends.goal * ends.goal / twice;
  const double at_start = std::clamp(0.5 * (arcs + goal_out - start_out), 0.0, arcs);
  const auto lost = [&](double out, double length) {
    return time_lost_from_rest(out + length, turn_speed, vehicle) - time_lost_from_rest(out, turn_speed, vehicle);
  };
  return lost(start_out, at_start) + lost(goal_out, arcs - at_start);
}

// The ends of paths, and a length that each has at least.
struct Apart {
  Vec2 start, goal;
  double length;
};

// The time of the shortest path if the limits in the discs about its ends are all that slows it down; 0 if neither end
// lies in a zone.
double slow_ends_time(const Apart& apart, const Vehicle& vehicle, const EndSpeeds& ends, const SpeedZones& zones) {
  const Vec2 &start = apart.start, &goal = apart.goal;
  const double length = apart.length;
  const SpeedZones::Disc first = zones.disc_around(start), last = zones.disc_around(goal);
  const double top = vehicle.max_speed(), a = vehicle.max_acceleration();
  if (first.cap >= top && last.cap >= top) return 0.0;
  const double place_error = kJointUlps * std::max(start.cwiseAbs().maxCoeff(), goal.cwiseAbs().maxCoeff());
  const double cap0 = std::min(first.cap, top), cap1 = std::min(last.cap, top);
  const auto within = [&](double radius) { return std::clamp(radius - place_error, 0.0, length); };
  const double until = within(first.radius), from = length - within(last.radius);
  // What both discs have has both limits.
  const double middle = until > from ? std::min(cap0, cap1) : top;
  const std::array lengths{std::min(until, from), std::abs(from - until), length - std::max(until, from)};
  const std::array caps{cap0, middle, cap1};
  std::array speeds{std::min(std::abs(ends.start), cap0), std::min(cap0, middle), std::min(middle, cap1),
                    std::min(std::abs(ends.goal), cap1)};
  for (std::size_t i = 0; i < 3; ++i)
    speeds[i + 1] = std::min(speeds[i + 1], std::sqrt(speeds[i] * speeds[i] + 2.0 * a * lengths[i]));
  for (std::size_t i = 3; i-- > 0;)
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i + 1] * speeds[i + 1] + 2.0 * a * lengths[i]));
  double time = 0.0;
  for (std::size_t i = 0; i < 3; ++i) time += relaxed_segment_time(lengths[i], speeds[i], caps[i], speeds[i + 1], a);
  return time;
}

}  // namespace

// Many parameters because nearly all callers leave out the last three.
double travel_time_lower_bound(const Pose& start, const Pose& goal, double distance, const Vehicle& vehicle,
                               bool reverse, const EndSpeeds& ends, const SpeedZones* zones) {
  if (reverse && vehicle.max_reverse_speed() > vehicle.max_speed())
    return travel_time_lower_bound(start, goal, distance, vehicle.with_gears_swapped(), reverse, ends, zones);
  const double radius = vehicle.min_turning_radius();
  const double heading_error = kJointUlps * (1.0 + std::abs(start.heading) + std::abs(goal.heading));
  const double place_error = radius * heading_error + kJointUlps * std::max(start.position().cwiseAbs().maxCoeff(),
                                                                            goal.position().cwiseAbs().maxCoeff());
  const double turn =
      reverse ? std::abs(wrap_signed(goal.heading - start.heading)) : least_turn(start, goal, place_error);
  // In both gears a place beside a pose is reached by two arcs there and a line back, of four times this in all.
  const double word = reverse ? reeds_shepp_distance(start, goal, radius) - 5.0 * std::sqrt(radius * place_error)
                              : shortest_word(start, goal, radius);
  const double arcs = std::max(0.0, radius * turn - place_error);
  const double v0 = std::abs(ends.start), v1 = std::abs(ends.goal), a = vehicle.max_acceleration();
  const double change = (1.0 - kMovingTolerance) * 0.5 * std::abs(v0 - v1) * (v0 + v1) / a;
  const double length = std::max({0.0, std::max(distance, word) - place_error, arcs, change});
  if (!(length > 0.0) || std::isinf(length)) return length;
  const double straight = relaxed_segment_time(length, v0, vehicle.max_speed(), v1, a);
  const double slow_ends =
      zones != nullptr ? slow_ends_time({start.position(), goal.position(), length}, vehicle, ends, *zones) : 0.0;
  return (1.0 - (ends.is_moving() ? kMovingTolerance : kBoundRounding)) *
         std::max(straight + time_lost_on_arcs(arcs, vehicle, ends), slow_ends);
}

}  // namespace arcway::internal
