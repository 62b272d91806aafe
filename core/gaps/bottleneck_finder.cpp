#include "core/gaps/bottleneck_finder.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "arcway/sweep_query.h"
#include "core/geometry/distance.h"
#include "core/model/side_radii.h"

namespace arcway::internal {

std::string region_text(const World& world, ObstacleId region) {
  if (region == world.obstacle_count()) return "the bounds";
  const std::uint32_t zone = world.keep_out_of(region);
  return zone == kNone ? "obstacle " + std::to_string(region) : zone_text(world.zones()[zone], zone);
}

namespace {

// A rectangle whose middle is that of the largest disc in the body.
Footprint around_largest_disc(const Vehicle& vehicle) {
  const BodyShape* shape = vehicle.shape();
  if (shape == nullptr) return vehicle.footprint();
  Footprint best{};
  double most = -1.0;
  for (std::size_t part = 0; part < shape->parts().size(); ++part) {
    const Ring& ring = shape->parts()[part];
    const Vec2& center = shape->inner_points()[part];
    double radius = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i)
      radius = std::min(radius, distance(center, LineSegment{ring[i], ring[(i + 1) % ring.size()]}));
    if (radius <= most) continue;
    most = radius;
    best = {radius + center.x(), radius - center.x(), radius + center.y(), radius - center.y()};
  }
  return best;
}

}  // namespace

BottleneckFinder::BottleneckFinder(const World& world, const Vehicle& vehicle)
    : BottleneckFinder(world, vehicle, std::make_shared<const VehicleGaps>(world, vehicle, SideRadii(vehicle))) {}

BottleneckFinder::BottleneckFinder(const World& world, const Vehicle& vehicle, std::shared_ptr<const VehicleGaps> gaps)
    : world_(world), body_(around_largest_disc(vehicle)), gaps_(std::move(gaps)) {
  vehicle_takes_.needed = widest_hopeless_gap(vehicle);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SweptAnnulus swept =
        vehicle.swept_annulus(side, vehicle.min_turning_radius(side), 0.5 * vehicle.safety_margin());
    vehicle_takes_.needed_to_turn = std::max(vehicle_takes_.needed_to_turn, swept.width());
  }
}

std::optional<Bottleneck> BottleneckFinder::operator()(const Pose& from, const Pose& to, const StopClock& clock) const {
  std::optional<Gap> gap;
  try {
    if (const GapMap* gaps = gaps_->map(clock))
      gap = gaps->bottleneck(middle_of(body_, from), middle_of(body_, to), clock);
  } catch (const Canceled&) {
    return std::nullopt;
  }
  if (!gap || gap->width > std::max(vehicle_takes_.needed, vehicle_takes_.needed_to_turn)) return std::nullopt;
  Bottleneck bottleneck = vehicle_takes_;
  bottleneck.width = gap->width;
  bottleneck.obstacle_a = world_.obstacle_of(gap->edge_a);
  bottleneck.obstacle_b = world_.obstacle_of(gap->edge_b);
  bottleneck.on_a = gap->on_a;
  bottleneck.on_b = gap->on_b;
  return bottleneck;
}

}  // namespace arcway::internal
