#include "core/reversing/gear_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arcway/angle.h"
#include "core/motion/speed_profile.h"
#include "core/reversing/gear_index.h"

namespace arcway::internal {

namespace {

constexpr double kStepTurn = kPi / 8.0;              // turn of motions of a fixed length [rad]
constexpr double kFarContactTurn = 3.0 * kStepTurn;  // largest turn of motions up to contact [rad]
constexpr double kSmallestTurn = 1e-3;               // smallest turn worth a motion [rad]
constexpr double kContactSlack = 1e-6;  // turn by which motions end before a contact [rad]: more than rounding
// Spreads the number of gear changes over the bits of a cell's key: an odd number, 2^64 over the golden ratio.
constexpr std::uint64_t kLayer = 0x9E3779B97F4A7C15u;

std::size_t index_of(double curvature) { return curvature == 0.0 ? 0 : curvature > 0.0 ? 1 : 2; }

}  // namespace

GearTree::GearTree(const Pose& root, const Vehicle& vehicle, const Outlines& outlines, const GearTreeOptions& options,
                   std::function<double(const Pose&)> remaining)
    : vehicle_(vehicle),
      options_(options),
      remaining_(std::move(remaining)),
      radii_(vehicle),
      radius_(radii_.smaller()),
      contact_(outlines, vehicle.body(0.5 * vehicle.safety_margin()), options.one_way_zones, options.forwards) {
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
      continue;  // its cell has a cheaper pose by now
    contact_.begin(node.pose, radii_.larger() * kFarContactTurn);
    for (const double curvature : {0.0, 1.0 / radii_.left, -1.0 / radii_.right})
      for (const Gear gear : {Gear::kForward, Gear::kReverse})
        rooms_[index_of(curvature)][gear_index(gear)] = contact_(curvature, gear);
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      add_line(at, gear);
      for (const Side side : {Side::kLeft, Side::kRight}) add_arcs(at, side, gear);
    }
    return at;
  }
  return std::nullopt;
}

double GearTree::room(double curvature, Gear gear) const {
  const bool is_known = curvature == 0.0 || std::abs(curvature) == 1.0 / radii_.on(curvature);
  return is_known ? rooms_[index_of(curvature)][gear_index(gear)] : contact_(curvature, gear);
}

bool GearTree::has_room(const PathSegment& motion) const {
  return room(motion.curvature, motion.gear) >= std::min(motion.length, radii_.larger() * kFarContactTurn);
}

void GearTree::add_line(std::uint32_t from, Gear gear) {
  const Pose pose = nodes_[from].pose;
  const double step = radius_ * kStepTurn;
  const double length = room(0.0, gear) - radius_ * kContactSlack;
  if (length < radius_ * kSmallestTurn) return;
  add(from, {pose, std::min(length, step), 0.0, gear});
  if (length > step) add(from, {pose, length, 0.0, gear});
  if (options_.halves && length < step) add(from, {pose, 0.5 * length, 0.0, gear});
}

void GearTree::add_arcs(std::uint32_t from, Side side, Gear gear) {
  const Pose pose = nodes_[from].pose;
  const double radius = radii_.of(side), curvature = sign_of(side) / radius;
  const double far = room(curvature, gear) / radius;
  const double turn = far - kContactSlack;
  const auto add_arc = [&](double by) {
    if (by >= kSmallestTurn) add(from, {pose, radius * by, curvature, gear});
  };
  add_arc(std::min(turn, kStepTurn));
  if (turn < kStepTurn) {
    if (options_.halves) add_arc(0.5 * turn);
  } else if (far < kFarContactTurn) {
    add_arc(turn);
  }
}

void GearTree::add(std::uint32_t from, const PathSegment& motion) {
  const Node& parent = nodes_[from];
  const Pose end = motion.end();
  const bool cusp = from != kRoot && parent.motion.gear != motion.gear;
  const std::uint32_t cusps = parent.cusps + (cusp ? 1 : 0);
  if (cusps > options_.max_cusps) return;
  const double limit = speed_limit(motion, vehicle_);
  const std::size_t size = speeds_.size();
  const std::uint32_t turned =
      cusp ? speeds_.add_stop(parent.joint, options_.cusp_cost) : speeds_.add(parent.joint, 0.0, limit, limit);
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
  const Vec2 d = (pose.position() - nodes_[kRoot].pose.position()) * (options_.cells / radius_);
  const auto index = [](double value) { return static_cast<std::uint64_t>(std::llround(value)) & 0xFFFFFFu; };
  const auto heading = static_cast<std::uint64_t>(wrap_positive(pose.heading) * options_.cells);
  const std::uint64_t layer = options_.max_cusps == std::numeric_limits<std::size_t>::max() ? 0 : cusps * kLayer;
  const std::uint64_t place = (index(d.x()) << 40) | (index(d.y()) << 16);
  return layer ^ (place | ((heading & 0x7FFFu) << 1) | (gear == Gear::kForward ? 1u : 0u));
}

}  // namespace arcway::internal
