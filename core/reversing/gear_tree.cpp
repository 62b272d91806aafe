#include "core/reversing/gear_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/angle.h"
#include "core/motion/speed_profile.h"
#include "core/roadmap/turn_circle.h"

namespace arcway {

namespace {

constexpr double kStepTurn = kPi / 8.0;
constexpr double kFarTurns = 3.0;       // motions up to contact are worth a pose within so many steps
constexpr double kLeastTurn = 1e-3;     // shorter motions lead nowhere [rad]
constexpr double kContactSlack = 1e-6;  // how far motions up to a contact stay away from it [rad], for rounding
// Spreads the number of cusps over the bits of a cell's key: an odd number, 2^64 over the golden ratio.
constexpr std::uint64_t kLayer = 0x9E3779B97F4A7C15u;
constexpr int kHalvings = 10;  // when looking for the length of a line up to contact

}  // namespace

GearTree::GearTree(const Pose& root, const Vehicle& vehicle, const SweepQuery& sweep, double cusp_cost,
                   const GearTreeGrid& grid, std::function<double(const Pose&)> remaining)
    : vehicle_(vehicle),
      sweep_(&sweep),
      cusp_cost_(cusp_cost),
      grid_(grid),
      remaining_(std::move(remaining)),
      body_(vehicle.footprint(0.5 * vehicle.safety_margin())),
      radius_(vehicle.min_turning_radius()) {
  speeds_.reset(vehicle.max_acceleration());
  nodes_.push_back({root, {root, 0.0, 0.0}, kRoot, 0, 0, 0.0});
  open_.push({remaining_(root), kRoot});
}

double GearTree::least_estimate() const {
  return open_.empty() ? std::numeric_limits<double>::infinity() : open_.top().first;
}

std::optional<std::uint32_t> GearTree::expand() {
  while (!open_.empty()) {
    const std::uint32_t at = open_.top().second;
    open_.pop();
    const Node& node = nodes_[at];
    if (at != kRoot && cells_.at(cell_of(node.pose, node.motion.gear, node.cusps)) != at)
      continue;  // there is a cheaper one
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) add_lines(at, gear);
    for (const Side side : {Side::kLeft, Side::kRight}) add_arcs(at, side);
    return at;
  }
  return std::nullopt;
}

void GearTree::add_lines(std::uint32_t from, Gear gear) {
  const Pose pose = nodes_[from].pose;
  const double step = radius_ * kStepTurn;
  const double far = kFarTurns * step;
  const double length = free_length(pose, gear, far);
  if (length < radius_ * kLeastTurn) return;
  add(from, {pose, std::min(length, step), 0.0, gear});
  if (length > step) add(from, {pose, length, 0.0, gear});
  if (grid_.halves && length < step) add(from, {pose, 0.5 * length, 0.0, gear});
}

// How far the line is free, at most `most`; short of a contact by some thousandth of that.
double GearTree::free_length(const Pose& from, Gear gear, double most) {
  const auto is_free = [&](double length) {
    ++straights_checked_;
    const PathSegment line{from, length, 0.0, gear};
    return sweep_->straight_free(swept_rectangle(line.forwards().start, length, body_));
  };
  if (is_free(most)) return most;
  double free = 0.0, blocked = most;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (free + blocked);
    (is_free(middle) ? free : blocked) = middle;
  }
  return free;
}

void GearTree::add_arcs(std::uint32_t from, Side side) {
  const Pose pose = nodes_[from].pose;
  ++turns_checked_;
  const HeadingSet free = sweep_->free_headings({turn_circle(pose, radius_, side).center, radius_, side, body_});
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    const double room = free.reach(pose.heading, gear == Gear::kForward ? side : opposite(side)) - kContactSlack;
    const auto add_arc = [&](double turn) {
      if (turn >= kLeastTurn) add(from, {pose, radius_ * turn, sign_of(side) / radius_, gear});
    };
    add_arc(std::min(room, kStepTurn));
    if (room < kStepTurn) {
      if (grid_.halves) add_arc(0.5 * room);
    } else if (room <= kFarTurns * kStepTurn) {
      add_arc(room);
    }
  }
}

void GearTree::add(std::uint32_t from, const PathSegment& motion) {
  const Node& parent = nodes_[from];
  const Pose end = motion.end();
  const bool cusp = from != kRoot && parent.motion.gear != motion.gear;
  const std::uint32_t cusps = parent.cusps + (cusp ? 1 : 0);
  if (cusps > grid_.max_cusps) return;
  const double limit = speed_limit(motion, vehicle_);
  const std::size_t size = speeds_.size();
  const std::uint32_t turned =
      cusp ? speeds_.add_stop(parent.joint, cusp_cost_) : speeds_.add(parent.joint, 0.0, limit, limit);
  const std::uint32_t joint = speeds_.add(turned, motion.length, limit, limit);
  const double cost = speeds_[joint].time;
  const auto [cell, added] =
      cells_.try_emplace(cell_of(end, motion.gear, cusps), static_cast<std::uint32_t>(nodes_.size()));
  if (!added) {
    if (nodes_[cell->second].cost <= cost) {
      speeds_.truncate(size);
      return;
    }
    cell->second = static_cast<std::uint32_t>(nodes_.size());
  }
  nodes_.push_back({end, motion, from, joint, cusps, cost});
  open_.push({cost + remaining_(end), static_cast<std::uint32_t>(nodes_.size() - 1)});
}

std::uint64_t GearTree::cell_of(const Pose& pose, Gear gear, std::uint32_t cusps) const {
  const Vec2 d = (pose.position() - nodes_[kRoot].pose.position()) * (grid_.cells / radius_);
  const auto index = [](double value) { return static_cast<std::uint64_t>(std::llround(value)) & 0xFFFFFFu; };
  const auto heading = static_cast<std::uint64_t>(wrap_positive(pose.heading) * grid_.cells);
  const std::uint64_t layer = grid_.max_cusps == std::numeric_limits<std::size_t>::max() ? 0 : cusps * kLayer;
  const std::uint64_t place = (index(d.x()) << 40) | (index(d.y()) << 16);
  return layer ^ (place | ((heading & 0x7FFFu) << 1) | (gear == Gear::kForward ? 1u : 0u));
}

}  // namespace arcway
