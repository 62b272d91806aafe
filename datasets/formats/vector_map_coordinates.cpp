// What the coordinates of a file of polygons mean: what it says, what they look like, and how they are projected.

#include <algorithm>
#include <cmath>
#include <limits>

#include "arcway/angle.h"
#include "core/gaps/bottleneck_finder.h"
#include "core/model/pose_text.h"
#include "datasets/formats/azimuthal_plane.h"
#include "datasets/formats/text_scanner.h"
#include "datasets/formats/vector_map.h"

namespace arcway::internal::detail {
namespace {

std::string lonlat_text(const Vec2& p) { return "(" + shortest_text(p.x()) + ", " + shortest_text(p.y()) + ")"; }

// The middle of longitudes and latitudes. Longitudes are a circle: of the two boxes cut at 180 and at 0 degrees the
// narrower one counts; where both are wider than half a turn, the map lies around a pole.
class GlobeBox {
 public:
  void extend(const Vec2& p) {
    const double longitude = p.x() > 180.0 ? p.x() - 360.0 : p.x() <= -180.0 ? p.x() + 360.0 : p.x();
    west_east_.extend({longitude, p.y()});
    from_zero_.extend({longitude < 0.0 ? longitude + 360.0 : longitude, p.y()});
  }
  [[nodiscard]] bool empty() const { return west_east_.empty(); }
  [[nodiscard]] Vec2 middle() const {
    const Box& box = width(from_zero_) < width(west_east_) ? from_zero_ : west_east_;
    Vec2 middle = 0.5 * (box.min + box.max);
    if (width(box) > 180.0) return {0.0, std::copysign(90.0, middle.y())};
    if (middle.x() > 180.0) middle.x() -= 360.0;
    return middle;
  }

