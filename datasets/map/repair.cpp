#include "arcway/datasets/repair.h"

#include <stdexcept>

#ifdef ARCWAY_WITH_GEOS
#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arcway/datasets/doctor.h"
#include "arcway/polygon.h"
#include "core/geometry/predicates.h"
#endif

namespace arcway {

using namespace internal;

#ifndef ARCWAY_WITH_GEOS

bool can_repair() { return false; }

MapFile repaired(const MapFile&) { throw std::runtime_error("repair needs GEOS, and this was built without it"); }
std::vector<Polygon> united(const std::vector<Polygon>&) {
  throw std::runtime_error("the union of polygons needs GEOS, and this was built without it");
}

#else

namespace {

// GEOS's C interface with ownership and errors.
class Geos {
 public:
  using Geometry = std::unique_ptr<GEOSGeometry, std::function<void(GEOSGeometry*)> >;

  Geos() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(
        handle_, [](const char* message, void* self) { static_cast<Geos*>(self)->error_ = message; }, this);
  }
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  // Valid polygons that cover what the rings wind round.
  Geometry valid_region(const Polygon& polygon) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes)
      if (hole.size() >= 3) holes.push_back(linear_ring(hole));
    Geometry geometry = own(GEOSGeom_createPolygon_r(handle_, linear_ring(polygon.outer), holes.data(),
                                                     static_cast<unsigned>(holes.size())));
    return own(GEOSMakeValid_r(handle_, geometry.get()));
  }
  // Union of everything that has area; on a grid if its size is above 0.
  Geometry united(std::vector<Geometry> parts, double grid) {
    std::vector<GEOSGeometry*> released;
    for (Geometry& part : parts) released.push_back(part.release());
    const Geometry all = own(GEOSGeom_createCollection_r(handle_, GEOS_GEOMETRYCOLLECTION, released.data(),
                                                         static_cast<unsigned>(released.size())));
    return own(grid > 0.0 ? GEOSUnaryUnionPrec_r(handle_, all.get(), grid) : GEOSUnaryUnion_r(handle_, all.get()));
  }
  std::vector<Polygon> polygons(const GEOSGeometry* geometry) {
    std::vector<Polygon> result;
    append_polygons(geometry, result);
    return result;
  }

 private:
  Geometry own(GEOSGeometry* geometry) {
    if (geometry == nullptr) throw std::runtime_error("repair: GEOS failed: " + error_);
    return {geometry, [handle = handle_](GEOSGeometry* g) { GEOSGeom_destroy_r(handle, g); }};
  }
  GEOSGeometry* linear_ring(const Ring& ring) {
    GEOSCoordSequence* positions = GEOSCoordSeq_create_r(handle_, static_cast<unsigned>(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2& p = ring[i < ring.size() ? i : 0];
      GEOSCoordSeq_setXY_r(handle_, positions, static_cast<unsigned>(i), p.x(), p.y());
    }
    return own(GEOSGeom_createLinearRing_r(handle_, positions)).release();
  }
  Ring ring_of(const GEOSGeometry* geometry) {
    const GEOSCoordSequence* positions = GEOSGeom_getCoordSeq_r(handle_, geometry);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(handle_, positions, &size);
    Ring ring;
    for (unsigned i = 0; i + 1 < size; ++i) {
      Vec2& p = ring.emplace_back();
      GEOSCoordSeq_getXY_r(handle_, positions, i, &p.x(), &p.y());
    }
    return ring;
  }
  void append_polygons(const GEOSGeometry* geometry, std::vector<Polygon>& result) {
    if (GEOSGeomTypeId_r(handle_, geometry) != GEOS_POLYGON) {
      const int parts = GEOSGetNumGeometries_r(handle_, geometry);
      if (parts > 1 || GEOSGeomTypeId_r(handle_, geometry) > GEOS_POLYGON)
        for (int i = 0; i < parts; ++i) append_polygons(GEOSGetGeometryN_r(handle_, geometry, i), result);
      return;  // points and lines have no area
    }
    if (GEOSisEmpty_r(handle_, geometry) != 0) return;
    Polygon polygon{ring_of(GEOSGetExteriorRing_r(handle_, geometry)), {}};
    for (int i = 0; i < GEOSGetNumInteriorRings_r(handle_, geometry); ++i)
      polygon.holes.push_back(ring_of(GEOSGetInteriorRingN_r(handle_, geometry, i)));
    result.push_back(std::move(polygon));
  }

  GEOSContextHandle_t handle_;
  std::string error_ = "no reason given";
};

