#include "core/refine/timed_chain.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/infinity.h"

namespace arcway::internal {

namespace {

constexpr std::uint32_t kRoot = 0;

}  // namespace

ChainChange replaced(const CircleChain& chain, std::size_t first, std::size_t last,
                     std::initializer_list<TurnCircle> by) {
  ChainChange change{first, last, by.size(), {}, chain.lead_in, chain.lead_out};
  std::copy(by.begin(), by.end(), change.circles.begin());
  return change;
}

bool TimedChain::begin(const CircleChain& chain, const Vehicle& vehicle, const EndSpeeds& ends, const SpeedZones* zones,
                       const ClearanceCost* clearance) {
  zones_ = zones;
  clearance_ = clearance;
  vehicle_ = &vehicle;
  ends_ = ends;
  if (!make(chain)) return false;
  take();
  return true;
}

bool TimedChain::complete(State& state) const {
  if (!lines_of(state.chain, state.lines)) return false;
  path_of(state.chain, state.lines, state.path);
  state.clearance_cost = clearance_cost(clearance_, state.path);
  return travel_time(state.path, *vehicle_, ends_, state.profile, zones_) < kInfinity;
}

double TimedChain::turn_on(std::size_t circle) const {
  const auto& lines = now_.lines;
  return turn_between(lines[circle].start.heading, lines[circle + 1].start.heading, now_.chain.circles[circle].side);
}

bool TimedChain::make(const ChainChange& change) {
  const auto& circles = now_.chain.circles;
  const auto at = [&circles](std::size_t i) { return circles.begin() + static_cast<std::ptrdiff_t>(i); };
  CircleChain& made = made_.chain;
  made.start = now_.chain.start;
  made.goal = now_.chain.goal;
  made.lead_in = change.lead_in;
  made.lead_out = change.lead_out;
  made.circles.assign(circles.begin(), at(change.first));
  made.circles.insert(made.circles.end(), change.circles.begin(),
                      change.circles.begin() + static_cast<std::ptrdiff_t>(change.count));
  made.circles.insert(made.circles.end(), at(change.last), circles.end());
  return complete(made_);
}

bool TimedChain::make(const CircleChain& chain) {
  made_.chain = chain;
  return complete(made_);
}

void TimedChain::take() {
  std::swap(now_, made_);
  time_parts();
}

void TimedChain::time_parts() {
  stretches_.clear();
  for (std::size_t i = 0; i < now_.lines.size(); ++i) {
    stretches_.push_back({now_.lines[i].length, vehicle_->max_speed()});
    if (i == now_.chain.circles.size()) break;
    const double radius = now_.chain.circles[i].radius;
    stretches_.push_back({turn_on(i) * radius, vehicle_->turn_speed(radius)});
  }

  passings_.clear();
  Passing at{0.0, ends_.start, 0.0};
  std::size_t segment = 0;
  for (Stretch& stretch : stretches_) {
    passings_.push_back(at);
    if (!(stretch.length > 0.0)) continue;
    if (clearance_ != nullptr) {
      stretch.clearance_cost = clearance_->of(now_.path[segment]);
      at.clearance_cost += stretch.clearance_cost;
    }
    at.time += now_.profile.durations[segment++];
    at.speed = now_.profile.speeds[segment];
  }
  passings_.push_back(at);

  cut_stretches();
  from_start_.reset(vehicle_->max_acceleration(), TimeModel::kProfile, ends_.start);
  from_goal_.reset(vehicle_->max_acceleration(), TimeModel::kProfile, ends_.goal);
  start_joints_.resize(stretches_.size());
  goal_joints_.resize(stretches_.size());
  for (const bool forwards : {true, false}) {
    SpeedTree& tree = forwards ? from_start_ : from_goal_;
    std::uint32_t joint = kRoot;
    const Piece* before = nullptr;  // not added yet
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const std::size_t k = forwards ? i : stretches_.size() - 1 - i;
      const std::size_t first = first_piece_[k], last = first_piece_[k + 1];
      std::uint32_t& begin = (forwards ? start_joints_ : goal_joints_)[k];
      begin = joint;
      for (std::size_t p = first; p < last; ++p) {
        const Piece& piece = pieces_[forwards ? p : first + last - 1 - p];
        if (before != nullptr) joint = tree.add(joint, before->length, before->limit, piece.limit);
        if (p == first) begin = joint;
        before = &piece;
      }
    }
  }
}

void TimedChain::cut_stretches() {
  pieces_.clear();
  first_piece_.clear();
  std::size_t segment = 0;
  for (const Stretch& stretch : stretches_) {
    first_piece_.push_back(pieces_.size());
    if (!(stretch.length > 0.0)) continue;
    if (zones_ == nullptr) {
      pieces_.push_back({stretch.length, stretch.limit});
    } else {
      append_pieces(now_.path[segment++], stretch.limit, pieces_);
    }
  }
  first_piece_.push_back(pieces_.size());
}

