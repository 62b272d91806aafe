#include "core/reversing/narrow_gear_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "arcway/angle.h"
#include "core/base/hash_of.h"
#include "core/model/body_size.h"
#include "core/motion/speed_profile.h"
#include "core/reversing/gear_index.h"

namespace arcway::internal {

namespace {

// Curvatures of motions, as multiples of the largest one. The curvatures of words come first: right, straight, left. Of
// 23 driven worlds with 2 mm of room that need this tree it solves 20. With the curvatures of words and half of them
// alone it solves 16.
constexpr std::array kBends{-1.0, 0.0, 1.0, -0.7, 0.7, -0.4, 0.4, -0.2, 0.2, -0.08, 0.08};
constexpr double kFarLine = 1.0;  // longest line, in lengths of the body or turning radii, whichever is larger
constexpr double kFarWide = 2.0;  // longest arc, in the same unit
constexpr double kFarTurn = 3.0 * kPi / 8.0;  // largest turn of an arc [rad]
constexpr double kStep = 1.0 / 3.0;           // share of the longest motion at which free ones end as well
constexpr double kHalf = 0.5;                 // share of the length up to contact at which motions end as well
constexpr double kLeast = 1e-3;               // shortest motion, in lengths of the body
constexpr double kSlack =
    1e-6;  // length by which motions end before a contact, in lengths of the body: more than rounding
constexpr double kLargestCell =
    0.125;  // edge of the largest cell, in lengths of the body or turning radii, whichever is larger
constexpr double kLargestTurn = 0.25;  // heading range of the largest cell [rad]
constexpr double kShare = 0.25;        // size of a cell, as a share of what one move to and fro can do
// Cost of an expansion in a coarse cell, in times to cross it. With 0.5 a tree stays long where the estimate of the
// rest of the route misleads it: in 54 driven worlds that need this tree it takes 1.6 times as long.
constexpr double kVisit = 20.0;

// The largest power of two times `largest` that is no larger than `wanted`, at most `largest`.
double quantized(double largest, double wanted) {
  return wanted >= largest ? largest : std::exp2(std::floor(std::log2(wanted / largest))) * largest;
}

}  // namespace

NarrowGearTree::NarrowGearTree(const Roadmap& map, const Vehicle& vehicle, const Pose& root,
                               const NarrowGearTreeOptions& options, std::function<double(const Pose&)> remaining)
    : vehicle_(vehicle),
      options_(options),
      remaining_(std::move(remaining)),
      radii_(vehicle),
      size_(std::max(radii_.smaller(), body_length(vehicle))),
      far_line_(kFarLine * size_),
      largest_{kLargestCell * size_, kLargestCell * size_, kLargestTurn},
      contact_(*map.outlines, map.body, map.one_way_zones.get(), options.forwards),
      open_(kVisit * kLargestCell * size_ / vehicle.top_speed()) {
  nodes_.push_back({root, {root, 0.0, 0.0}, kRoot, 0, 0.0});
  open_.push(remaining_(root), kRoot);
}

std::optional<std::uint32_t> NarrowGearTree::expand() {
  const std::optional<std::uint32_t> next =
      open_.pop([this](std::uint32_t node) { return key_of(nodes_[node].pose, largest_); });
  if (!next) return std::nullopt;
  const Pose pose = nodes_[*next].pose;
  contact_.begin(pose, kFarWide * size_);
  const double slack = kSlack * body_length(vehicle_);
  std::array<std::array<double, 2>, kBends.size()> reach{};
  double way = 0.0, turn = 0.0;
  for (std::size_t i = 0; i < kBends.size(); ++i) {
    const double curvature = kBends[i] / radii_.on(kBends[i]);
    const double most = longest(curvature);
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      const double room = contact_(curvature, gear);
      if (i < rooms_.size()) rooms_[i][gear_index(gear)] = room;
      reach[i][gear_index(gear)] = std::min(most, room - slack);
    }
    const double to_and_fro = reach[i][0] + reach[i][1];
    way = std::max(way, to_and_fro);
    turn = std::max(turn, to_and_fro * std::abs(curvature));
  }
  const Cell cell = cell_where(way, turn);
  for (std::size_t i = 0; i < kBends.size(); ++i) {
    const double curvature = kBends[i] / radii_.on(kBends[i]);
    const double step = kStep * longest(curvature);
    for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
      const double room = reach[i][gear_index(gear)];
      const double first = room > step ? step : kHalf * room;
      for (const double length : {first, room})
        if (length >= kLeast * body_length(vehicle_)) add(*next, cell, {pose, length, curvature, gear});
    }
  }
  return next;
}

double NarrowGearTree::longest(double curvature) const {
  return curvature == 0.0 ? far_line_ : std::min(kFarWide * size_, kFarTurn / std::abs(curvature));
}

bool NarrowGearTree::has_room(const PathSegment& motion) const {
  const double needed = std::min(motion.length, far_line_);
  const bool is_known = motion.curvature == 0.0 || std::abs(motion.curvature) == 1.0 / radii_.on(motion.curvature);
  if (!is_known) return contact_(motion.curvature, motion.gear) >= needed;
  const std::size_t bend = motion.curvature == 0.0 ? 1 : motion.curvature < 0.0 ? 0 : 2;
  return rooms_[bend][gear_index(motion.gear)] >= needed;
}

void NarrowGearTree::add(std::uint32_t from, const Cell& cell, const PathSegment& motion) {
  const Node& parent = nodes_[from];
  const bool cusp = from != kRoot && parent.motion.gear != motion.gear;
  const std::uint32_t cusps = parent.cusps + (cusp ? 1 : 0);
  if (cusps > options_.max_cusps) return;
  const Pose end = motion.end();
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  const std::array<std::uint64_t, 2> key{key_of(end, cell), motion.gear == Gear::kForward ? 1u : 2u};
  if (!cells_.insert(hash_of(key)).second) return;
  const double cost = parent.cost + motion.length / speed_limit(motion, vehicle_) + (cusp ? options_.gear_change : 0.0);
  nodes_.push_back({end, motion, from, cusps, cost});
  open_.push(cost + remaining_(end), node);
}

// The size of cells by the longest motion and the largest turn to and fro.
NarrowGearTree::Cell NarrowGearTree::cell_where(double way, double turn) const {
  const double share = kShare * options_.fineness;
  const double q = std::max(way, kLeast * body_length(vehicle_)), t = std::clamp(turn, kLeast, 1.0);
  return {quantized(largest_.along, share * q), quantized(largest_.aside, share * q * t),
          quantized(largest_.turn, share * t)};
}

std::uint64_t NarrowGearTree::key_of(const Pose& pose, const Cell& cell) const {
  const Pose& root = nodes_[kRoot].pose;
  const double turned = std::round(wrap_positive(pose.heading - root.heading) / cell.turn);
  const Vec2 ahead = direction_of(root.heading + turned * cell.turn), d = pose.position() - root.position();
  const auto index = [](double value) { return static_cast<std::uint64_t>(std::llround(value)); };
  const std::array<std::uint64_t, 5> parts{
      index(turned), index(ahead.dot(d) / cell.along), index(cross(ahead, d) / cell.aside),
      index(std::log2(largest_.aside / cell.aside)), index(std::log2(largest_.turn / cell.turn))};
  return hash_of(parts);
}

}  // namespace arcway::internal
