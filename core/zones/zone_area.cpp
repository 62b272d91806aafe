#include "core/zones/zone_area.h"

#include <array>
#include <cmath>

#include "arcway/zone.h"

namespace arcway::internal {

namespace {

// Any limit tells the area from the rest.
constexpr double kAnyLimit = 1.0;

Box box_of(const Ring& ring) {
  Box box;
  for (const Vec2& p : ring) box.extend(p);
  return box;
}

}  // namespace

ZoneArea::ZoneArea(const Polygon& area)
    : box_(box_of(area.outer)), zone_(std::array{Zone{area, SpeedLimit{kAnyLimit}}}) {}

double ZoneArea::depth_of(const Vec2& point) const { return zone_.disc_around(point).radius; }

void ZoneArea::find_stays(const PathSegment& segment, std::vector<Stay>& stays) const {
  stays.clear();
  const Vec2 start = segment.start.position();
  if (!Box{start, start}.grown(segment.length).overlaps(box_)) return;
  std::vector<SpeedZones::Stretch> stretches;
  zone_.cut(segment, stretches);
  double along = 0.0;
  for (const SpeedZones::Stretch& stretch : stretches) {
    if (std::isfinite(stretch.cap)) stays.push_back({along, along + stretch.length});
    along += stretch.length;
  }
}

}  // namespace arcway::internal
