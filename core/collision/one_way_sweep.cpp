#include "core/collision/one_way_sweep.h"

#include "core/collision/turning_headings.h"

namespace arcway::internal {

Gear OneWaySweep::driven(Gear gear) const { return gear == forwards_ ? Gear::kForward : Gear::kReverse; }

void OneWaySweep::do_straights_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  base_->straight_free(bodies, free);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (free[i] != 0 && !zones_->allows_line(bodies[i].from, bodies[i].length, driven(bodies[i].gear))) free[i] = 0;
}

void OneWaySweep::do_straight_free(std::span<const SweptRectangle> rectangles, std::span<std::uint8_t> free) const {
  base_->straight_free(rectangles, free);
}

void OneWaySweep::do_straight_free(std::span<const StraightBody> bodies, std::span<std::uint8_t> free) const {
  do_straights_free(bodies, free);
}

void OneWaySweep::do_free_headings(std::span<const TurningBody> bodies, std::span<HeadingSet> result) const {
  base_->free_headings(bodies, result);
  std::vector<HeadingInterval> forbidden;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const TurningBody& body = bodies[i];
    if (result[i].empty()) continue;
    forbidden.clear();
    zones_->append_forbidden({body.center, body.radius, body.side, driven(body.gear)}, forbidden);
    remove_headings(forbidden, result[i]);
  }
}

// What is near no zone has the bits of the wrapped query, whichever way it is asked.
bool OneWaySweep::do_arc_free(const TurningBody& body, double heading, double angle, HeadingSet& headings) const {
  if (!zones_->are_near(body.center, body.radius)) return base_->arc_free(body, heading, angle, headings);
  free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, body.side) >= angle;
}

double OneWaySweep::do_reach(const TurningBody& body, double heading, Side towards, HeadingSet& headings) const {
  if (!zones_->are_near(body.center, body.radius)) return base_->reach(body, heading, towards, headings);
  free_headings({&body, 1}, {&headings, 1});
  return headings.reach(heading, towards);
}

std::shared_ptr<const SweepQuery> obeying(const std::shared_ptr<const SweepQuery>& sweep,
                                          const std::shared_ptr<const OneWayZones>& zones, Gear forwards) {
  return zones ? std::make_shared<const OneWaySweep>(sweep, zones, forwards) : sweep;
}

}  // namespace arcway::internal
