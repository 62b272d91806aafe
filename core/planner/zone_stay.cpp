#include "arcway/zone_stay.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/zones/speed_zones.h"

namespace arcway {

using namespace internal;

namespace {

// What a motion drives inside an area.
ZoneStay stay_in(const Polygon& area, const Trajectory& motion) {
  const Zone inside{area, SpeedLimit{1.0}};
  const SpeedZones cuts({&inside, 1});
  ZoneStay stay{0, 0.0, 0.0};
  double driven = 0.0;
  std::vector<SpeedZones::Stretch> stretches;
  for (const TimedSegment& timed : motion.segments()) {
    cuts.cut(timed.segment, stretches);
    for (const SpeedZones::Stretch& stretch : stretches) {
      const double from = std::min(driven, motion.length()), to = std::min(driven + stretch.length, motion.length());
      driven += stretch.length;
      if (std::isinf(stretch.cap)) continue;
      stay.length += stretch.length;
      stay.time += motion.at_distance(to).time - motion.at_distance(from).time;
    }
  }
  return stay;
}

}  // namespace

std::vector<ZoneStay> zone_stays(const PlanResult& plan) {
  std::vector<ZoneStay> stays;
  if (!plan.solved() || plan.segments.empty() || !plan.scene || plan.scene->world.zones().empty()) return stays;
  const Trajectory motion = plan.trajectory();
  const std::span<const Zone> zones = plan.scene->world.zones();
  for (std::uint32_t i = 0; i < zones.size(); ++i) {
    ZoneStay stay = stay_in(zones[i].area, motion);
    stay.zone = i;
    if (stay.length > 0.0) stays.push_back(stay);
  }
  return stays;
}

}  // namespace arcway
