#include "core/moving/evade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <queue>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/infinity.h"
#include "core/base/shortest_text.h"
#include "core/motion/motion_phases.h"
#include "core/motion/speed_profile.h"
#include "core/moving/blocked_places.h"
#include "core/moving/start_times.h"

namespace arcway {

using namespace internal;

namespace internal {
namespace {

constexpr std::array kSlower{1.0, 0.75, 0.5, 0.25};  // of all speeds
constexpr double kBeforeBlocked = 0.01;              // of the body's length: how far before a blocked place to stop
constexpr double kApart = 0.25;                      // of the body's length: least distance between two stops
constexpr std::size_t kMostStops = 32;

TurnSpeedLaw slower(const TurnSpeedLaw& law, double share) {
  if (const auto* constant = std::get_if<ConstantTurnSpeed>(&law)) return ConstantTurnSpeed{share * constant->speed};
  if (const auto* lateral = std::get_if<LateralAccelerationLimit>(&law))
    return LateralAccelerationLimit{share * share * lateral->lateral_acceleration};
  TurnSpeedTable table = std::get<TurnSpeedTable>(law);
  for (auto& [radius, speed] : table.entries) speed *= share;
  return table;
}

Vehicle slower(const Vehicle& vehicle, double share) {
  VehicleParameters parameters = vehicle.parameters();
  parameters.max_speed *= share;
  if (parameters.max_reverse_speed) *parameters.max_reverse_speed *= share;
  parameters.turn_speed = slower(parameters.turn_speed, share);
  return Vehicle(parameters);
}

// The part of a path between two arc lengths.
std::vector<PathSegment> part_of(std::span<const PathSegment> path, double from, double to) {
  std::vector<PathSegment> part;
  double before = 0.0;
  for (const PathSegment& segment : path) {
    const double low = std::max(0.0, from - before), high = std::min(segment.length, to - before);
    before += segment.length;
    if (!(high > low)) continue;
    PathSegment piece = segment;
    if (low > 0.0) piece.start = segment.at(low);
    piece.length = high - low;
    part.push_back(piece);
  }
  return part;
}

// A motion without a stop.
struct NonstopMotion {
  std::vector<TimedSegment> segments;
  double duration = 0.0;
  TimeSet blocked;  // when it must not begin
};

// The phases of segments driven one after the other.
class Driven {
 public:
  explicit Driven(double from, double acceleration) : from_(from), acceleration_(acceleration) {}

  void add(const TimedSegment& timed, double top_speed) {
    double at = from_, time = duration_;
    for (const Phase& phase : MotionPhases(timed, top_speed, acceleration_)) {
      phases_.push_back({at, time, phase});
      at += phase.length;
      time += phase.time(phase.length);
    }
    from_ += timed.segment.length;
    duration_ += timed.duration;
  }
  void wait(double duration) { duration_ += duration; }

  [[nodiscard]] double place() const { return from_; }
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] std::span<const PlacedPhase> phases() const { return phases_; }

 private:
  double from_, acceleration_, duration_ = 0.0;
  std::vector<PlacedPhase> phases_;
};

class Evader {
 public:
  Evader(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles, double horizon,
         const SpeedZones* zones)
      : given_(trajectory),
        horizon_(horizon),
        zones_(zones),
        path_(path_of(trajectory.segments())),
        blocked_(blocked_places(path_, trajectory.vehicle(), obstacles, horizon)) {}

  Evasion run() {
    for (const double share : kSlower) vehicles_.push_back(slower(given_.vehicle(), share));
    find_stops();
    search();
    if (goal_ == nullptr) return {.reason = reason()};
    Evasion evasion{.found = true};
    append(*goal_, evasion);
    return evasion;
  }

  /// Whether the motion is free as it was given.
  [[nodiscard]] bool is_free_as_given() const {
    Driven driven(0.0, given_.vehicle().max_acceleration());
    for (const TimedSegment& timed : given_.segments()) {
      if (timed.segment.length > 0.0) {
        driven.add(timed, top_speed(timed, given_.vehicle()));
      } else if (may_stay(driven.place(), driven.duration(), driven.duration() + timed.duration)) {
        driven.wait(timed.duration);
      } else {
        return false;
      }
    }
    return driven.duration() <= horizon_ && !blocked_starts(driven.phases(), blocked_).contains(0.0) &&
           may_stay(driven.place(), driven.duration(), horizon_);
  }