 private:
  static double width(const Box& box) { return box.max.x() - box.min.x(); }
  Box west_east_, from_zero_;
};

}  // namespace

// Calls `visit` with every position of the map.
template <class Visit>
void VectorMapBuilder::visit_positions(Visit visit) {
  const auto polygon = [&](Polygon& p) {
    for (Vec2& position : p.outer) visit(position);
    for (Ring& hole : p.holes)
      for (Vec2& position : hole) visit(position);
  };
  for (Polygon& obstacle : map_.obstacles) polygon(obstacle);
  for (Zone& zone : map_.zones) polygon(zone.area);
  for (FreePolygon& free : free_) polygon(free.polygon);
  for (auto& [positions, place] : lines_)
    for (Vec2& position : positions) visit(position);
  if (map_.bounds)
    for (Vec2& position : *map_.bounds) visit(position);
  for (std::optional<Pose>* pose : {&map_.start, &map_.goal}) {
    if (!*pose) continue;
    Vec2 p = (*pose)->position();
    visit(p);
    (*pose)->x = p.x();
    (*pose)->y = p.y();
  }
}

void VectorMapBuilder::set_system(std::string_view name) {
  system_ = name;
  system_unit_ = coordinate_unit(name);
}

void VectorMapBuilder::settle_coordinates() {
  map_.frame = CoordinateFrame::kMeters;
  if (options_.lonlat) return project();
  if (options_.planar) return;
  Box box;
  visit_positions([&](const Vec2& p) { box.extend(p); });
  if (system_unit_) return warn_of_system(box);
  map_.frame = CoordinateFrame::kUnstated;
  if (looks_like_degrees(box))
    warn("",
         "coordinates look like degrees of longitude and latitude; they are taken as meters. Use --lonlat to "
         "project degrees, or --planar if they are meters");
}

void VectorMapBuilder::warn_of_system(const Box& box) {
  const std::string named = system_.empty() ? "" : " (" + detail::quoted(system_) + ")";
  switch (*system_unit_) {
    case CoordinateUnit::kMeters:
      return;
    case CoordinateUnit::kDegrees:
      map_.frame = CoordinateFrame::kDegrees;
      return warn("", "coordinates are degrees of longitude and latitude" + named +
                          "; they are taken as meters. Use --lonlat to project them");
    case CoordinateUnit::kGrads:
      map_.frame = CoordinateFrame::kDegrees;
      return warn("", "coordinates are longitude and latitude in grads" + named +
                          "; they are taken as meters. Convert the file to a system in meters");
    case CoordinateUnit::kWebMercator:
    case CoordinateUnit::kMercator: {
      const double y = box.empty() ? 0.0 : 0.5 * (box.min.y() + box.max.y());
      const bool web = *system_unit_ == CoordinateUnit::kWebMercator;
      return warn("", "coordinates are " + std::string(web ? "Web Mercator" : "Mercator") + named + ": at latitude " +
                          rounded_text(web_mercator_latitude(y)) + " a meter on the ground is " +
                          rounded_text(mercator_scale(y)) + " units, which are taken as meters. " +
                          (web ? "Use --lonlat to project them to meters on the ground"
                               : "Convert the file to a system in meters on the ground"));
    }
    case CoordinateUnit::kStretched:
      return warn("", "the projection" + named +
                          " does not keep lengths; coordinates are taken as meters on the "
                          "ground. Convert the file to a local system, as UTM");
    case CoordinateUnit::kOtherUnit:
      return warn("", "coordinates are not in meters" + named +
                          "; they are taken as meters. Convert the file to a system in meters");
    case CoordinateUnit::kGeocentric:
      fail("", "coordinates are positions in space" + named +
                   ", along axes through the middle of the globe; no plane shows them. Convert the file to a local "
                   "system, as UTM");
    case CoordinateUnit::kUnknown:
      map_.frame = CoordinateFrame::kUnstated;
      return warn("", "the coordinate system" + named +
                          " is not known here; coordinates are taken as meters. Use --lonlat if they are degrees, "
                          "--planar if they are meters");
  }
}

void VectorMapBuilder::project() {
  const CoordinateUnit unit = system_unit_.value_or(CoordinateUnit::kDegrees);
  if (unit != CoordinateUnit::kDegrees && unit != CoordinateUnit::kWebMercator && unit != CoordinateUnit::kUnknown)
    fail("", "coordinates are planar or in another unit" +
                 (system_.empty() ? "" : " (" + detail::quoted(system_) + ")") +
                 ", not degrees of longitude and latitude; leave out --lonlat");
  GlobeBox box;
  visit_positions([&](Vec2& p) {
    if (unit == CoordinateUnit::kWebMercator) p = {web_mercator_longitude(p.x()), web_mercator_latitude(p.y())};
    if (std::abs(p.y()) > 90.0 && std::abs(p.x()) <= 90.0)
      fail("", lonlat_text(p) + " is no longitude and latitude in degrees; longitude comes first");
    if (std::abs(p.x()) > 360.0 || std::abs(p.y()) > 90.0)
      fail("", lonlat_text(p) + " is no longitude and latitude in degrees");
    box.extend(p);
  });
  if (box.empty()) return;
  const Vec2 middle = box.middle();
  const AzimuthalPlane plane(middle.x(), middle.y());
  double reach = 0.0;
  visit_positions([&](Vec2& p) {
    if (!plane.reaches(p.x(), p.y()))
      fail("", lonlat_text(p) + " lies more than a quarter of the globe from the middle of the map at " +
                   lonlat_text(middle) + "; no plane shows both");
    p = plane(p.x(), p.y());
    reach = std::max(reach, p.norm());
  });
  constexpr double kMillimeterPerKilometer = 1e-6;
  const double stretch = AzimuthalPlane::stretch(reach);
  const std::string exactness = rounded_text(std::max(0.001, stretch / kMillimeterPerKilometer)) + " mm a kilometer";
  map_.notes.push_back("projected around longitude " + shortest_text(middle.x()) + ", latitude " +
                       shortest_text(middle.y()) + " (azimuthal equidistant on WGS 84): lengths within " + exactness);
  if (stretch > kMillimeterPerKilometer)
    warn("", "the map reaches " + rounded_text(1e-3 * reach) + " km from its middle, where lengths are up to " +
                 exactness + " too long in the plane; cut it to 15 km for 1 mm a kilometer");
}

}  // namespace arcway::internal::detail
