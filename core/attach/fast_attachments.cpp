#include "core/attach/fast_attachments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "arcway/angle.h"
#include "core/base/infinity.h"
#include "core/collision/motion_free.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

namespace {

constexpr double kRoundedUp = 1.0 + 1e-12;  // factor by which a radius grows until rounding leaves it fast enough
// Number of places on each way to brake: more of them serve tighter places, and cost a search more circles.
constexpr std::size_t kSteps = 4;

// The smallest radius that a law gives a speed, up to rounding.
struct TightestTurn {
  double speed;
  double operator()(const ConstantTurnSpeed& law) const { return speed <= law.speed ? 0.0 : kInfinity; }
  double operator()(const LateralAccelerationLimit& law) const { return speed * speed / law.lateral_acceleration; }
  double operator()(const TurnSpeedTable& law) const {
    const auto fast = std::ranges::find_if(law.entries, [this](const auto& entry) { return entry.second >= speed; });
    if (fast == law.entries.end()) return kInfinity;
    if (fast == law.entries.begin()) return 0.0;
    const auto slow = fast - 1;
    return slow->first + (fast->first - slow->first) * (speed - slow->second) / (fast->second - slow->second);
  }
};

// The motion along a line or an arc that begins or, backwards from a goal, ends at a pose.
PathSegment motion_at(const Pose& pose, Direction direction, double length, double curvature) {
  if (direction == Direction::kFromStart) return {pose, length, curvature};
  return PathSegment{pose, length, curvature, Gear::kReverse}.reversed();
}

// The curvature of a turn to a side that is as tight as a speed allows; straight on without a side.
double curvature_at(const MovingEnd& end, double speed, std::optional<Side> side) {
  if (!side) return 0.0;
  return sign_of(*side) / std::max(tightest_turn(end.vehicle, speed), end.map.radii[0].of(*side));
}

// Adds the places along one way to brake, down to a speed.
void add_along(const MovingEnd& end, double slow, std::optional<Side> side, std::vector<Attachment>& attachments) {
  const bool from_start = end.direction == Direction::kFromStart;
  const double fastest = end.speed * end.speed, change = (fastest - slow * slow) / kSteps;
  const double length = 0.5 * change / end.vehicle.max_acceleration();
  const auto speed_after = [&](std::size_t steps) { return std::sqrt(fastest - static_cast<double>(steps) * change); };
  double turned = 0.0;
  Attachment at{end.pose, {}};
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double curvature = curvature_at(end, speed_after(i), side);
    turned += length * std::abs(curvature);
    if (turned > kPi) return;
    const PathSegment motion = motion_at(at.pose, end.direction, length, curvature);
    if (!motion_free(*end.map.queries.sweep, end.map.body, std::span(&motion, 1))) return;
    at.pose = from_start ? motion.end() : motion.start;
    at.connection.insert(from_start ? at.connection.end() : at.connection.begin(), motion);
    at.tightest = i + 1 < kSteps ? tightest_turn(end.vehicle, speed_after(i + 1)) : 0.0;
    attachments.push_back(at);
  }
}

}  // namespace

double tightest_turn(const Vehicle& vehicle, double speed) {
  double radius = std::visit(TightestTurn{speed}, vehicle.parameters().turn_speed);
  if (!(radius > 0.0) || radius == kInfinity) return radius;
  while (vehicle.turn_speed(radius) < speed) radius *= kRoundedUp;
  return radius;
}

std::vector<Attachment> fast_attachments(const MovingEnd& end) {
  const double smallest = end.map.radii[0].smaller();
  const double tightest = tightest_turn(end.vehicle, end.speed), slow = end.vehicle.turn_speed(smallest);
  if (!(tightest > smallest && slow < end.speed)) return {};
  std::vector<Attachment> attachments{{end.pose, {}, std::nullopt, tightest}};
  add_along(end, slow, std::nullopt, attachments);
  if (tightest < kInfinity)
    for (const Side side : {Side::kLeft, Side::kRight}) add_along(end, slow, side, attachments);
  return attachments;
}

std::optional<Attachment> way_to_stop(const MovingEnd& end) {
  if (end.speed == 0.0) return Attachment{end.pose, {}};
  const bool turns = tightest_turn(end.vehicle, end.speed) < kInfinity;
  for (const std::optional<Side> side : {std::optional<Side>{}, {Side::kLeft}, {Side::kRight}}) {
    if (side && !turns) break;
    std::vector<Attachment> attachments;
    add_along(end, 0.0, side, attachments);
    if (attachments.size() == kSteps) return std::move(attachments.back());
  }
  return std::nullopt;
}

}  // namespace arcway::internal
