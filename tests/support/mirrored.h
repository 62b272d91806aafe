#pragma once

#include <utility>
#include <vector>

#include "arcway/path.h"
#include "arcway/polygon.h"
#include "arcway/vehicle.h"

namespace arcway::internal::test {

/// \file
/// Mirror images on the x axis, exact to the last bit. Left and right change places.

inline Vec2 mirrored(const Vec2& p) { return {p.x(), -p.y()}; }
inline Pose mirrored(const Pose& pose) { return {pose.x, -pose.y, -pose.heading}; }
inline Footprint mirrored(const Footprint& body) { return {body.front, body.rear, body.right, body.left}; }
inline Ring mirrored(Ring ring) {
  for (Vec2& p : ring) p = mirrored(p);
  return ring;
}
inline Polygon mirrored(Polygon polygon) {
  polygon.outer = mirrored(std::move(polygon.outer));
  for (Ring& hole : polygon.holes) hole = mirrored(std::move(hole));
  return polygon;
}
inline std::vector<Polygon> mirrored(std::vector<Polygon> polygons) {
  for (Polygon& polygon : polygons) polygon = mirrored(std::move(polygon));
  return polygons;
}

}  // namespace arcway::internal::test
