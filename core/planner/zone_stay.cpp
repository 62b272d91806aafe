#include "arcway/zone_stay.h"

#include <algorithm>
#include <vector>

#include "core/zones/zone_area.h"

namespace arcway {

using namespace internal;

namespace {

// What a motion drives inside an area.
ZoneStay stay_in(const ZoneArea& area, const Trajectory& motion) {
  ZoneStay sum{0, 0.0, 0.0};
  double driven = 0.0;
  const auto time_at = [&](double distance) { return motion.at_distance(std::min(distance, motion.length())).time; };
  std::vector<ZoneArea::Stay> stays;
  for (const TimedSegment& timed : motion.segments()) {
    area.find_stays(timed.segment, stays);
    for (const ZoneArea::Stay& stay : stays) {
      sum.length += stay.to - stay.from;
      sum.time += time_at(driven + stay.to) - time_at(driven + stay.from);
    }
    driven += timed.segment.length;
  }
  return sum;
}

}  // namespace

std::vector<ZoneStay> zone_stays(const PlanResult& plan) {
  std::vector<ZoneStay> stays;
  if (!plan.solved() || plan.segments.empty() || !plan.scene || plan.scene->world.zones().empty()) return stays;
  const Trajectory motion = plan.trajectory();
  const std::span<const Zone> zones = plan.scene->world.zones();
  for (std::uint32_t i = 0; i < zones.size(); ++i) {
    ZoneStay stay = stay_in(ZoneArea(zones[i].area), motion);
    stay.zone = i;
    if (stay.length > 0.0) stays.push_back(stay);
  }
  return stays;
}

}  // namespace arcway