 private:
  // An arrival at a stop, from where the vehicle may go on until the stay ends.
  struct Arrival {
    std::size_t stop;
    TimeInterval stay;
    double time;
    const Arrival* before;
    double departure;  // from there
    const NonstopMotion* motion;
  };

  [[nodiscard]] bool may_stay(double place, double begin, double end) const {
    return std::ranges::none_of(blocked_stays(place, blocked_).intervals(),
                                [&](const TimeInterval& i) { return i.begin < end && i.end > begin; });
  }

  void find_stops() {
    const double length = given_.length(), body = given_.vehicle().footprint().length();
    std::vector<double> places;
    double before = 0.0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (i > 0 && path_[i].gear != path_[i - 1].gear) places.push_back(before);
      before += path_[i].length;
    }
    const std::size_t cusps = places.size();
    for (const BlockedPlaces& blocked : blocked_) places.push_back(blocked.first - kBeforeBlocked * body);
    std::sort(places.begin() + static_cast<std::ptrdiff_t>(cusps), places.end());
    stops_ = {0.0};
    for (const double place : places) {
      const bool is_apart =
          std::ranges::all_of(stops_, [&](double stop) { return std::abs(stop - place) >= kApart * body; });
      if (place > 0.0 && place < length - kApart * body && is_apart && stops_.size() < kMostStops)
        stops_.push_back(place);
    }
    stops_.push_back(length);
    std::ranges::sort(stops_);
    for (const double stop : stops_) stays_.push_back(blocked_stays(stop, blocked_).gaps(0.0, horizon_));
  }

  void search() {
    const auto later = [](const Arrival* a, const Arrival* b) { return a->time > b->time; };
    std::priority_queue<const Arrival*, std::vector<const Arrival*>, decltype(later)> open(later);
    std::map<std::pair<std::size_t, double>, double> earliest;  // by stop and the stay's begin
    const auto arrive = [&](Arrival arrival) {
      const auto [known, is_new] = earliest.try_emplace({arrival.stop, arrival.stay.begin}, arrival.time);
      if (!is_new && known->second <= arrival.time) return;
      known->second = arrival.time;
      arrivals_.push_back(std::make_unique<Arrival>(arrival));
      open.push(arrivals_.back().get());
    };
    for (const TimeInterval& stay : stays_.front())
      if (stay.begin == 0.0) arrive({0, stay, 0.0, nullptr, 0.0, nullptr});
    while (!open.empty()) {
      const Arrival* at = open.top();
      open.pop();
      if (earliest.at({at->stop, at->stay.begin}) < at->time) continue;
      if (at->stop + 1 == stops_.size()) {
        if (at->stay.end < horizon_) continue;
        goal_ = at;
        return;
      }
      for (std::size_t to = at->stop + 1; to < stops_.size(); ++to)
        for (std::size_t k = 0; k < kSlower.size(); ++k)
          if (const NonstopMotion* motion = motion_between(at->stop, to, k)) go(*at, to, *motion, arrive);
    }
  }

  template <class Arrive>
  void go(const Arrival& at, std::size_t to, const NonstopMotion& motion, const Arrive& arrive) const {
    const bool is_moving = at.stop == 0 && given_.segments().front().speed_in > 0.0;
    for (const TimeInterval& window : motion.blocked.gaps(at.time, at.stay.end)) {
      const double time = window.begin + motion.duration;
      if (time > horizon_ || (is_moving && window.begin > 0.0)) break;
      for (const TimeInterval& stay : stays_[to])
        if (stay.begin <= time && time <= stay.end) arrive({to, stay, time, &at, window.begin, &motion});
    }
  }

  // Null if the vehicle cannot drive so.
  const NonstopMotion* motion_between(std::size_t from, std::size_t to, std::size_t slower) {
    const auto [known, is_new] = motions_.try_emplace({from, to, slower}, nullptr);
    if (is_new) known->second = make_motion(from, to, slower);
    return known->second.get();
  }