void TimedChain::append_pieces(const PathSegment& segment, double limit, std::vector<Piece>& pieces) {
  zones_->cut(segment, cut_);
  for (const SpeedZones::Stretch& part : cut_) pieces.push_back({part.length, std::min(limit, part.cap)});
}

PathSegment TimedChain::Part::segment() const {
  if (!is_arc) return {line.start, length, 0.0};
  return {pose_on(circle, line.start.heading), length, sign_of(circle.side) / circle.radius};
}

void TimedChain::add_line(const Bitangent& line) {
  const TurnCircle none{{0.0, 0.0}, 0.0, Side::kLeft, kNone};
  if (line.length > 0.0) laid_out_.push_back({line.length, vehicle_->max_speed(), line, none, false});
}

void TimedChain::add_arc(const TurnCircle& circle, double from, double to) {
  const double length = turn_between(from, to, circle.side) * circle.radius;
  const Pose heading{0.0, 0.0, from};
  if (length > 0.0) laid_out_.push_back({length, vehicle_->turn_speed(circle.radius), {heading, 0.0}, circle, true});
}

bool TimedChain::lay_out(const ChainChange& change) {
  const CircleChain& chain = now_.chain;
  const TurnCircle* at = nullptr;
  double heading = chain.start.heading;
  laid_out_.clear();
  if (change.first == 0) {
    add_line({chain.start, change.lead_in});
  } else {
    at = &chain.circles[change.first - 1];
    heading = now_.lines[change.first - 1].start.heading;
    add_line(now_.lines[change.first - 1]);
  }
  const auto go_to = [&](const TurnCircle& next) {
    if (at != nullptr) {
      const auto line = joint_of(*at, next);
      if (!line) return false;
      add_arc(*at, heading, line->start.heading);
      add_line(*line);
      heading = line->start.heading;
    }
    at = &next;
    return true;
  };
  for (std::size_t i = 0; i < change.count; ++i)
    if (!go_to(change.circles[i])) return false;
  const bool to_goal = change.last == chain.circles.size();
  if (!to_goal && !go_to(chain.circles[change.last])) return false;
  if (at == nullptr) return false;  // no circle would be left
  const Bitangent end = to_goal ? chain.last_line(change.lead_out) : now_.lines[change.last + 1];
  add_arc(*at, heading, end.start.heading);
  add_line(end);
  return true;
}

TimedChain::Affected TimedChain::affected_by(const ChainChange& change) const {
  return {change.first == 0 ? 0 : 2 * (change.first - 1),
          change.last == now_.chain.circles.size() ? stretches_.size() - 1 : 2 * (change.last + 1)};
}

double TimedChain::cost_after(const ChainChange& change, double enough) {
  double cost = time_after(change, enough);
  if (clearance_ == nullptr) return cost;
  const auto [first, last] = affected_by(change);
  for (std::size_t i = 0; i < stretches_.size(); ++i)
    if (i < first || i > last) cost += stretches_[i].clearance_cost;
  for (const Part& part : laid_out_) {
    if (cost >= enough) break;
    cost += clearance_->of(part.segment());
  }
  return cost;
}

double TimedChain::time_after(const ChainChange& change, double enough) {
  const Affected affected = affected_by(change);
  const std::size_t end = stretches_.size() - 1;
  // How fast an outer joint may be passed depends on the line next to it, if there is one.
  if ((affected.first > 0 && !(stretches_[affected.first].length > 0.0)) ||
      (affected.last < end && !(stretches_[affected.last].length > 0.0)))
    return 0.0;
  const double time = time_through(affected, laid_out_);
  if (zones_ == nullptr || time >= enough) return time;
  changed_.clear();
  for (const Part& part : laid_out_) append_pieces(part.segment(), part.limit, changed_);
  return time_through(affected, changed_);
}

template <class Pieces>
double TimedChain::time_through(const Affected& affected, const Pieces& pieces) {
  const std::size_t size = from_start_.size();
  std::uint32_t joint = start_joints_[affected.first];
  for (std::size_t i = 0; i < pieces.size(); ++i)
    joint = from_start_.add(joint, pieces[i].length, pieces[i].limit, pieces[std::min(i + 1, pieces.size() - 1)].limit);
  const SpeedTree::Joint& here = from_start_[joint];
  const SpeedTree::Joint& there = from_goal_[goal_joints_[affected.last]];
  const double speed = std::min(here.speed, there.speed);
  const double time = from_start_.time_at(here, speed) + from_goal_.time_at(there, speed);
  from_start_.truncate(size);
  return time;
}

}  // namespace arcway::internal