void drop_collinear(Ring& ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    const Vec2 &before = ring[i == 0 ? ring.size() - 1 : i - 1], &after = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (before != after && on_segment(ring[i], {before, after})) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

double area_of(const Polygon& polygon) { return std::abs(signed_area(polygon.outer)); }

// Whether World takes it.
bool is_ring(const Ring& ring) { return ring.size() >= 3 && winding(ring) != 0 && !find_conflict({ring, {}}); }

MapFile united(const MapFile& map, double grid) {
  Geos geos;
  MapFile result = map;
  result.obstacles.clear();
  result.bounds.reset();
  result.curves.clear();
  result.places.clear();
  result.bounds_place.clear();
  std::vector<Geos::Geometry> parts;
  const auto add = [&](const Polygon& polygon) {
    if (polygon.outer.size() >= 3) parts.push_back(geos.valid_region(polygon));
  };
  for (const Polygon& polygon : map.obstacles) add(polygon);
  if (map.bounds && is_ring(*map.bounds)) {
    result.bounds = map.bounds;  // in one piece, even if that touches itself
    drop_collinear(*result.bounds);
  } else if (map.bounds && map.bounds->size() >= 3) {
    std::vector<Polygon> regions = geos.polygons(geos.valid_region({*map.bounds, {}}).get());
    if (!regions.empty()) {
      Polygon& largest = *std::ranges::max_element(regions, {}, area_of);
      result.bounds = std::move(largest.outer);
      for (Ring& hole : largest.holes) add({std::move(hole), {}});
    }
  }
  result.obstacles = geos.polygons(geos.united(std::move(parts), grid).get());
  for (Polygon& polygon : result.obstacles) {
    drop_collinear(polygon.outer);
    for (Ring& hole : polygon.holes) drop_collinear(hole);
  }
  return without_repetitions(std::move(result));
}

}  // namespace

bool can_repair() { return true; }

std::vector<Polygon> united(const std::vector<Polygon>& polygons) {
  Geos geos;
  std::vector<Geos::Geometry> parts;
  for (const Polygon& polygon : polygons) parts.push_back(geos.valid_region(polygon));
  std::vector<Polygon> result = geos.polygons(geos.united(std::move(parts), 0.0).get());
  for (Polygon& polygon : result) {
    drop_collinear(polygon.outer);
    for (Ring& hole : polygon.holes) drop_collinear(hole);
  }
  return result;
}

MapFile repaired(const MapFile& map) {
  const MapFile clean = without_repetitions(map);
  for (const Finding& finding : examine(clean).findings) {
    if (finding.kind == FindingKind::kOutOfRange)
      throw std::invalid_argument("repair: " + finding.place + ": out of range " + finding.what);
  }
  const auto united_on = [&](double grid) {
    MapFile result = united(clean, grid);
    result.zones = clean.zones;
    result.zone_places = clean.zone_places;
    return result;
  };
  MapFile result = united_on(0.0);
  if (examine(result).plans()) return result;
  Box box;
  for (const Polygon& polygon : clean.obstacles)
    for (const Vec2& p : polygon.outer) box.extend(p);
  return united_on(std::exp2(std::ceil(std::log2((box.max - box.min).maxCoeff())) - 30.0));
}

#endif

}  // namespace arcway