  [[nodiscard]] std::unique_ptr<NonstopMotion> make_motion(std::size_t from, std::size_t to, std::size_t slower) const {
    const Vehicle& vehicle = vehicles_[slower];
    const CappedPath capped = capped_part(from, to, kSlower[slower]);
    const std::vector<PathSegment>& part = capped.segments;
    if (part.empty()) return nullptr;
    const double start = from == 0 ? given_.segments().front().speed_in : 0.0;
    const double end = to + 1 == stops_.size() ? given_.segments().back().speed_out : 0.0;
    const EndSpeeds ends{sign_of(part.front().gear) * start, sign_of(part.back().gear) * end};
    SpeedProfile profile;
    if (capped_travel_time(capped, vehicle, ends, profile) == kInfinity) return nullptr;
    auto motion = std::make_unique<NonstopMotion>();
    Driven driven(stops_[from], vehicle.max_acceleration());
    for (std::size_t i = 0; i < part.size(); ++i) {
      motion->segments.push_back({part[i], profile.speeds[i], profile.speeds[i + 1], profile.durations[i]});
      const double limit = speed_limit(part[i], vehicle);
      driven.add(motion->segments.back(), capped.caps.empty() ? limit : std::min(limit, capped.caps[i]));
    }
    motion->duration = driven.duration();
    motion->blocked = blocked_starts(driven.phases(), blocked_);
    return motion;
  }

  // The path between two stops, and a share of the limits of zones.
  [[nodiscard]] CappedPath capped_part(std::size_t from, std::size_t to, double share) const {
    CappedPath capped{.segments = part_of(path_, stops_[from], stops_[to]), .caps = {}, .first = {}};
    if (zones_ == nullptr) return capped;
    const std::vector<PathSegment> part = std::move(capped.segments);
    cut(part, *zones_, capped);
    for (double& cap : capped.caps) cap *= share;
    return capped;
  }

  void append(const Arrival& arrival, Evasion& evasion) const {
    std::vector<const Arrival*> way;
    for (const Arrival* at = &arrival; at->before != nullptr; at = at->before) way.push_back(at);
    for (auto at = way.rbegin(); at != way.rend(); ++at) {
      const std::vector<TimedSegment>& driven = (*at)->motion->segments;
      const double wait = (*at)->departure - (*at)->before->time;
      if (wait > 0.0) {
        const PathSegment& next = driven.front().segment;
        evasion.segments.push_back({{next.start, 0.0, next.curvature, next.gear}, 0.0, 0.0, wait});
        evasion.waiting += wait;
      }
      evasion.segments.insert(evasion.segments.end(), driven.begin(), driven.end());
    }
    for (const TimedSegment& timed : evasion.segments) evasion.travel_time += timed.duration;
  }

  [[nodiscard]] std::string reason() const {
    const std::string horizon = "the horizon of " + shortest_text(horizon_) + " s";
    if (stays_.front().empty() || stays_.front().front().begin > 0.0)
      return "a moving obstacle touches the body, grown by half of the safety margin, at the start";
    if (stays_.back().empty() || stays_.back().back().end < horizon_)
      return "a moving obstacle is at the goal at " + horizon;
    return "no motion with stops at " + std::to_string(stops_.size() - 1) + " places and with " +
           std::to_string(kSlower.size()) + " speeds is free of moving obstacles until " + horizon +
           "; a later horizon or another path may help";
  }

  const Trajectory& given_;
  double horizon_;
  const SpeedZones* zones_;
  Path path_;
  std::vector<BlockedPlaces> blocked_;
  std::vector<Vehicle> vehicles_;  // by kSlower
  std::vector<double> stops_;
  std::vector<std::vector<TimeInterval>> stays_;  // by stop: when the vehicle may stand there
  std::map<std::array<std::size_t, 3>, std::unique_ptr<NonstopMotion>> motions_;
  std::vector<std::unique_ptr<Arrival>> arrivals_;
  const Arrival* goal_ = nullptr;
};

}  // namespace

Evasion evade(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles, const EvasionOptions& options,
              const SpeedZones* zones) {
  check_moving(obstacles);
  check_horizon(options.horizon);
  Evader evader(trajectory, obstacles, options.horizon, zones);
  if (evader.is_free_as_given())
    return {.found = true,
            .segments = {trajectory.segments().begin(), trajectory.segments().end()},
            .travel_time = trajectory.duration()};
  return evader.run();
}

}  // namespace internal

Evasion evade(const Trajectory& trajectory, std::span<const MovingObstacle> obstacles, const EvasionOptions& options) {
  return internal::evade(trajectory, obstacles, options, nullptr);
}

}  // namespace arcway
